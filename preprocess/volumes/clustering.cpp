#include "preprocess/volumes/clustering.hpp"

#include "preprocess/mesh/components.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace edgeshade {
namespace {

/// What is known of a component before it is put into a cluster.
struct Part {
    Box bounds;
    bool closed = false;
    bool alphaTested = false;
    std::size_t triangles = 0;
    std::uint64_t place = 0; ///< on the Morton curve

    int kind() const { return closed ? 0 : alphaTested ? 2 : 1; }
};

/// Two zeros after each of the lowest 21 bits; there are no others.
std::uint64_t spread(std::uint64_t bits) {
    bits = (bits | bits << 32) & 0x001F00000000FFFFu;
    bits = (bits | bits << 16) & 0x001F0000FF0000FFu;
    bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
    bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
    return (bits | bits << 2) & 0x1249249249249249u;
}

std::uint64_t mortonCode(const glm::dvec3& point, const Box& all) {
    std::uint64_t code = 0;
    for (glm::length_t axis = 0; axis < 3; ++axis) {
        const double extent = all.high[axis] - all.low[axis];
        const double at = extent > 0.0 ? (point[axis] - all.low[axis]) / extent : 0.0;
        code |= spread(static_cast<std::uint64_t>(std::clamp(at, 0.0, 1.0) * 0x1FFFFF)) << axis;
    }
    return code;
}

std::vector<Part> partsOf(const CasterMesh& mesh, const Components& components,
                          const std::vector<Material>& materials) {
    std::vector<Part> parts(components.count());
    Box all;
    for (const MaterialCasters& group : mesh.groups) {
        const bool tested = materials[group.material].alphaMode != AlphaMode::opaque;
        for (std::uint32_t t = group.firstCap; t < group.firstCap + group.capCount; ++t) {
            Part& part = parts[components.ofTriangle[t]];
            part.alphaTested = part.alphaTested || tested;
            ++part.triangles;
            for (const std::uint32_t vertex : mesh.welded.triangles[t])
                part.bounds.add(glm::dvec3(mesh.welded.positions[vertex]));
        }
    }
    for (const Part& part : parts) {
        all.add(part.bounds.low);
        all.add(part.bounds.high);
    }
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].closed = components.closed[i] && !parts[i].alphaTested;
        parts[i].place = mortonCode(parts[i].bounds.center(), all);
    }
    return parts;
}

Box boxOf(const WeldedMesh& mesh, const Triangle& triangle) {
    Box box;
    for (const std::uint32_t vertex : triangle)
        box.add(glm::dvec3(mesh.positions[vertex]));
    return box;
}

void sortAlongCurve(TriangleCluster& cluster, const WeldedMesh& mesh) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(cluster.triangles.size());
    for (const std::uint32_t t : cluster.triangles)
        order.emplace_back(mortonCode(boxOf(mesh, mesh.triangles[t]).center(), cluster.bounds), t);
    std::sort(order.begin(), order.end());
    for (std::size_t i = 0; i < order.size(); ++i)
        cluster.triangles[i] = order[i].second;
}

/// By triangle: whether its material is seen from its front alone.
std::vector<std::uint8_t> singleSidedOf(const CasterMesh& mesh,
                                        const std::vector<Material>& materials) {
    std::vector<std::uint8_t> singleSided(mesh.welded.triangles.size(), 0);
    for (const MaterialCasters& group : mesh.groups)
        std::fill_n(singleSided.begin() + group.firstCap, group.capCount,
                    !materials[group.material].doubleSided);
    return singleSided;
}

void putSingleSidedFirst(TriangleCluster& cluster, const std::vector<std::uint8_t>& singleSided) {
    const auto others = std::stable_partition(cluster.triangles.begin(), cluster.triangles.end(),
                                              [&](std::uint32_t t) { return singleSided[t] != 0; });
    cluster.singleSided = static_cast<std::uint32_t>(others - cluster.triangles.begin());
}

std::vector<Box> leavesOf(const TriangleCluster& cluster, const WeldedMesh& mesh) {
    std::vector<Box> leaves;
    for (std::size_t i = 0; i < cluster.triangles.size(); ++i) {
        if (i % leafTriangles == 0) leaves.emplace_back();
        const Box box = boxOf(mesh, mesh.triangles[cluster.triangles[i]]);
        leaves.back().add(box.low);
        leaves.back().add(box.high);
    }
    return leaves;
}

/// Gives the clusters their triangles' edges, in linear time.
void addEdges(const EdgeList& edges, std::vector<TriangleCluster>& clusters) {
    const auto firstTriangle = [&](std::uint32_t edge) {
        return edges.opposites[edges.edges[edge].firstOpposite].triangle;
    };
    std::size_t triangles = 0;
    for (const TriangleCluster& cluster : clusters)
        triangles += cluster.triangles.size();
    std::vector<std::uint32_t> firstOf(triangles + 1, 0); // by triangle + 1, then summed up
    for (std::uint32_t e = 0; e < edges.edges.size(); ++e)
        ++firstOf[firstTriangle(e) + 1];
    std::partial_sum(firstOf.begin(), firstOf.end(), firstOf.begin());
    std::vector<std::uint32_t> next(firstOf.begin(), firstOf.end() - 1);
    std::vector<std::uint32_t> byTriangle(edges.edges.size());
    for (std::uint32_t e = 0; e < edges.edges.size(); ++e)
        byTriangle[next[firstTriangle(e)]++] = e;
    for (TriangleCluster& cluster : clusters)
        for (const std::uint32_t t : cluster.triangles)
            cluster.edges.insert(cluster.edges.end(), byTriangle.begin() + firstOf[t],
                                 byTriangle.begin() + firstOf[t + 1]);
}

} // namespace

std::vector<TriangleCluster> clusterTrianglesOf(const CasterMesh& mesh, const EdgeList& edges,
                                                const std::vector<Material>& materials) {
    const Components components = findComponents(mesh.welded, edges);
    const std::vector<Part> parts = partsOf(mesh, components, materials);
    std::vector<std::uint32_t> order(parts.size());
    for (std::uint32_t i = 0; i < order.size(); ++i)
        order[i] = i;
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::make_tuple(parts[a].kind(), parts[a].place, a) <
               std::make_tuple(parts[b].kind(), parts[b].place, b);
    });

    std::vector<TriangleCluster> clusters;
    std::vector<std::size_t> sizes;
    std::vector<std::uint32_t> clusterOf(parts.size());
    int kind = -1;
    for (const std::uint32_t i : order) {
        const Part& part = parts[i];
        if (part.kind() != kind || sizes.back() + part.triangles > clusterTriangles) {
            clusters.push_back({{}, part.closed, part.alphaTested, 0, 0, {}, {}, {}});
            sizes.push_back(0);
            kind = part.kind();
        }
        sizes.back() += part.triangles;
        ++clusters.back().components;
        clusters.back().bounds.add(part.bounds.low);
        clusters.back().bounds.add(part.bounds.high);
        clusterOf[i] = static_cast<std::uint32_t>(clusters.size() - 1);
    }
    for (std::uint32_t t = 0; t < components.ofTriangle.size(); ++t)
        clusters[clusterOf[components.ofTriangle[t]]].triangles.push_back(t);
    const std::vector<std::uint8_t> singleSided = singleSidedOf(mesh, materials);
    for (TriangleCluster& cluster : clusters) {
        if (!cluster.alphaTested) sortAlongCurve(cluster, mesh.welded);
        putSingleSidedFirst(cluster, singleSided);
        cluster.leaves = leavesOf(cluster, mesh.welded);
    }
    addEdges(edges, clusters);
    return clusters;
}

} // namespace edgeshade
