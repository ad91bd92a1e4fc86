#include "src/image/decode.hpp"

#include "preprocess/error.hpp"

#include <algorithm>
#include <bit>
#include <memory>
#include <stb_image.h>
#include <stb_image_resize.h>

namespace edgeshade {

Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name) {
    constexpr int largest = 16384;
    const auto size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels))
        throw InputError(name + " is neither PNG nor JPEG.");
    if (width > largest || height > largest)
        throw InputError(name + " has " + std::to_string(width) + "x" + std::to_string(height) +
                         " pixels; at most " + std::to_string(largest) + " a side are read.");
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) throw InputError(name + " can't be decoded: " + stbi_failure_reason() + ".");
    const std::size_t count =
        std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width, height, std::vector<std::uint8_t>(pixels.get(), pixels.get() + count)};
}

Image toPowersOfTwo(const Image& image, int largest) {
    const auto fitted = [&](int size) {
        return static_cast<int>(std::min(std::bit_ceil(static_cast<unsigned>(size)),
                                         std::bit_floor(static_cast<unsigned>(largest))));
    };
    Image scaled;
    scaled.width = fitted(image.width);
    scaled.height = fitted(image.height);
    if (scaled.width == image.width && scaled.height == image.height) return image;
    scaled.rgba.resize(std::size_t{4} * static_cast<std::size_t>(scaled.width) *
                       static_cast<std::size_t>(scaled.height));
    stbir_resize_uint8(image.rgba.data(), image.width, image.height, 0, scaled.rgba.data(),
                       scaled.width, scaled.height, 0, 4);
    return scaled;
}

} // namespace edgeshade
