#include "src/plot/color_scale.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace edgeshade::plot {
namespace {

/// Converts OKLab to linear sRGB, by its author's matrices.
glm::dvec3 linearFromOklab(const glm::dvec3& lab) {
    const glm::dvec3 roots(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z,
                           lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z,
                           lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z);
    const glm::dvec3 lms = roots * roots * roots;
    return {4.0767416621 * lms.x - 3.3077115913 * lms.y + 0.2309699292 * lms.z,
            -1.2684380046 * lms.x + 2.6097574011 * lms.y - 0.3413193965 * lms.z,
            -0.0041960863 * lms.x - 0.7034186147 * lms.y + 1.7076147010 * lms.z};
}

std::uint32_t byteOf(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double display = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint32_t>(std::lround(255.0 * display));
}

} // namespace

Color evenColor(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    const double lightness = 0.24 + 0.70 * t;
    // A little red half way, for those who can see it.
    const double greenToRed = -0.03 * t + 0.22 * t * (1.0 - t);
    const double blueToYellow = -0.11 + 0.26 * t;
    const glm::dvec3 rgb = linearFromOklab({lightness, greenToRed, blueToYellow});
    return byteOf(rgb.r) << 16 | byteOf(rgb.g) << 8 | byteOf(rgb.b);
}

} // namespace edgeshade::plot
