#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/geometry/separation.hpp"

#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// Number of triangles in a volume beyond which counting them costs more than it saves.
inline constexpr std::size_t mostTouched = 512;

/// An edge, and the sign of one triangle on it.
struct EdgeSign {
    glm::vec3 a, b;
    int sign;
    std::uint64_t number; ///< the same for equal edges, and usually not for others
};

/// Caps of a cluster that may meet a volume: all that do, and few others.
struct Touched {
    std::vector<std::uint32_t> caps; ///< ascending
    bool tooMany = false;            ///< there may be more
    std::vector<EdgeSign> edges;     ///< evennessOf()'s, kept for their memory
};

/// Finds the caps that may meet the volume with these faces; reuses the memory of `touched`.
void findTouching(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                  const PlanePairShadow& shadow, Touched& touched, std::size_t limit = mostTouched);

/// Whether any cap may meet the volume, as precisely as areApart() can separate them.
bool anyCapTouches(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                   const PlanePairShadow& shadow);

/// Triangles of a cluster that a segment to the light crosses, each counted with the sign of its
/// plane (docs/method.md, C13): a prism that its plane's sign turns inside out counts -1.
struct RayCrossings {
    int lightFacing = 0; ///< count of triangles with sign 1
    int facingAway = 0;  ///< count of triangles with sign -1
    // Counted by the corners' winding, whatever the plane's sign:
    int outwards = 0; ///< crossed from back to front on the way to the light
    int inwards = 0;  ///< crossed from front to back

    int all() const { return lightFacing + facingAway; }
};

/// The crossings between some point of the volume's rectangle and its light. `touched`: the caps
/// that meet the volume. Null if rounding may decide, for example if the light is close to a
/// triangle's plane. `rounding`: error of the shaders' dot products, dotRounding().
std::optional<RayCrossings> crossingsFromSomePoint(const NearClipVolume& volume,
                                                   std::span<const std::uint32_t> touched,
                                                   const PlanePairShadow& shadow, double rounding);

/// Whether the number of crossings between a rectangle and a light is the same at every point.
enum class Evenness {
    even,         ///< it is the same
    rectangleMet, ///< a triangle may cross the rectangle itself
    outlineMet,   ///< a silhouette edge may cross the volume
    uncertain,    ///< rounding may decide
};

/// Tests whether the crossings are the same for every point of the rectangle. They are if the
/// boundary of the shadow volume, made of the triangles and of silhouettes extruded away from the
/// light, does not meet the rectangle. A silhouette whose extrusion crosses the rectangle has a
/// part within the volume. All triangles on such an edge are touched too, so the signs of touched
/// triangles suffice to find these edges.
Evenness evennessOf(const ClipVolumeFaces& faces, Touched& touched, const PlanePairShadow& shadow,
                    double rounding);

} // namespace edgeshade
