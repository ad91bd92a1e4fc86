#include "src/scene/textures.hpp"

#include "src/image/decode.hpp"

#include <array>
#include <GLES2/gl2.h>

namespace edgeshade {

Textures::Textures(const LoadedScene& loaded, const gl::Capabilities& capabilities)
    : textures_(std::make_shared<std::map<Key, gl::Texture>>()) {
    constexpr std::array<std::uint8_t, 4> whiteTexel = {255, 255, 255, 255};
    white_ = std::make_shared<const gl::Texture>(gl::makeTexture(whiteTexel, 1, 1, {}));
    for (const Material& material : loaded.scene.materials)
        for (const MaterialTexture& texture : material.textures) {
            const Key key{texture.image, texture.sampler};
            if (texture.image < 0 || textures_->contains(key)) continue;
            const Image image =
                toPowersOfTwo(*pixelsOf(loaded, texture.image), capabilities.largestTexture);
            textures_->emplace(
                key, gl::makeTexture(image.rgba, image.width, image.height, texture.sampler));
        }
}

bool Textures::has(const MaterialTexture& texture) const {
    return textures_->contains({texture.image, texture.sampler});
}

gl::Name Textures::of(const MaterialTexture& texture) const {
    const auto found = textures_->find({texture.image, texture.sampler});
    return found == textures_->end() ? white_->name() : found->second.name();
}

} // namespace edgeshade
