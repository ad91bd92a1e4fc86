#pragma once

#include "preprocess/volumes/plane_pair_data.hpp"
#include "src/shadow/geometry/separation.hpp"

#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// Where more triangles than these stand in a volume, counting them is not worth it.
inline constexpr std::size_t mostTouched = 512;

/// An edge, and the sign of a triangle on it.
struct EdgeSign {
    glm::vec3 a, b;
    int sign;
    std::uint64_t number; ///< the same for equal edges, and mostly another one for others
};

/// Caps of one cluster that may meet a volume: all that do, and few others.
struct Touched {
    std::vector<std::uint32_t> caps; ///< ascending
    bool tooMany = false;            ///< there may be more
    std::vector<EdgeSign> edges;     ///< evennessOf()'s, kept for their memory
};

/// Finds the caps that may meet the volume with these faces; reuses the memory of `touched`.
void findTouching(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                  const PlanePairShadow& shadow, Touched& touched, std::size_t limit = mostTouched);

/// Whether any cap may: separated as well as areApart() can.
bool anyCapTouches(const ClipVolumeFaces& faces, const ShadowCluster& cluster,
                   const PlanePairShadow& shadow);

/// How many triangles of a cluster a way to the light crosses, each by the sign that its plane has
/// (docs/method.md, C13): a prism that is turned inside out by its plane's sign counts -1.
struct RayCrossings {
    int lightFacing = 0; ///< what is counted of triangles with sign 1
    int facingAway = 0;  ///< with sign -1
    // By the corners, whatever the plane's sign is:
    int outwards = 0; ///< crossed from back to front on the way to the light
    int inwards = 0;  ///< from front to back

    int all() const { return lightFacing + facingAway; }
};

/// The crossings between a point of the volume's rectangle and its light. `touched`: the caps that
/// meet it. Nothing where rounding may decide: a light next to a triangle's plane, for instance.
/// `rounding`: of the shaders' dot products, dotRounding().
std::optional<RayCrossings> crossingsFromSomePoint(const NearClipVolume& volume,
                                                   std::span<const std::uint32_t> touched,
                                                   const PlanePairShadow& shadow, double rounding);

/// Whether the number of crossings between a rectangle and a light may differ from point to point.
enum class Evenness {
    even,         ///< it is the same
    rectangleMet, ///< a triangle may cross the rectangle itself
    outlineMet,   ///< a silhouette edge may cross the volume
    uncertain,    ///< rounding may decide
};

/// Whether the crossings are the same for every point of the rectangle: the volume's boundary, made
/// of the triangles and of silhouettes drawn out away from the light, doesn't meet it. A silhouette
/// that crosses the rectangle does so behind an edge that is within the volume; and with every
/// triangle on such an edge being touched as well, their signs alone tell which edges those are.
Evenness evennessOf(const ClipVolumeFaces& faces, Touched& touched, const PlanePairShadow& shadow,
                    double rounding);

} // namespace edgeshade
