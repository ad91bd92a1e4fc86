#include "src/scene/textures.hpp"

#include "src/image/decode.hpp"

#include <array>
#include <GLES2/gl2.h>

namespace edgeshade {

Textures::Textures(const GltfDocument& document, const std::vector<Material>& materials,
                   const gl::Capabilities& capabilities) {
    constexpr std::array<std::uint8_t, 4> whiteTexel = {255, 255, 255, 255};
    white_ = gl::makeTexture(whiteTexel, 1, 1, {});
    MemoryBudget memory = document.memory;
    for (const Material& material : materials) {
        const Key key{material.image, material.sampler};
        if (material.image < 0 || textures_.contains(key)) continue;
        const std::string name = document.where("images[") + std::to_string(material.image) + "]";
        const Image image =
            toPowersOfTwo(decodeImage(encodedImageBytes(document, material.image), name, memory),
                          capabilities.largestTexture);
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
