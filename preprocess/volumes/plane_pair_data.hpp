#pragma once

#include "preprocess/mesh/components.hpp"
#include "preprocess/mesh/topology.hpp"
#include "preprocess/scene/scene.hpp"

#include <array>
#include <memory>
#include <optional>

namespace edgeshade {

// What the layout `adapted` draws shadow volumes from (docs/method.md, C1 to C8): which kinds of
// edges there are, and why each is right.
//
// Every triangle T that counts adds a prism: front cap, back cap, three sides. T's side of the
// light is s(T), the sign of dot(plane, light) with T's plane as trianglePlanes() has it; what
// counts of it is w(T): s(T) itself, or only s = 1 (light-facing triangles), or only s = -1. An
// edge A < B is drawn |m| times, m the sum of d(T) w(T) over its triangles, d(T) = 1 where T runs
// from A to B and -1 where it runs from B to A. Since edges and caps ask the same four floats, what
// they emit is a closed chain whatever those floats are (docs/method.md, The closed chain).
//
// - PairRecord: two of an edge's triangles with d0 = 1 and d1 = -1, so m = w0 - w1. Triangles that
//   run the same way are paired too, one of them with its plane negated, which turns w into -w:
//   then all triangles must count. An edge of n triangles takes pairs of those that run opposite
//   ways as long as there are any, then of the rest: its multiplicity is the sum over its records.
// - SingleRecord: the triangle that is left over where n is odd, m = w, the plane negated if d =
// -1.
// - Nothing: a pair whose planes are equal bit for bit, as they are across the edges within a flat
//   patch. w0 - w1 is 0 for every light.
//
// With a flat tolerance such patches are nearly flat, and their plane is that of the one they grew
// from. Edges and caps of every triangle still ask the same four floats, so the chain is as closed
// as before: for that it is no matter which plane they ask. What gets wrong is s(T) of triangles
// that the light grazes at less than the tolerance, or less than their distance from the patch's
// plane: their prisms, whose cross-section is at most sin(tolerance) of the triangle's area, count
// with the other sign, and the silhouette runs along the patch's border instead of through it.
//
// Of what deforms every triangle has a plane of its own and no pair is dropped: what is flat in one
// pose is not in another. Where a pose puts the vertices, posedPlanePairs() has the same records
// ask the planes that the triangles have there.
//
// Components are sets of triangles connected through edges, so all records of an edge belong to
// one, and each component's chain is closed by itself. In a *closed* component every edge has as
// many triangles in one direction as in the other: there are nothing but pairs of opposite
// directions, winding numbers exist, and where docs/method.md, C8 allows it the light-facing
// triangles alone decide between lit and shadowed, at half the quads and half the caps. A component
// with MASK or BLEND triangles doesn't count as closed: the eye sees through it.

/// 56 bytes.
struct PairRecord {
    glm::vec3 a, b;
    glm::vec4 plane0, plane1;
};

/// 40 bytes.
struct SingleRecord {
    glm::vec3 a, b;
    glm::vec4 plane;
};

/// A triangle as it is wound; 52 bytes.
struct CapRecord {
    glm::vec3 a, b, c;
    glm::vec4 plane;
};
static_assert(sizeof(PairRecord) == 56 && sizeof(SingleRecord) == 40 && sizeof(CapRecord) == 52);

/// The cap that a pair's plane is of, and whether it is negated.
struct PlaneOf {
    std::uint32_t bits = 0; ///< 2 * cap + negated

    std::uint32_t cap() const { return bits >> 1; }
    bool negated() const { return (bits & 1u) != 0; }
};

/// Records [first, first + count).
struct RecordRange {
    std::uint32_t first = 0;
    std::uint32_t count = 0;

    std::uint32_t end() const { return first + count; }
};

/// Whole components that lie near each other: what a frame draws or leaves out, and how, is decided
/// cluster by cluster.
struct ShadowCluster {
    Box bounds;
    bool closed = false;      ///< every component of it
    bool alphaTested = false; ///< some casters are not opaque
    std::uint32_t components = 1;
    RecordRange pairs, singles, caps;
    std::uint32_t singleSided = 0; ///< how many of `caps`, which are the first, have no back to see
    RecordRange groups;            ///< of PlanePairShadow::groups
    RecordRange leaves; ///< of PlanePairShadow::leaves: each holds the next leafTriangles caps
};

/// Which vertices the records of a batch that deforms are between.
struct RecordVertices {
    std::vector<std::uint32_t> inBatch; ///< a vertex of the batch for each welded one
    std::vector<std::array<std::uint32_t, 2>> pairs, singles; ///< welded; a and b
    std::vector<PlaneOf> singlePlanes;
    std::vector<Triangle> caps; ///< welded
};

/// One batch.
struct PlanePairShadow {
    std::vector<PairRecord> pairs; ///< cluster after cluster, closed ones first; as singles, caps
    std::vector<std::array<PlaneOf, 2>> pairPlanes; ///< what PairRecord's planes are, by pair
    std::vector<SingleRecord> singles;
    std::vector<CapRecord> caps;
    std::vector<std::uint32_t> capTriangles; ///< which of CasterMesh's triangles each cap is
    std::vector<MaterialCasters> groups;     ///< ranges of caps; opaque clusters have one each
    std::vector<ShadowCluster> clusters;
    std::vector<Box> leaves;                             ///< boxes around neighbouring caps
    std::size_t edges = 0;                               ///< all, flat ones too
    std::size_t flatPairs = 0;                           ///< pairs that were dropped
    std::size_t flatEdges = 0;                           ///< edges of which nothing is left
    std::shared_ptr<const RecordVertices> vertices = {}; ///< null: the batch is rigid
    /// By cluster: what findSolids() says of it; nothing: nobody has asked yet.
    std::optional<std::vector<std::uint8_t>> solids = {};
};

/// What plane-pair records take; sums over batches with +=.
struct PlanePairCosts {
    std::size_t records = 0;
    std::size_t flatEdges = 0;
    std::size_t sideBytes = 0; ///< on the GPU, instanced
    std::size_t capBytes = 0;  ///< of all caps; they are uploaded when they are first drawn
    /// Vertices that the vertex shader runs for one point light when neither it nor the eye is
    /// within any cluster's bounds, and everything is in view.
    std::size_t sideRuns = 0;
    std::size_t capRuns = 0; ///< of all caps; volumes that the eye is outside of are drawn without

    PlanePairCosts& operator+=(const PlanePairCosts& other);
    /// What one place more costs of records that are there: vertices.
    PlanePairCosts runsAlone() const;
};
PlanePairCosts costsOf(const PlanePairShadow& shadow);

/// The costs of buildPlanePairs() with the same words, without making the records. `components`:
/// the mesh's. `deforms`: no pair is dropped.
PlanePairCosts planePairCosts(const CasterMesh& mesh, const EdgeList& edges,
                              const Components& components, const std::vector<Material>& materials,
                              double flatTolerance, bool deforms, Threads threads = {});

/// Builds the records of one batch. `materials` tell which casters are alpha-tested;
/// `flatTolerance`: degrees, see trianglePlanes().
PlanePairShadow buildPlanePairs(const CasterMesh& mesh, const EdgeList& edges,
                                const std::vector<Material>& materials, double flatTolerance = 0.0,
                                Threads threads = {});

/// Those of a batch: of what deforms, records that last for all poses (weldForRecords()), with
/// RecordVertices and without patches.
PlanePairShadow buildPlanePairs(const Batch& batch, const Casters& casters,
                                const std::vector<Material>& materials, double flatTolerance);

/// The records of a batch that deforms, as buildPlanePairs() made them, where its vertices are now.
/// Nothing but positions, planes and boxes differs.
PlanePairShadow posedPlanePairs(const PlanePairShadow& shadow, const Batch& batch);

/// The whole pipeline for every batch of a scene: weld, edges, records.
std::vector<std::shared_ptr<const PlanePairShadow>>
buildPlanePairs(const Scene& scene, bool castMasked, double flatTolerance = 0.0);

} // namespace edgeshade
