#pragma once

#include "src/shadow/plan/volume_plan.hpp"

#include <optional>

namespace edgeshade {

/// Vertices of a quad of sides, and of one cap.
inline constexpr int verticesPerQuad = 4;
inline constexpr int verticesPerCap = 3;

/// How often sides count: as the absolute value of their multiplicity says.
enum class Times { once = 1, twice = 2 };

/// Which of a caster's two caps.
enum class CapFaces { front, back, both };

/// One entry of the list of what is drawn of shadow volumes: nobody who draws it, counts its
/// vertices or explains it decides anything further.
struct VolumeDraw {
    enum class Shape {
        sides,
        fans, ///< caps of silhouette edges, each joined to the middle of the cluster's box
        caps, ///< of triangles
        triangleVolumes, ///< of each triangle's volume sides of multiplicity 1; of z-fail caps, too
        negativeSides,   ///< its sides of multiplicity -1, not turned, but counted the other way
        nearCaps,        ///< triangles projected by the light onto the near plane (ZP+)
    };
    /// What the vertex shader gets.
    enum class Records {
        singles,
        allPairs,
        certainPairs,    ///< of SilhouetteList::certain
        uncertainPairs,  ///< of SilhouetteList::uncertain
        caps,            ///< all of a cluster
        lightFacingCaps, ///< of a cluster, those that may face the light
        oppositeVertexSides,
        oppositeVertexCaps,
        triangles, ///< each by itself
    };

    std::size_t batch = 0;  ///< index in CountPlan::batches
    std::size_t choice = 0; ///< index in VolumePlan::drawn, which says why; of plane-pair records
    Shape shape = Shape::sides;
    Records records = Records::singles;
    RecordRange range;         ///< of these records
    int verticesPerRecord = 0; ///< vertices that a record runs, of all its faces
    std::uint32_t cluster = 0; ///< whose fans or caps these are; of plane-pair records
    Counted counted = Counted::all;
    Times times = Times::once;
    bool zFail = false;              ///< counted behind surfaces (z-fail), or before them (z-pass)
    glm::vec4 end{0, 0, 0, 1};       ///< of sides: the plane where they end; (0, 0, 0, 1): infinity
    CapFaces faces = CapFaces::both; ///< of fans and caps
    bool nearDiscard = false;        ///< of caps: cut where the near plane cuts casters
    /// Of caps: their material, whose texture tells where casters are alpha-tested. Front caps are
    /// drawn twice then, at infinity where they are solid, and in the cutouts where they are.
    std::optional<std::size_t> alphaTested;
    bool cutoutsAlone = false; ///< of these: in the cutouts alone, front caps
    /// Of caps: front caps of casters that show their backs, where they are, counted before
    /// surfaces (z-pass); of alpha-tested ones where they are solid.
    bool culled = false;

    bool isPair() const { return shape != Shape::caps && records != Records::singles; }
    /// Whether sides are triangles: those of a directional light end at infinity in one point.
    bool isTriangle() const { return verticesPerRecord == 3; }
    std::size_t vertexRuns() const {
        return range.count * static_cast<std::size_t>(verticesPerRecord);
    }
};

} // namespace edgeshade
