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
    /// `vertices`: filled in where the records are to last for all poses; no pair is dropped then.
    Emitter(const CasterMesh& mesh, const EdgeList& edges, const std::vector<glm::vec4>& planes,
            RecordVertices* vertices)
        : mesh_(mesh.welded), edges_(edges), planes_(planes), vertices_(vertices),
          capOf_(planes.size()) {}

    void emitCap(std::uint32_t triangle, PlanePairShadow& shadow) {
        const Triangle& corners = mesh_.triangles[triangle];
        capOf_[triangle] = static_cast<std::uint32_t>(shadow.caps.size());
        shadow.caps.push_back({mesh_.positions[corners[0]], mesh_.positions[corners[1]],
                               mesh_.positions[corners[2]], planes_[triangle]});
        shadow.capTriangles.push_back(triangle);
        if (vertices_) vertices_->caps.push_back(corners);
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
                if (vertices_) vertices_->singles.push_back({edge.a, edge.b});
                if (vertices_) vertices_->singlePlanes.push_back(planeOf(pair.first));
                continue;
            }
            const glm::vec4 other = pair.second->planeIn(planes_);
            if (plane == other && !vertices_) {
                ++shadow.flatPairs;
                continue;
            }
            shadow.pairs.push_back({a, b, plane, other});
            shadow.pairPlanes.push_back({planeOf(pair.first), planeOf(*pair.second)});
            if (vertices_) vertices_->pairs.push_back({edge.a, edge.b});
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
    RecordVertices* const vertices_;
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

PlanePairShadow recordsOf(const CasterMesh& mesh, const EdgeList& edges,
                          const std::vector<Material>& materials,
                          const std::vector<glm::vec4>& planes, RecordVertices* vertices) {
    Emitter emitter(mesh, edges, planes, vertices);
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

/// A vertex of the batch for each welded one.
std::vector<std::uint32_t> batchVertices(const CasterMesh& mesh, const Casters& casters) {
    std::vector<std::uint32_t> inBatch(mesh.welded.positions.size());
    for (std::size_t t = 0; t < mesh.welded.triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            inBatch[mesh.welded.triangles[t][c]] = casters.indices[3 * mesh.welded.source[t] + c];
    return inBatch;
}

/// Puts records where vertices are; asks each plane as the first pose did.
class Poser {
  public:
    Poser(const RecordVertices& vertices, const Batch& batch) : vertices_(vertices) {
        points_.reserve(vertices.inBatch.size());
        for (const std::uint32_t vertex : vertices.inBatch)
            points_.push_back(batch.geometry->positions[vertex]);
    }

    CapRecord cap(std::size_t i) const {
        const auto& [a, b, c] = vertices_.caps[i];
        return {points_[a], points_[b], points_[c],
                trianglePlane(points_[a], points_[b], points_[c])};
    }
    PairRecord pair(std::size_t i, const std::array<PlaneOf, 2>& planes,
                    const std::vector<CapRecord>& caps) const {
        const auto& [a, b] = vertices_.pairs[i];
        return {points_[a], points_[b], planeIn(caps, planes[0]), planeIn(caps, planes[1])};
    }
    SingleRecord single(std::size_t i, const std::vector<CapRecord>& caps) const {
        const auto& [a, b] = vertices_.singles[i];
        return {points_[a], points_[b], planeIn(caps, vertices_.singlePlanes[i])};
    }

  private:
    static glm::vec4 planeIn(const std::vector<CapRecord>& caps, PlaneOf of) {
        const glm::vec4& plane = caps[of.cap()].plane;
        return of.negated() ? -plane : plane;
    }

    const RecordVertices& vertices_;
    std::vector<glm::vec3> points_; ///< welded
};

/// The box of caps [first, end).
Box boxOf(const std::vector<CapRecord>& caps, std::size_t first, std::size_t end) {
    glm::vec3 low = caps[first].a, high = low;
    for (std::size_t i = first; i < end; ++i)
        for (const glm::vec3* corner : {&caps[i].a, &caps[i].b, &caps[i].c}) {
            low = glm::min(low, *corner);
            high = glm::max(high, *corner);
        }
    Box box;
    box.add(glm::dvec3(low));
    box.add(glm::dvec3(high));
    return box;
}

} // namespace

PlanePairShadow buildPlanePairs(const CasterMesh& mesh, const EdgeList& edges,
                                const std::vector<Material>& materials, double flatTolerance) {
    return recordsOf(mesh, edges, materials, trianglePlanes(mesh.welded, edges, flatTolerance),
                     nullptr);
}

PlanePairShadow buildPlanePairs(const Batch& batch, const Casters& casters,
                                const std::vector<Material>& materials, double flatTolerance) {
    const CasterMesh mesh = weldForRecords(batch, casters);
    const EdgeList edges = buildEdges(mesh.welded);
    if (!batch.deforms()) return buildPlanePairs(mesh, edges, materials, flatTolerance);
    std::vector<glm::vec4> planes;
    planes.reserve(mesh.welded.triangles.size());
    for (const Triangle& triangle : mesh.welded.triangles)
        planes.push_back(trianglePlane(mesh.welded.positions[triangle[0]],
                                       mesh.welded.positions[triangle[1]],
                                       mesh.welded.positions[triangle[2]]));
    RecordVertices vertices;
    vertices.inBatch = batchVertices(mesh, casters);
    PlanePairShadow shadow = recordsOf(mesh, edges, materials, planes, &vertices);
    shadow.vertices = std::make_shared<const RecordVertices>(std::move(vertices));
    return shadow;
}

PlanePairShadow posedPlanePairs(const PlanePairShadow& shadow, const Batch& batch) {
    PlanePairShadow posed = shadow;
    const Poser poser(*shadow.vertices, batch);
    for (std::size_t i = 0; i < posed.caps.size(); ++i)
        posed.caps[i] = poser.cap(i);
    for (std::size_t i = 0; i < posed.pairs.size(); ++i)
        posed.pairs[i] = poser.pair(i, posed.pairPlanes[i], posed.caps);
    for (std::size_t i = 0; i < posed.singles.size(); ++i)
        posed.singles[i] = poser.single(i, posed.caps);
    for (ShadowCluster& cluster : posed.clusters) {
        cluster.bounds = boxOf(posed.caps, cluster.caps.first, cluster.caps.end());
        for (std::uint32_t i = 0; i < cluster.leaves.count; ++i) {
            const std::uint32_t first = cluster.caps.first + i * leafTriangles;
            posed.leaves[cluster.leaves.first + i] =
                boxOf(posed.caps, first, std::min(first + leafTriangles, cluster.caps.end()));
        }
    }
    return posed;
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

PlanePairCosts PlanePairCosts::runsAlone() const {
    PlanePairCosts costs;
    costs.sideRuns = sideRuns;
    costs.capRuns = capRuns;
    return costs;
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
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) {
            shadows.push_back(shadows[first[i]]);
            continue;
        }
        const Batch& batch = scene.batches[i];
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        shadows.push_back(std::make_shared<const PlanePairShadow>(
            buildPlanePairs(batch, casters, scene.materials, flatTolerance)));
    }
    return shadows;
}

} // namespace edgeshade
