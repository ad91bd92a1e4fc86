#include "src/lab/texture_alpha.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

namespace edgeshade::lab {
namespace {

constexpr int clampToEdge = 33071, mirroredRepeat = 33648, linear = 9729;

/// The texel for any position in a row of `size` texels, by the wrap mode.
int wrapped(long place, int size, int mode) {
    if (mode == clampToEdge) return static_cast<int>(std::clamp(place, 0L, size - 1L));
    const long period = mode == mirroredRepeat ? 2L * size : size;
    const long rest = (place % period + period) % period;
    return static_cast<int>(rest < size ? rest : period - 1 - rest);
}

/// A texture's alpha, at positions in texels, whose centres are at +0.5.
class AlphaTexture {
  public:
    AlphaTexture(const Image& image, const Sampler& sampler) : image_(image), sampler_(sampler) {}

    glm::dvec2 size() const { return {image_.width, image_.height}; }

    /// Alpha in 0..1, interpolated by the magnification filter.
    float at(const glm::dvec2& place) const {
        if (sampler_.magFilter != linear)
            return texel(std::lround(std::floor(place.x)), std::lround(std::floor(place.y)));
        const glm::dvec2 first = glm::floor(place - 0.5);
        const glm::vec2 share(place - 0.5 - first);
        const long x = std::lround(first.x), y = std::lround(first.y);
        return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), share.x),
                        glm::mix(texel(x, y + 1), texel(x + 1, y + 1), share.x), share.y);
    }

    /// The lowest and the highest alpha within `reach` of a position.
    glm::vec2 range(const glm::dvec2& place, double reach) const {
        const glm::dvec2 half = glm::min(glm::dvec2(reach), 0.5 * size());
        const glm::dvec2 low = glm::floor(place - half), high = glm::floor(place + half);
        glm::vec2 range(1.0f, 0.0f);
        for (long y = std::lround(low.y); y <= std::lround(high.y); ++y)
            for (long x = std::lround(low.x); x <= std::lround(high.x); ++x) {
                range.x = std::min(range.x, texel(x, y));
                range.y = std::max(range.y, texel(x, y));
            }
        return range;
    }

    /// How far from a position, in texels, a device may sample for a pixel of this size.
    double reach(const glm::dvec2& right, const glm::dvec2& down) const {
        // The largest scale factor that GLES 2.0.25, section 3.7.7, allows.
        const double smaller = std::max(std::abs(right.x), std::abs(down.x)) +
                               std::max(std::abs(right.y), std::abs(down.y));
        double texels = 1.0; // of the mipmap level sampled; linear filtering mixes two along each
                             // axis
        if (sampler_.takesMipmaps() && smaller > 1.0)
            texels = std::exp2(std::min(std::ceil(std::log2(smaller)), 30.0));
        const bool resized = !std::has_single_bit(static_cast<unsigned>(image_.width)) ||
                             !std::has_single_bit(static_cast<unsigned>(image_.height));
        return 1.5 * texels + (resized ? 1.0 : 0.0); // resized, see toPowersOfTwo()
    }

  private:
    float texel(long x, long y) const {
        const auto column = static_cast<std::size_t>(wrapped(x, image_.width, sampler_.wrapS));
        const auto row = static_cast<std::size_t>(wrapped(y, image_.height, sampler_.wrapT));
        return image_.rgba[4 * (row * static_cast<std::size_t>(image_.width) + column) + 3] /
               255.0f;
    }

    const Image& image_;
    const Sampler& sampler_;
};

/// The material and texture coordinates of a triangle's surface.
class AlphaSurface {
  public:
    AlphaSurface(const Scene& scene, const SurfaceTriangle& triangle)
        : material_(scene.materials[triangle.material]), triangle_(triangle) {}

    const Material& material() const { return material_; }
    float factor(const glm::dvec2& place) const {
        return material_.baseColorFactor.a * blended(triangle_.geometry->colors, place).a;
    }
    /// Clamped to a range in which integers can count texels.
    glm::dvec2 texcoord(const glm::dvec2& place) const {
        constexpr double farthest = 1e6;
        const glm::dvec2 uv(blended(triangle_.geometry->texcoords, place));
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return glm::dvec2(0.0);
        return glm::clamp(uv, -farthest, farthest);
    }

  private:
    template <class Value>
    Value blended(const std::vector<Value>& values, const glm::dvec2& ofTriangle) const {
        const glm::dvec2 place = placeInGeometry(triangle_, ofTriangle);
        const auto at = [&](std::uint32_t c) {
            return values[triangle_.geometry->indices[triangle_.firstIndex + c]];
        };
        return at(0) * static_cast<float>(1.0 - place.x - place.y) +
               at(1) * static_cast<float>(place.x) + at(2) * static_cast<float>(place.y);
    }

    const Material& material_;
    const SurfaceTriangle& triangle_;
};

} // namespace

AlphaLookup textureAlpha(const LoadedScene& loaded) {
    const auto images = std::make_shared<SceneImages>();
    for (const Material& material : loaded.scene.materials)
        if (const int image = material.baseColor().image;
            material.alphaMode == AlphaMode::mask && image >= 0 && !images->contains(image))
            images->emplace(image, pixelsOf(loaded, image));
    const Scene* scene = &loaded.scene;
    AlphaLookup lookup;
    lookup.at = [images, scene](const SurfaceTriangle& triangle, double u, double v) {
        const AlphaSurface surface(*scene, triangle);
        const float factor = surface.factor({u, v});
        const auto image = images->find(surface.material().baseColor().image);
        if (image == images->end()) return factor;
        const AlphaTexture texture(*image->second, surface.material().baseColor().sampler);
        return factor * texture.at(surface.texcoord({u, v}) * texture.size());
    };
    lookup.range = [images, scene](const SurfaceTriangle& triangle,
                                   const std::array<glm::dvec2, 3>& places) {
        const AlphaSurface surface(*scene, triangle);
        const float factor = surface.factor(places[0]);
        const auto image = images->find(surface.material().baseColor().image);
        if (image == images->end()) return glm::vec2(factor);
        const AlphaTexture texture(*image->second, surface.material().baseColor().sampler);
        std::array<glm::dvec2, 3> texels;
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = surface.texcoord(places[i]) * texture.size();
        return factor * texture.range(texels[0],
                                      texture.reach(texels[1] - texels[0], texels[2] - texels[0]));
    };
    return lookup;
}

} // namespace edgeshade::lab
