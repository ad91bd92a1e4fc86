#include "src/environment/resampling.hpp"

#include <vector>

namespace edgeshade {

OctahedralMap octahedralFromPanorama(const Panorama& panorama, int size) {
    OctahedralMap sums(size);
    std::vector<float> weights(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
    const auto weight = [&](int x, int y) -> float& {
        return weights[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                       static_cast<std::size_t>(x)];
    };
    for (int row = 0; row < panorama.height(); ++row) {
        const auto solidAngle = static_cast<float>(panorama.solidAngle(row));
        for (int column = 0; column < panorama.width(); ++column) {
            const glm::ivec2 texel = sums.texelAt(panorama.direction(column, row));
            sums.at(texel.x, texel.y) += solidAngle * panorama.at(column, row);
            weight(texel.x, texel.y) += solidAngle;
        }
    }
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            sums.at(x, y) = weight(x, y) > 0.0f ? sums.at(x, y) / weight(x, y)
                                                : panorama.lookUp(sums.direction(x, y));
    sums.closeBorder();
    return sums;
}

} // namespace edgeshade
