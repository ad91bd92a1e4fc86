#include "preprocess/section/triangle_fates.hpp"

#include "preprocess/section/plane_height.hpp"

namespace edgeshade {
namespace {

/// The sides of a plane that points are on; a point in the plane is on both.
constexpr std::uint8_t above = 1, below = 2, both = above | below;

} // namespace

std::vector<TriangleFate> fatesOf(const Geometry& geometry, const std::vector<glm::dvec4>& planes) {
    std::vector<TriangleFate> fates(geometry.indices.size() / 3, TriangleFate::kept);
    std::vector<std::uint8_t> sides(geometry.positions.size());
    for (const glm::dvec4& plane : planes) {
        for (std::size_t v = 0; v < sides.size(); ++v) {
            const double height = heightOver(plane, geometry.positions[v]);
            sides[v] =
                static_cast<std::uint8_t>((height >= 0.0 ? above : 0) | (height > 0.0 ? 0 : below));
        }
        const std::uint32_t* corner = geometry.indices.data();
        for (TriangleFate& fate : fates) {
            const int met = sides[corner[0]] | sides[corner[1]] | sides[corner[2]];
            corner += 3;
            if (met == both)
                fate = TriangleFate::met;
            else if (met == below && fate == TriangleFate::kept)
                fate = TriangleFate::away;
        }
    }
    return fates;
}

} // namespace edgeshade
