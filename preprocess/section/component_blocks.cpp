#include "preprocess/section/component_blocks.hpp"

#include "preprocess/base/morton.hpp"
#include "preprocess/section/vertex_attributes.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace edgeshade {
namespace {

/// Triangles at which a block is full; a component is never divided.
constexpr std::size_t blockTriangles = 512;

/// A batch stays whole if one of its components has more of its triangles than this share, because
/// dividing it would leave nearly all of it in one block.
constexpr double largestShare = 0.9;

/// The block of each triangle, unless there is only one, and their number.
struct Blocks {
    std::vector<std::uint32_t> ofTriangle;
    std::uint32_t count = 0;
};

/// `topology`: of all triangles of the geometry.
Blocks blocksOf(const Geometry& geometry, const MeshTopology& topology) {
    const auto& [mesh, edges, components] = topology;
    Box all;
    std::vector<Box> boxes(components.count());
    std::vector<std::size_t> sizes(components.count(), 0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::uint32_t component = components.ofTriangle[t];
        ++sizes[component];
        for (const std::uint32_t corner : mesh.triangles[t]) {
            boxes[component].add(glm::dvec3(mesh.positions[corner]));
            all.add(glm::dvec3(mesh.positions[corner]));
        }
    }
    const auto largest = std::max_element(sizes.begin(), sizes.end());
    if (largest == sizes.end() ||
        static_cast<double>(*largest) > largestShare * static_cast<double>(mesh.triangles.size()))
        return {{}, 1};
    std::vector<std::uint32_t> order(components.count());
    std::iota(order.begin(), order.end(), 0u);
    std::vector<std::uint64_t> codes;
    for (const Box& box : boxes)
        codes.push_back(mortonCode(box.center(), all));
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return codes[a] < codes[b]; });

    std::vector<std::uint32_t> blockOf(components.count());
    std::uint32_t block = 0;
    std::size_t filled = 0;
    for (const std::uint32_t component : order) {
        if (filled > 0 && filled + sizes[component] > blockTriangles) {
            ++block;
            filled = 0;
        }
        blockOf[component] = block;
        filled += sizes[component];
    }
    // Triangles without area are in no component.
    Blocks blocks{std::vector<std::uint32_t>(geometry.indices.size() / 3, block), block + 1};
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        blocks.ofTriangle[mesh.source[t]] = blockOf[components.ofTriangle[t]];
    return blocks;
}

/// Collects the triangles of a block, with the vertices that they use.
class BlockWriter {
  public:
    explicit BlockWriter(const Geometry& from)
        : from_(from), vertexOf_(from.positions.size(), none) {}

    Geometry write(const std::vector<std::uint32_t>& triangles) {
        Geometry to;
        std::vector<std::uint32_t> used;
        auto group = from_.groups.begin();
        for (const std::uint32_t triangle : triangles) {
            while (3 * triangle >= group->firstIndex + group->indexCount)
                ++group;
            if (to.groups.empty() || to.groups.back().material != group->material)
                to.groups.push_back(
                    {group->material, static_cast<std::uint32_t>(to.indices.size()), 0});
            if (!from_.sources.empty()) addSource(to, nodeOf(from_, -1, 3 * triangle));
            for (std::size_t c = 0; c < 3; ++c)
                to.indices.push_back(vertex(from_.indices[3 * triangle + c], to, used));
            to.groups.back().indexCount += 3;
        }
        for (const std::uint32_t of : used)
            vertexOf_[of] = none;
        return to;
    }

  private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    std::uint32_t vertex(std::uint32_t of, Geometry& to, std::vector<std::uint32_t>& used) {
        if (vertexOf_[of] != none) return vertexOf_[of];
        vertexOf_[of] = static_cast<std::uint32_t>(to.positions.size());
        used.push_back(of);
        const auto addSome = [&](const auto& all, auto& some) {
            if (!all.empty()) some.push_back(all[of]);
        };
        forEachAttribute(addSome, from_, to);
        return vertexOf_[of];
    }

    const Geometry& from_;
    std::vector<std::uint32_t> vertexOf_; ///< in the block, by vertex of the geometry
};

} // namespace

SceneInBlocks inBlocks(const Scene& scene) {
    SceneInBlocks made{scene, {}};
    std::vector<Batch>& batches = made.scene.batches;
    batches.clear();
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    std::vector<std::size_t> uses(first.size(), 0);
    for (const std::size_t of : first)
        ++uses[of];
    for (std::size_t i = 0; i < first.size(); ++i) {
        const Batch& batch = scene.batches[i];
        const Geometry& geometry = *batch.geometry;
        if (uses[first[i]] > 1 || batch.ground || batch.deforms() || geometry.simplifiedCasters ||
            geometry.indices.size() / 3 < 2 * blockTriangles) {
            batches.push_back(batch);
            continue;
        }
        MeshTopology topology = topologyOf(geometry.positions, geometry.indices);
        const Blocks blocks = blocksOf(geometry, topology);
        if (blocks.count == 1) {
            batches.push_back(batch);
            made.topologies.emplace(&geometry, std::move(topology));
            continue;
        }
        std::vector<std::vector<std::uint32_t>> trianglesOf(blocks.count);
        for (std::uint32_t t = 0; t < blocks.ofTriangle.size(); ++t)
            trianglesOf[blocks.ofTriangle[t]].push_back(t);
        BlockWriter writer(geometry);
        for (const std::vector<std::uint32_t>& triangles : trianglesOf) {
            if (triangles.empty()) continue;
            Batch& block = batches.emplace_back(batch);
            block.geometry = CopyOnWrite<Geometry>(writer.write(triangles));
        }
    }
    return made;
}

} // namespace edgeshade
