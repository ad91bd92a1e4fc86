#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace edgeshade {

/// Wrapping of a texture beyond its edges; the values are the shader's.
enum class CutoutWrap { repeat = 0, mirror = 1, clamp = 2 };

/// The texture that cuts out alpha-tested triangles of one material: a rectangle of the common
/// atlas.
struct CutoutTexture {
    glm::ivec2 place{0}, size{0}; ///< in texels; size 0: no texture, only the corners' alpha
    CutoutWrap wrapS = CutoutWrap::repeat, wrapT = CutoutWrap::repeat;
    bool linear = true;  ///< filtered linearly; otherwise the nearest texel
    float cutoff = 0.5f; ///< alpha below it is a hole
};
using CutoutTextures = std::vector<CutoutTexture>; ///< by material

/// One alpha-tested triangle.
struct CutoutTriangle {
    std::array<glm::vec3, 3> corners; ///< texture coordinates, and alpha without the texture's
    std::uint32_t material = 0;
};

/// A triangle's texture coordinates and alpha as functions of a ray in map space. They are linear
/// over the plane z = 1 of a directional light's rays. For a point light each is a linear function
/// of the ray, divided by dot(Occluder::plane, ray).
struct CutoutPlanes {
    glm::dvec3 u{0.0}, v{0.0}, alpha{0.0};
    std::uint32_t material = 0;
};

/// The planes of a triangle whose corners have these rays: (x, y, 1) for a directional light,
/// otherwise the corners in map space. They must not lie in one plane with the light.
CutoutPlanes cutoutPlanesOf(const CutoutTriangle& triangle, const std::array<glm::dvec3, 3>& rays);

} // namespace edgeshade
