#include "src/rays/texture_alpha.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::rays {
namespace {

constexpr int clampToEdge = 33071, mirroredRepeat = 33648, linear = 9729;

/// The texel for any position in a row of `size` texels, by the wrap mode.
int wrapped(std::int64_t place, int size, int mode) {
    if (mode == clampToEdge)
        return static_cast<int>(std::clamp(place, std::int64_t{0}, std::int64_t{size} - 1));
    const std::int64_t period = mode == mirroredRepeat ? 2 * std::int64_t{size} : size;
    const std::int64_t rest = (place % period + period) % period;
    return static_cast<int>(rest < size ? rest : period - 1 - rest);
}

/// Values of a triangle's corners, by vertex, at a place.
template <class Value>
Value blended(const std::vector<Value>& values, const SurfaceTriangle& triangle,
              const glm::dvec2& ofTriangle) {
    const glm::dvec2 place = placeInGeometry(triangle, ofTriangle);
    const auto at = [&](std::uint32_t c) {
        return values[triangle.geometry->indices[triangle.firstIndex + c]];
    };
    return at(0) * static_cast<float>(1.0 - place.x - place.y) +
           at(1) * static_cast<float>(place.x) + at(2) * static_cast<float>(place.y);
}

} // namespace

float AlphaTexture::at(const glm::dvec2& place) const {
    if (sampler_.magFilter != linear)
        return texel(std::llround(std::floor(place.x)), std::llround(std::floor(place.y)));
    const glm::dvec2 first = glm::floor(place - 0.5);
    const glm::vec2 share(place - 0.5 - first);
    const std::int64_t x = std::llround(first.x), y = std::llround(first.y);
    return glm::mix(glm::mix(texel(x, y), texel(x + 1, y), share.x),
                    glm::mix(texel(x, y + 1), texel(x + 1, y + 1), share.x), share.y);
}

float AlphaTexture::texel(std::int64_t x, std::int64_t y) const {
    const auto column = static_cast<std::size_t>(wrapped(x, image_.width, sampler_.wrapS));
    const auto row = static_cast<std::size_t>(wrapped(y, image_.height, sampler_.wrapT));
    return static_cast<float>(image_.alpha[row * static_cast<std::size_t>(image_.width) + column]) /
           static_cast<float>(AlphaImage::full);
}

float AlphaSurface::factor(const glm::dvec2& place) const {
    return material_.baseColorFactor.a * blended(triangle_.geometry->colors, triangle_, place).a;
}

glm::dvec2 AlphaSurface::texcoord(const glm::dvec2& place) const {
    constexpr double farthest = 1e6;
    const glm::dvec2 uv(blended(triangle_.geometry->texcoords, triangle_, place));
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return glm::dvec2(0.0);
    return glm::clamp(uv, -farthest, farthest);
}

float alphaAt(const Scene& scene, const AlphaImages& images, const SurfaceTriangle& triangle,
              double u, double v) {
    const AlphaSurface surface(scene, triangle);
    const float factor = surface.factor({u, v});
    const MaterialTexture& base = surface.material().baseColor();
    const auto image = images.find(base.image);
    if (image == images.end()) return factor;
    const AlphaTexture texture(image->second, base.sampler);
    return factor * texture.at(surface.texcoord({u, v}) * texture.size());
}

} // namespace edgeshade::rays
