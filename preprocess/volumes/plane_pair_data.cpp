#include "preprocess/volumes/plane_pair_data.hpp"

#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/opposite_pairs.hpp"
#include "preprocess/volumes/triangle_planes.hpp"

#include <algorithm>
#include <iterator>

namespace edgeshade {
namespace {

/// Puts records in the order of clusters.
class Emitter {
  public:
    Emitter(const CasterMesh& mesh, const EdgeList& edges, const std::vector<glm::vec4>& planes)
        : mesh_(mesh.welded), edges_(edges), planes_(planes), capOf_(planes.size()) {}

    void emitCap(std::uint32_t triangle, PlanePairShadow& shadow) {
        const Triangle& corners = mesh_.triangles[triangle];
        capOf_[triangle] = static_cast<std::uint32_t>(shadow.caps.size());
        shadow.caps.push_back({mesh_.positions[corners[0]], mesh_.positions[corners[1]],
                               mesh_.positions[corners[2]], planes_[triangle]});
        shadow.capTriangles.push_back(triangle);
    }

    /// The caps of the edge's triangles come first.

    void emitEdge(const Edge& edge, PlanePairShadow& shadow) {
        const glm::vec3 &a = mesh_.positions[edge.a], &b = mesh_.positions[edge.b];
        ++shadow.edges;
        const std::size_t before = shadow.pairs.size() + shadow.singles.size();
        pairUp(mesh_, edges_, edge, planes_, paired_);
        for (const OppositePair& pair : paired_) {
            const glm::vec4 plane = pair.first.planeIn(planes_);
            if (!pair.second) {
                shadow.singles.push_back({a, b, plane});
            } else if (const glm::vec4 other = pair.second->planeIn(planes_); plane == other) {
                ++shadow.flatPairs;
            } else {
                shadow.pairs.push_back({a, b, plane, other});
                shadow.pairPlanes.push_back({planeOf(pair.first), planeOf(*pair.second)});
            }
        }
        shadow.flatEdges += shadow.pairs.size() + shadow.singles.size() == before;
    }

  private:
    PlaneOf planeOf(const PairedTriangle& of) const {
        return {2 * capOf_[of.triangle] + (of.negated ? 1u : 0u)};
    }

    const WeldedMesh& mesh_;
    const EdgeList& edges_;
    const std::vector<glm::vec4>& planes_;
    std::vector<std::uint32_t> capOf_; ///< by triangle
    std::vector<OppositePair> paired_;
};

RecordRange rangeSince(std::size_t first, std::size_t end) {
    return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end - first)};
}

/// The caps of a cluster by material where that matters.
void addGroups(const CasterMesh& mesh, const TriangleCluster& cluster, std::uint32_t firstCap,
               std::vector<MaterialCasters>& groups) {
    if (!cluster.alphaTested) {
        const std::size_t anyMaterial = mesh.groups.front().material; // all of them are opaque
        groups.push_back(
            {anyMaterial, firstCap, static_cast<std::uint32_t>(cluster.triangles.size())});
        return;
    }
    const std::size_t firstGroup = groups.size();
    for (const std::uint32_t triangle : cluster.triangles) {
        const auto after = std::upper_bound(
            mesh.groups.begin(), mesh.groups.end(), triangle,
            [](std::uint32_t t, const MaterialCasters& group) { return t < group.firstCap; });
        const std::size_t material = std::prev(after)->material;
        if (groups.size() == firstGroup || groups.back().material != material)
            groups.push_back({material, firstCap, 0});
        ++groups.back().capCount;
        ++firstCap;
    }
}

} // namespace

PlanePairShadow buildPlanePairs(const CasterMesh& mesh, const EdgeList& edges,
                                const std::vector<Material>& materials, double flatTolerance) {
    const std::vector<glm::vec4> planes = trianglePlanes(mesh.welded, edges, flatTolerance);
    Emitter emitter(mesh, edges, planes);
    PlanePairShadow shadow;
    shadow.pairs.reserve(edges.edges.size());
    shadow.caps.reserve(mesh.welded.triangles.size());
    shadow.capTriangles.reserve(mesh.welded.triangles.size());
    for (const TriangleCluster& cluster : clusterTrianglesOf(mesh, edges, materials)) {
        const std::size_t pairs = shadow.pairs.size(), singles = shadow.singles.size(),
                          caps = shadow.caps.size(), groups = shadow.groups.size(),
                          leaves = shadow.leaves.size();
        shadow.leaves.insert(shadow.leaves.end(), cluster.leaves.begin(), cluster.leaves.end());
        for (const std::uint32_t triangle : cluster.triangles)
            emitter.emitCap(triangle, shadow);
        for (const std::uint32_t edge : cluster.edges)
            emitter.emitEdge(edges.edges[edge], shadow);
        addGroups(mesh, cluster, static_cast<std::uint32_t>(caps), shadow.groups);
        shadow.clusters.push_back(
            {cluster.bounds, cluster.closed, cluster.alphaTested, cluster.components,
             rangeSince(pairs, shadow.pairs.size()), rangeSince(singles, shadow.singles.size()),
             rangeSince(caps, shadow.caps.size()), cluster.singleSided,
             rangeSince(groups, shadow.groups.size()), rangeSince(leaves, shadow.leaves.size())});
    }
    return shadow;
}

PlanePairCosts& PlanePairCosts::operator+=(const PlanePairCosts& other) {
    records += other.records;
    flatEdges += other.flatEdges;
    sideBytes += other.sideBytes;
    capBytes += other.capBytes;
    sideRuns += other.sideRuns;
    capRuns += other.capRuns;
    return *this;
}

PlanePairCosts costsOf(const PlanePairShadow& shadow) {
    constexpr std::size_t quadVertices = 4, capPairVertices = 6;
    PlanePairCosts costs;
    costs.records = shadow.pairs.size() + shadow.singles.size();
    costs.flatEdges = shadow.flatEdges;
    costs.sideBytes =
        shadow.pairs.size() * sizeof(PairRecord) + shadow.singles.size() * sizeof(SingleRecord);
    costs.capBytes = shadow.caps.size() * sizeof(CapRecord);
    for (const ShadowCluster& cluster : shadow.clusters)
        costs.sideRuns +=
            quadVertices * ((cluster.closed ? 1 : 2) * cluster.pairs.count + cluster.singles.count);
    costs.capRuns = capPairVertices * shadow.caps.size();
    return costs;
}

std::vector<std::shared_ptr<const PlanePairShadow>>
buildPlanePairs(const Scene& scene, bool castMasked, double flatTolerance) {
    std::vector<std::shared_ptr<const PlanePairShadow>> shadows;
    for (const Batch& batch : scene.batches) {
        const CasterMesh mesh = weldCasters(batch, castersOf(batch, scene.materials, castMasked));
        shadows.push_back(std::make_shared<const PlanePairShadow>(
            buildPlanePairs(mesh, buildEdges(mesh.welded), scene.materials, flatTolerance)));
    }
    return shadows;
}

} // namespace edgeshade
