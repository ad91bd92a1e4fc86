#include "src/lab/texture_alpha.hpp"

#include "src/rays/texture_alpha.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

namespace edgeshade::lab {
namespace {

using rays::AlphaImage, rays::AlphaImages, rays::AlphaSurface, rays::AlphaTexture;

AlphaImage alphaOf(const Image& image) {
    AlphaImage alpha{image.width, image.height, {}};
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        alpha.alpha.push_back(static_cast<std::uint16_t>(image.rgba[i] * AlphaImage::full / 255));
    return alpha;
}

/// The lowest and the highest alpha within `reach` of a position.
glm::vec2 rangeOf(const AlphaTexture& texture, const glm::dvec2& place, double reach) {
    const glm::dvec2 half = glm::min(glm::dvec2(reach), 0.5 * texture.size());
    const glm::dvec2 low = glm::floor(place - half), high = glm::floor(place + half);
    glm::vec2 range(1.0f, 0.0f);
    for (auto y = std::llround(low.y); y <= std::llround(high.y); ++y)
        for (auto x = std::llround(low.x); x <= std::llround(high.x); ++x) {
            range.x = std::min(range.x, texture.texel(x, y));
            range.y = std::max(range.y, texture.texel(x, y));
        }
    return range;
}

bool isPowerOfTwo(double size) {
    return std::has_single_bit(static_cast<unsigned>(size));
}

/// How far from a position, in texels, a device may sample for a pixel of this size.
double reachOf(const AlphaTexture& texture, const glm::dvec2& right, const glm::dvec2& down) {
    // The largest scale factor that GLES 2.0.25, section 3.7.7, allows.
    const double smaller = std::max(std::abs(right.x), std::abs(down.x)) +
                           std::max(std::abs(right.y), std::abs(down.y));
    double texels = 1.0; // of the mipmap level sampled; linear filtering mixes two along each axis
    if (texture.sampler().takesMipmaps() && smaller > 1.0)
        texels = std::exp2(std::min(std::ceil(std::log2(smaller)), 30.0));
    const bool resized = !isPowerOfTwo(texture.size().x) || !isPowerOfTwo(texture.size().y);
    return 1.5 * texels + (resized ? 1.0 : 0.0); // resized, see toPowersOfTwo()
}

} // namespace

AlphaLookup textureAlpha(const LoadedScene& loaded) {
    const auto images = std::make_shared<AlphaImages>();
    for (const Material& material : loaded.scene.materials)
        if (const int image = material.baseColor().image;
            material.alphaMode == AlphaMode::mask && image >= 0 && !images->contains(image))
            images->emplace(image, alphaOf(*pixelsOf(loaded, image)));
    const Scene* scene = &loaded.scene;
    AlphaLookup lookup;
    lookup.at = [images, scene](const SurfaceTriangle& triangle, double u, double v) {
        return rays::alphaAt(*scene, *images, triangle, u, v);
    };
    lookup.range = [images, scene](const SurfaceTriangle& triangle,
                                   const std::array<glm::dvec2, 3>& places) {
        const AlphaSurface surface(*scene, triangle);
        const float factor = surface.factor(places[0]);
        const auto image = images->find(surface.material().baseColor().image);
        if (image == images->end()) return glm::vec2(factor);
        const AlphaTexture texture(image->second, surface.material().baseColor().sampler);
        std::array<glm::dvec2, 3> texels;
        for (std::size_t i = 0; i < texels.size(); ++i)
            texels[i] = surface.texcoord(places[i]) * texture.size();
        return factor * rangeOf(texture, texels[0],
                                reachOf(texture, texels[1] - texels[0], texels[2] - texels[0]));
    };
    return lookup;
}

} // namespace edgeshade::lab
