#include "preprocess/volumes/uncut_records.hpp"

#include "preprocess/volumes/clustering.hpp"
#include "preprocess/volumes/opposite_pairs.hpp"

#include <algorithm>

namespace edgeshade {
namespace {

/// The triangles of the geometry that cast, in the order of castersOf().
std::vector<std::uint32_t> castingTriangles(const Geometry& geometry,
                                            const std::vector<Material>& materials,
                                            bool castMasked) {
    std::vector<std::uint32_t> triangles;
    for (const SurfaceGroup& group : geometry.groups) {
        if (!materials[group.material].casts(castMasked)) continue;
        for (std::uint32_t i = 0; i < group.indexCount / 3; ++i)
            triangles.push_back(group.firstIndex / 3 + i);
    }
    return triangles;
}

/// Lists the caps of each edge and the edges of each cap. `capOf`: by triangle of the mesh.
void addEdges(const WeldedMesh& mesh, const EdgeList& edges,
              const std::vector<std::uint32_t>& capOf, UncutRecords& to) {
    to.edgesOf.resize(mesh.triangles.size());
    to.edgeCaps.reserve(edges.opposites.size());
    for (std::uint32_t e = 0; e < edges.edges.size(); ++e) {
        const Edge& edge = edges.edges[e];
        to.capsOfEdge.push_back({edge.firstOpposite, edge.oppositeCount});
        for (const Opposite& of : edges.oppositesOf(edge)) {
            const Triangle& corners = mesh.triangles[of.triangle];
            const auto opposite = static_cast<std::size_t>(
                std::find(corners.begin(), corners.end(), of.vertex) - corners.begin());
            to.edgesOf[capOf[of.triangle]][(opposite + 1) % 3] = e;
            to.edgeCaps.push_back(capOf[of.triangle]);
        }
    }
}

/// Counts the edges of each cap, and finds those without a record. `planes`: by triangle.
void countEdges(const EdgeList& edges, const std::vector<glm::vec4>& planes, UncutRecords& to) {
    to.flat.resize(edges.edges.size());
    to.edgesFrom.resize(to.edgesOf.size());
    to.flatFrom.resize(to.edgesOf.size());
    std::vector<OppositePair> paired;
    for (std::uint32_t e = 0; e < edges.edges.size(); ++e) {
        pairUp(edges, edges.edges[e], planes, paired);
        const bool flat = std::all_of(paired.begin(), paired.end(), [&](const OppositePair& two) {
            return two.second && two.first.planeIn(planes) == two.second->planeIn(planes);
        });
        const std::uint32_t first = to.capsOf(e).front();
        to.flat[e] = flat;
        ++to.edgesFrom[first];
        to.flatFrom[first] = static_cast<std::uint8_t>(to.flatFrom[first] + flat);
    }
}

/// An edge by its end points.
struct Ends {
    glm::vec3 a, b;
    std::uint32_t edge;
};

/// Finds the records of edges of more than two triangles.
void findCrowded(const WeldedMesh& mesh, const EdgeList& edges, UncutRecords& to) {
    std::vector<Ends> crowded; // sorted, as edges and positions are
    for (std::uint32_t e = 0; e < edges.edges.size(); ++e)
        if (const Edge& edge = edges.edges[e]; edge.oppositeCount > 2)
            crowded.push_back({mesh.positions[edge.a], mesh.positions[edge.b], e});
    if (crowded.empty()) return;
    const auto isBefore = [](const Ends& s, const Ends& t) {
        return s.a != t.a ? orderedBefore(s.a, t.a) : orderedBefore(s.b, t.b);
    };
    const auto recordsAt = [&](const glm::vec3& a, const glm::vec3& b) -> UncutRecords::OfEdge* {
        const Ends ends{a, b, 0};
        const auto found = std::lower_bound(crowded.begin(), crowded.end(), ends, isBefore);
        if (found == crowded.end() || isBefore(ends, *found)) return nullptr;
        return &to.crowded[found->edge];
    };
    const PlanePairShadow& shadow = *to.shadow;
    for (std::uint32_t i = 0; i < shadow.pairs.size(); ++i)
        if (auto* of = recordsAt(shadow.pairs[i].a, shadow.pairs[i].b)) of->pairs.push_back(i);
    for (std::uint32_t i = 0; i < shadow.singles.size(); ++i)
        if (auto* of = recordsAt(shadow.singles[i].a, shadow.singles[i].b))
            of->singles.push_back(i);
}

} // namespace

bool UncutRecords::canFollowCuts() const {
    std::array<std::uint32_t, 2> all{}, largest{}; // caps of open clusters, of closed ones
    for (const ShadowCluster& cluster : shadow->clusters) {
        if (cluster.alphaTested) return false;
        all[cluster.closed] += cluster.caps.count;
        largest[cluster.closed] = std::max(largest[cluster.closed], cluster.caps.count);
    }
    constexpr std::size_t mostMerged = 16 * clusterTriangles;
    return all[0] - largest[0] <= mostMerged && all[1] - largest[1] <= mostMerged;
}

UncutRecords uncutRecords(const Batch& batch, const std::vector<Material>& materials,
                          bool castMasked, std::shared_ptr<const PlanePairShadow> shadow,
                          std::optional<MeshTopology> topology) {
    const Casters casters = castersOf(batch, materials, castMasked);
    if (!topology || casters.indices != batch.geometry->indices)
        topology = topologyOf(batch.geometry->positions, casters.indices);
    const auto& [welded, edges, components] = *topology;
    UncutRecords made;
    if (!shadow)
        shadow = std::make_shared<const PlanePairShadow>(
            buildPlanePairs(inGroups(welded, casters), edges, materials));
    made.shadow = std::move(shadow);

    const std::vector<std::uint32_t> casting =
        castingTriangles(*batch.geometry, materials, castMasked);
    made.capOf.assign(batch.geometry->indices.size() / 3, UncutRecords::none);
    std::vector<std::uint32_t> capOf(made.shadow->caps.size()); // by triangle of the mesh
    std::vector<glm::vec4> planes(capOf.size());
    for (std::uint32_t cap = 0; cap < capOf.size(); ++cap) {
        const std::uint32_t triangle = made.shadow->capTriangles[cap];
        capOf[triangle] = cap;
        planes[triangle] = made.shadow->caps[cap].plane;
        const std::uint32_t caster = welded.source[triangle];
        made.capOf[casting[caster]] = cap;
        made.vertices.push_back({casters.indices[3 * caster], casters.indices[3 * caster + 1],
                                 casters.indices[3 * caster + 2]});
        made.componentOf.push_back(components.ofTriangle[triangle]);
    }
    made.closed = components.closed;
    addEdges(welded, edges, capOf, made);
    countEdges(edges, planes, made);
    findCrowded(welded, edges, made);
    return made;
}

} // namespace edgeshade
