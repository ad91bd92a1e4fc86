#include "src/scene/textures.hpp"

#include "src/image/decode.hpp"

#include <array>
#include <GLES2/gl2.h>

namespace edgeshade {

Textures::Textures(const LoadedScene& loaded, const gl::Capabilities& capabilities) {
    constexpr std::array<std::uint8_t, 4> whiteTexel = {255, 255, 255, 255};
    white_ = gl::makeTexture(whiteTexel, 1, 1, {});
    for (const Material& material : loaded.scene.materials) {
        const Key key{material.image, material.sampler};
        if (material.image < 0 || textures_.contains(key)) continue;
        const Image image =
            toPowersOfTwo(*pixelsOf(loaded, material.image), capabilities.largestTexture);
        textures_.emplace(key,
                          gl::makeTexture(image.rgba, image.width, image.height, material.sampler));
    }
}

bool Textures::has(const Material& material) const {
    return textures_.contains({material.image, material.sampler});
}

gl::Name Textures::of(const Material& material) const {
    const auto found = textures_.find({material.image, material.sampler});
    return found == textures_.end() ? white_.name() : found->second.name();
}

} // namespace edgeshade
