#pragma once

#include "src/rays/surface_triangle.hpp"

#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <vector>

namespace edgeshade::rays {

/// The alpha of an image, texel by texel.
struct AlphaImage {
    static constexpr int full = 4080; ///< an alpha of 1: 16 times that of 8 bits

    int width = 0, height = 0;        ///< 1 or more
    std::vector<std::uint16_t> alpha; ///< 0..full; rows from v = 0 on
};

/// By MaterialTexture::image.
using AlphaImages = std::map<int, AlphaImage>;

/// An image's alpha as a sampler has it, without mipmaps. Positions are in texels, whose centres
/// are at +0.5.
class AlphaTexture {
  public:
    /// Both must outlive it.
    AlphaTexture(const AlphaImage& image, const Sampler& sampler)
        : image_(image), sampler_(sampler) {}

    glm::dvec2 size() const { return {image_.width, image_.height}; }
    const Sampler& sampler() const { return sampler_; }

    /// 0..1, interpolated by the magnification filter.
    float at(const glm::dvec2& place) const;
    /// One texel, wrapped.
    float texel(std::int64_t x, std::int64_t y) const;

  private:
    const AlphaImage& image_;
    const Sampler& sampler_;
};

/// The material of a triangle, and what its corners have between them. Places are barycentric
/// coordinates of its second and third corner.
class AlphaSurface {
  public:
    /// Both must outlive it.
    AlphaSurface(const Scene& scene, const SurfaceTriangle& triangle)
        : material_(scene.materials[triangle.material]), triangle_(triangle) {}

    const Material& material() const { return material_; }
    /// The material's and the vertices' alpha.
    float factor(const glm::dvec2& place) const;
    /// Clamped to a range in which integers can count texels; 0 if it isn't finite.
    glm::dvec2 texcoord(const glm::dvec2& place) const;

  private:
    const Material& material_;
    const SurfaceTriangle& triangle_;
};

/// A triangle's alpha at a place (u, v): its base colour's factor, texture and vertices'. A texture
/// without an image here has an alpha of 1.
float alphaAt(const Scene& scene, const AlphaImages& images, const SurfaceTriangle& triangle,
              double u, double v);

} // namespace edgeshade::rays
