#include "src/environment/radiance_pyramid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace edgeshade {
namespace {

OctahedralMap halved(const OctahedralMap& map) {
    OctahedralMap half(map.size() / 2);
    for (int y = 0; y < half.size(); ++y)
        for (int x = 0; x < half.size(); ++x) {
            glm::vec3 sum(0.0f);
            float weights = 0.0f;
            for (const auto& [across, down] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
                const float weight = map.solidAngle(2 * x + across, 2 * y + down);
                sum += weight * map.at(2 * x + across, 2 * y + down);
                weights += weight;
            }
            half.at(x, y) = sum / weights;
        }
    half.closeBorder();
    return half;
}

} // namespace

RadiancePyramid::RadiancePyramid(OctahedralMap map) {
    const auto size = static_cast<float>(map.size());
    texelsPerSr_ = size * size / (4.0f * std::numbers::pi_v<float>);
    levels_.push_back(std::move(map));
    while (levels_.back().size() > 1)
        levels_.push_back(halved(levels_.back()));
}

glm::vec3 RadiancePyramid::lookUp(const glm::vec3& direction, float solidAngle) const {
    // Half the binary logarithm, rounded: a texel of one level covers four of the level before.
    const int level = std::ilogb(std::max(1.0f, 2.0f * solidAngle * texelsPerSr_)) / 2;
    const auto last = static_cast<int>(levels_.size()) - 1;
    return levels_[static_cast<std::size_t>(std::min(level, last))].lookUp(direction);
}

} // namespace edgeshade
