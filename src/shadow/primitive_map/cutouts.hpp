#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// How a texture goes on beyond its edges; the values are the shader's.
enum class CutoutWrap { repeat = 0, mirror = 1, clamp = 2 };

/// What alpha-tested triangles of one material are cut out by: a rectangle of the atlas of all.
struct CutoutTexture {
    glm::ivec2 place{0}, size{0}; ///< in texels; size 0: no texture, alpha is the corners'
    CutoutWrap wrapS = CutoutWrap::repeat, wrapT = CutoutWrap::repeat;
    bool linear = true;  ///< between texels; else the nearest one
    float cutoff = 0.5f; ///< alpha below it is a hole
};
using CutoutTextures = std::vector<CutoutTexture>; ///< by material

/// One alpha-tested triangle.
struct CutoutTriangle {
    std::array<glm::vec3, 3> corners; ///< texture coordinates, and alpha without the texture's
    std::uint32_t material = 0;
};

/// What of a triangle is where on it, along a ray of map space: linear along the plane z = 1 of a
/// directional light's rays, else as they are divided by dot(Occluder::plane, ray).
struct CutoutPlanes {
    glm::dvec3 u{0.0}, v{0.0}, alpha{0.0};
    std::uint32_t material = 0;
};

/// Of the triangle whose corners have these rays: (x, y, 1) of a directional light, else the
/// corners in map space. They must not lie in one plane with the light.
CutoutPlanes cutoutPlanesOf(const CutoutTriangle& triangle, const std::array<glm::dvec3, 3>& rays);

} // namespace edgeshade
