#pragma once

#include "preprocess/mesh/topology.hpp"
#include "preprocess/scene/scene.hpp"

#include <array>
#include <limits>
#include <memory>
#include <optional>

namespace edgeshade {

// The records of the layout `adapted`, from which shadow volumes are drawn (docs/method.md, C1 to
// C8): the kinds of edges, and why each is right.
//
// Every triangle T that counts adds a prism: front cap, back cap, three sides. Its side of the
// light s(T) is the sign of dot(plane, light) with T's plane from trianglePlanes(). Its weight w(T)
// is s(T) itself, or counts only s = 1 (light-facing triangles), or only s = -1. An edge A < B is
// drawn |m| times. Its multiplicity m is the sum of d(T) w(T) over its triangles, where d(T) is 1
// if T runs from A to B and -1 if it runs from B to A. Edges and caps evaluate the same four
// floats. The result is therefore a closed chain whatever those floats are (docs/method.md, The
// closed chain).
//
// - PairRecord: two of an edge's triangles with d0 = 1 and d1 = -1, so m = w0 - w1. Triangles that
//   run the same way are paired too, one of them with its plane negated, which turns w into -w:
//   then all triangles must count. An edge of n triangles first pairs triangles that run in
//   opposite directions, then the rest. Its multiplicity is the sum over its records.
// - SingleRecord: the triangle left over if n is odd, m = w, with its plane negated if d = -1.
// - No record: a pair whose planes are equal bit for bit, as across the edges within a flat patch.
//   w0 - w1 is 0 for every light.
//
// With a flat tolerance the patches are nearly flat, and use the plane of the patch they grew from.
// Edges and caps of every triangle still evaluate the same four floats, so the chain is as closed
// as before: it does not depend on which plane they use. The error is in s(T) of triangles that the
// light grazes at less than the tolerance, or less than their distance from the patch's plane.
// Their prisms, whose cross-section is at most sin(tolerance) of the triangle's area, count with
// the other sign. The silhouette runs along the patch's border instead of through it.
//
// In a deforming batch every triangle has its own plane and no pair is dropped: triangles that are
// coplanar in one pose are not in another. For a new pose, posedPlanePairs() gives the same records
// the planes that the triangles have there.
//
// Components are sets of triangles connected through edges. All records of an edge therefore belong
// to one component, and each component's chain is closed by itself. In a *closed* component every
// edge has as many triangles in one direction as in the other. It has only pairs of opposite
// directions, and winding numbers exist. Where docs/method.md, C8 allows it, the light-facing
// triangles alone decide between lit and shadowed, at half the quads and half the caps. A component
// with MASK or BLEND triangles doesn't count as closed, since the eye sees through it.

/// An edge with two triangles; 56 bytes.
struct PairRecord {
    glm::vec3 a, b;
    glm::vec4 plane0, plane1;
};

/// An edge with one triangle; 40 bytes.
struct SingleRecord {
    glm::vec3 a, b;
    glm::vec4 plane;
};

/// A triangle in its own winding; 52 bytes.
struct CapRecord {
    glm::vec3 a, b, c;
    glm::vec4 plane;

    /// False if the plane is zero: every light lies in it.
    bool casts() const { return plane != glm::vec4(0.0f); }
};
static_assert(sizeof(PairRecord) == 56 && sizeof(SingleRecord) == 40 && sizeof(CapRecord) == 52);

/// The cap that a record's plane comes from, and whether it is negated.
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

/// Whole components near each other. A frame decides for each cluster whether and how it is drawn.
struct ShadowCluster {
    Box bounds;
    bool closed = false;      ///< every component is closed
    bool alphaTested = false; ///< some casters are not opaque
    static constexpr std::uint32_t uncounted = std::numeric_limits<std::uint32_t>::max();
    std::uint32_t components = 1; ///< or `uncounted`, perhaps one
    RecordRange pairs, singles, caps;
    std::uint32_t singleSided = 0; ///< the first of `caps` that are single-sided
    RecordRange groups;            ///< in PlanePairShadow::groups
    RecordRange leaves; ///< in PlanePairShadow::leaves: each holds the next leafTriangles caps
};

/// The vertices of a deforming batch's records.
struct RecordVertices {
    std::vector<std::uint32_t> inBatch; ///< a vertex of the batch for each welded vertex
    std::vector<std::array<std::uint32_t, 2>> pairs, singles; ///< a and b, as welded vertices
    std::vector<Triangle> caps;                               ///< welded vertices
};

/// The records of one batch.
struct PlanePairShadow {
    std::vector<PairRecord> pairs; ///< cluster by cluster, closed ones first; so are singles and
                                   ///< caps
    std::vector<std::array<PlaneOf, 2>> pairPlanes; ///< origin of the planes, for each pair
    std::vector<SingleRecord> singles;
    std::vector<PlaneOf> singlePlanes; ///< origin of the plane, for each single
    std::vector<CapRecord> caps;
    std::vector<std::uint32_t> capTriangles; ///< the triangle of CasterMesh for each cap
    std::vector<MaterialCasters> groups;     ///< ranges of caps; one for each opaque cluster
    std::vector<ShadowCluster> clusters;
    std::vector<Box> leaves;                             ///< boxes around neighbouring caps
    std::size_t edges = 0;                               ///< of all edges, flat ones too
    std::size_t flatPairs = 0;                           ///< pairs dropped
    std::size_t flatEdges = 0;                           ///< edges without a record
    std::shared_ptr<const RecordVertices> vertices = {}; ///< null: the batch is rigid
    /// For each cluster, the result of findSolids(); null: not computed yet.
    std::optional<std::vector<std::uint8_t>> solids = {};
};

} // namespace edgeshade
