#include "src/image/png.hpp"

#include <stb_image_write.h>

namespace edgeshade {

Bytes encodePng(std::span<const std::uint8_t> rgba, int width, int height) {
    Bytes png;
    stbi_write_png_to_func(
        [](void* context, void* data, int size) {
            const auto* bytes = static_cast<const std::uint8_t*>(data);
            static_cast<Bytes*>(context)->insert(static_cast<Bytes*>(context)->end(), bytes,
                                                 bytes + size);
        },
        &png, width, height, 4, rgba.data(), width * 4);
    return png;
}

} // namespace edgeshade
