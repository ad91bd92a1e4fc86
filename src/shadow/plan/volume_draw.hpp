#pragma once

#include "src/shadow/plan/volume_plan.hpp"

#include <optional>

namespace edgeshade {

/// Vertices of a side's quad, and of one cap.
inline constexpr int verticesPerQuad = 4;
inline constexpr int verticesPerCap = 3;

/// How often a side counts: the absolute value of its multiplicity.
enum class Times { once = 1, twice = 2 };

/// The caps of a caster that are drawn.
enum class CapFaces { front, back, both };

/// An entry in the list of shadow volume draws. Code that draws it, counts its vertices or explains
/// it decides nothing further.
struct VolumeDraw {
    enum class Shape {
        sides,
        fans, ///< caps made of silhouette edges, each joined to the middle of the cluster's box
        caps, ///< caps made of triangles
        triangleVolumes, ///< each triangle's own volume: sides of multiplicity 1; for z-fail also
                         ///< the caps
        negativeSides,   ///< its sides of multiplicity -1, not reversed, but counted the other way
        nearCaps,        ///< triangles projected from the light onto the near plane (ZP+)
    };
    /// The records that the vertex shader gets.
    enum class Records {
        singles,
        allPairs,
        certainPairs,    ///< SilhouetteList::certain
        uncertainPairs,  ///< SilhouetteList::uncertain
        caps,            ///< all caps of a cluster
        lightFacingCaps, ///< the caps of a cluster that may face the light
        oppositeVertexSides,
        oppositeVertexCaps,
        triangles, ///< each triangle by itself
    };

    std::size_t batch = 0;  ///< index in CountPlan::batches
    std::size_t choice = 0; ///< index in VolumePlan::drawn, which gives the reason; plane-pair
                            ///< records only
    Shape shape = Shape::sides;
    Records records = Records::singles;
    RecordRange range;         ///< range in these records
    int verticesPerRecord = 0; ///< vertices that a record runs, over all its faces
    std::uint32_t cluster = 0; ///< cluster of these fans or caps; plane-pair records only
    Counted counted = Counted::all;
    Times times = Times::once;
    bool zFail = false;              ///< counted behind surfaces (z-fail) instead of before them
                                     ///< (z-pass)
    glm::vec4 end{0, 0, 0, 1};       ///< sides only: the plane where they end; (0, 0, 0, 1):
                                     ///< infinity
    CapFaces faces = CapFaces::both; ///< fans and caps only
    bool nearDiscard = false;        ///< caps only: discard them where the near plane cuts casters
    /// Caps only: the material whose texture decides where alpha-tested casters have holes. Their
    /// front caps are drawn twice: at infinity where solid, and in place where cut out.
    std::optional<std::size_t> alphaTested;
    bool cutoutsAlone = false; ///< alpha-tested caps only: draw only front caps in the cutouts
    /// Caps only: front caps of casters that show their backs, in place and counted before surfaces
    /// (z-pass); if alpha-tested, where they are solid.
    bool culled = false;

    bool isPair() const { return shape != Shape::caps && records != Records::singles; }
    /// Whether sides are triangles: under a directional light, sides to infinity end in one point.
    bool isTriangle() const { return verticesPerRecord == 3; }
    std::size_t vertexRuns() const {
        return range.count * static_cast<std::size_t>(verticesPerRecord);
    }
};

} // namespace edgeshade
