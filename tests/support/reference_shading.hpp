#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>

namespace edgeshade::test {

/// glTF 2.0, appendix B, in double, directly from the specification's formulas: the reference for
/// material.frag.
struct ReferenceSurface {
    glm::dvec3 baseColor{1.0}; ///< linear
    double metallic = 0.0;
    double roughness = 1.0;
    glm::dvec3 reflectance{0.04}; ///< of the dielectric at normal incidence
    double coat = 0.0;
    double coatRoughness = 0.0;
    glm::dvec3 normal{0.0, 0.0, 1.0};
};

/// Light that the surface sends to the eye from a light whose irradiance at normal incidence is pi.
inline glm::dvec3 reflectedLight(const ReferenceSurface& of, const glm::dvec3& toLight,
                                 const glm::dvec3& toEye) {
    constexpr double pi = 3.14159265358979;
    const glm::dvec3 l = glm::normalize(toLight), v = glm::normalize(toEye);
    const glm::dvec3 h = glm::normalize(l + v);
    const auto specular = [&](const glm::dvec3& n, double roughness) {
        const double a2 = std::pow(roughness, 4.0);
        const double nl = glm::dot(n, l), nv = glm::dot(n, v), nh = glm::dot(n, h);
        if (nl <= 0.0 || nv <= 0.0) return 0.0;
        const double d = a2 / (pi * std::pow(nh * nh * (a2 - 1.0) + 1.0, 2.0));
        const double masking =
            nl * std::sqrt(a2 + (1.0 - a2) * nv * nv) + nv * std::sqrt(a2 + (1.0 - a2) * nl * nl);
        return d * 0.5 / masking;
    };
    const double f = std::pow(1.0 - glm::dot(v, h), 5.0);
    const glm::dvec3 dielectric = of.reflectance + (1.0 - of.reflectance) * f;
    const double most = std::max({dielectric.x, dielectric.y, dielectric.z});
    const double s = specular(of.normal, of.roughness);
    const glm::dvec3 plastic = of.baseColor / pi * (1.0 - most) + s * dielectric;
    const glm::dvec3 metal = s * (of.baseColor + (1.0 - of.baseColor) * f);
    const glm::dvec3 beneath =
        glm::mix(plastic, metal, of.metallic) * std::max(glm::dot(of.normal, l), 0.0);
    const glm::dvec3 up(0.0, 0.0, 1.0);
    const double coatView = 0.04 + 0.96 * std::pow(1.0 - glm::dot(up, v), 5.0);
    const double coatHere = of.coat > 0.0
                                ? of.coat * (0.04 + 0.96 * f) * specular(up, of.coatRoughness) *
                                      std::max(glm::dot(up, l), 0.0)
                                : 0.0;
    return pi * (beneath * (1.0 - of.coat * coatView) + coatHere);
}

/// Khronos PBR Neutral and the sRGB curve, 0..255.
inline glm::dvec3 displayedBytes(glm::dvec3 color) {
    const double x = std::min({color.x, color.y, color.z});
    color -= x < 0.08 ? x - 6.25 * x * x : 0.04;
    const double peak = std::max({color.x, color.y, color.z});
    if (peak > 0.76) {
        const double newPeak = 1.0 - 0.24 * 0.24 / (peak - 0.76 + 0.24);
        const double g = 1.0 - 1.0 / (0.15 * (peak - newPeak) + 1.0);
        color = glm::mix(color * (newPeak / peak), glm::dvec3(newPeak), g);
    }
    for (glm::length_t c = 0; c < 3; ++c)
        color[c] = color[c] <= 0.0031308 ? 12.92 * color[c]
                                         : 1.055 * std::pow(color[c], 1.0 / 2.4) - 0.055;
    return 255.0 * glm::clamp(color, 0.0, 1.0);
}

inline double linearOf(double srgb) {
    return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

} // namespace edgeshade::test
