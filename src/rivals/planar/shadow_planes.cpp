#include "src/rivals/planar/shadow_planes.hpp"

#include "preprocess/base/stopwatch.hpp"
#include "src/scene/load.hpp"
#include "src/scene/surface_parts.hpp"

#include <map>

namespace edgeshade {
namespace {

/// Index lists, by chunk, of a plane's triangles in one batch.
std::map<std::size_t, std::vector<std::uint16_t>>
indicesByChunk(const Batch& batch, const std::vector<SurfacePart>& parts,
               std::span<const PlaneTriangle> triangles) {
    std::map<std::size_t, std::vector<std::uint16_t>> byChunk;
    std::size_t part = 0, firstOfPart = 0, seen = 0; // indices in the order of groups
    auto next = triangles.begin();
    for (const SurfaceGroup& group : batch.geometry->groups)
        for (std::uint32_t i = 0; i + 2 < group.indexCount; i += 3, seen += 3) {
            while (seen >= firstOfPart + parts[part].indices.size())
                firstOfPart += parts[part++].indices.size();
            if (next == triangles.end() || next->firstIndex != group.firstIndex + i) continue;
            ++next;
            const std::uint16_t* corners = &parts[part].indices[seen - firstOfPart];
            std::vector<std::uint16_t>& to = byChunk[part];
            to.insert(to.end(), corners, corners + 3);
        }
    return byChunk;
}

ShadowPlane uploaded(const SurfacePlane& found, const Scene& scene) {
    ShadowPlane plane{found.plane, found.tolerance, {}, {}};
    for (auto first = found.triangles.begin(); first != found.triangles.end();) {
        const auto last = std::find_if(first, found.triangles.end(), [&](const PlaneTriangle& of) {
            return of.batch != first->batch;
        });
        const Batch& batch = scene.batches[first->batch];
        const std::vector<SurfacePart> parts = surfacePartsOf(batch);
        for (const auto& [chunk, indices] : indicesByChunk(batch, parts, {first, last})) {
            plane.receivers.push_back(
                {first->batch, chunk,
                 gl::Buffer(gl::Buffer::Kind::indices, std::as_bytes(std::span(indices))),
                 static_cast<int>(indices.size())});
            for (const std::uint16_t index : indices)
                plane.bounds.add(glm::dvec3(
                    batch.worldFromBatch *
                    glm::dvec4(batch.geometry->positions[parts[chunk].vertices[index]], 1.0)));
        }
        first = last;
    }
    return plane;
}

} // namespace

ShadowPlanes::ShadowPlanes(const LoadedScene& loaded, std::size_t count) {
    Stopwatch watch;
    const std::vector<SurfacePlane> found = largestPlanes(loaded.scene, count);
    buildMs_ = 1e3 * watch.lap();
    for (const SurfacePlane& of : found) {
        planes_.push_back(uploaded(of, loaded.scene));
        share_ += of.share;
    }
}

std::size_t ShadowPlanes::bytes() const {
    std::size_t total = 0;
    for (const ShadowPlane& plane : planes_)
        for (const PlaneReceivers& of : plane.receivers)
            total += of.indices.size();
    return total;
}

} // namespace edgeshade
