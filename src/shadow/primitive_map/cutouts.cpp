#include "src/shadow/primitive_map/cutouts.hpp"

#include <algorithm>

namespace edgeshade {

PackedAlpha packedAlpha(std::span<const std::uint16_t> alpha) {
    auto texels = std::make_shared<std::vector<glm::vec4>>((alpha.size() + 7) / 8, glm::vec4(0.0f));
    for (std::size_t i = 0; i < alpha.size(); ++i) {
        const int value = std::min<int>(alpha[i], fullAlpha);
        (*texels)[i / 8][static_cast<glm::length_t>(i % 8 / 2)] +=
            static_cast<float>(i % 2 == 0 ? value : value * 4096);
    }
    return texels;
}

CutoutPlanes cutoutPlanesOf(const CutoutTriangle& triangle, const std::array<glm::dvec3, 3>& rays) {
    // dot(plane, rays[i]) = value i.
    const glm::dmat3 planeFromValues =
        glm::inverse(glm::transpose(glm::dmat3(rays[0], rays[1], rays[2])));
    const auto planeOf = [&](glm::length_t i) {
        return planeFromValues *
               glm::dvec3(triangle.corners[0][i], triangle.corners[1][i], triangle.corners[2][i]);
    };
    return {planeOf(0), planeOf(1), planeOf(2), triangle.material};
}

} // namespace edgeshade
