#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace edgeshade {

/// Wrapping of a texture beyond its edges; the values are the shader's.
enum class CutoutWrap { repeat = 0, mirror = 1, clamp = 2 };

/// A texture's alpha in a map's records: eight to a texel, two to a number, in twelve bits each
/// from 0 to fullAlpha. Rows follow one another without gaps.
using PackedAlpha = std::shared_ptr<const std::vector<glm::vec4>>;

/// A packed alpha of 1: a multiple of 255, so that the alpha of 8-bit textures is exact.
inline constexpr int fullAlpha = 16 * 255;

/// Packs alpha, 0..fullAlpha; larger values count as fullAlpha.
PackedAlpha packedAlpha(std::span<const std::uint16_t> alpha);

/// The texture that cuts out alpha-tested triangles of one material: a rectangle of the common
/// atlas, or of its own.
struct CutoutTexture {
    glm::ivec2 place{0}, size{0}; ///< in texels; size 0: no texture, only the corners' alpha
    CutoutWrap wrapS = CutoutWrap::repeat, wrapT = CutoutWrap::repeat;
    bool linear = true;  ///< filtered linearly; otherwise the nearest texel
    float cutoff = 0.5f; ///< alpha below it is a hole
    PackedAlpha own{};   ///< its alpha, for maps in one table; null: it is in the atlas
    /// Its triangles are tinted instead: they let this share of red, green and blue through, each
    /// 0..1. `own` then has no alpha, but what multiplies red, green and blue, one after another.
    std::optional<glm::vec3> tint{};
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
