#include "preprocess/scene/scene.hpp"

#include <algorithm>
#include <map>

namespace edgeshade {

std::vector<std::size_t> firstOfGeometry(const std::vector<Batch>& batches) {
    std::map<const Geometry*, std::size_t> known;
    std::vector<std::size_t> first;
    first.reserve(batches.size());
    for (std::size_t i = 0; i < batches.size(); ++i)
        first.push_back(known.emplace(&*batches[i].geometry, i).first->second);
    return first;
}

int nodeOf(const Geometry& geometry, int placedBy, std::uint32_t index) {
    const std::vector<SourceNode>& sources = geometry.sources;
    const auto after = std::upper_bound(
        sources.begin(), sources.end(), index,
        [](std::uint32_t at, const SourceNode& source) { return at < source.firstIndex; });
    return after == sources.begin() ? placedBy : (after - 1)->node;
}

void addSource(Geometry& geometry, int node) {
    if (geometry.sources.empty() || geometry.sources.back().node != node)
        geometry.sources.push_back({static_cast<std::uint32_t>(geometry.indices.size()), node});
}

Box boundsOf(const Geometry& geometry) {
    Box box;
    for (const glm::vec3& position : geometry.positions)
        box.add(glm::dvec3(position));
    return box;
}

Box worldBounds(const Batch& batch) {
    Box box;
    for (const glm::vec3& position : batch.geometry->positions)
        box.add(glm::dvec3(batch.worldFromBatch * glm::dvec4(position, 1.0)));
    return box;
}

Box worldBounds(const Scene& scene) {
    Box box;
    for (const Batch& batch : scene.whole().batches)
        if (!batch.ground && !batch.hidden) box.add(worldBounds(batch));
    return box;
}

} // namespace edgeshade
