#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade::rays {

/// A triangle's corners, finite.
using Corners = std::array<glm::dvec3, 3>;

/// A point whose light is asked for, given without rounding: where the line from `origin` along
/// `direction` meets the plane of its triangle. For a picture that is the line of sight; for a
/// sensor at a position it is the line against the normal. So `direction` also says from which side
/// the surface is looked at, and the point lies in the plane exactly, which few doubles do.
///
/// The point is `origin` itself if it has no triangle, if `direction` is 0, or if the line is
/// parallel to the plane.
struct SurfacePoint {
    /// Value of `triangle` where there is none.
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0}; ///< any length
    std::uint32_t triangle = none;

    /// A sensor at a position on a triangle, or, with `none`, in free space. `normal`: of the side
    /// that it is on, any length; 0: on no side, so that a free sensor sees all directions.
    static SurfacePoint at(const glm::dvec3& position, const glm::dvec3& normal,
                           std::uint32_t triangle) {
        return {position, -normal, triangle};
    }
};

} // namespace edgeshade::rays
