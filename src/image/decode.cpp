#include "src/image/decode.hpp"

#include "preprocess/base/error.hpp"
#include "preprocess/gltf/image_type.hpp"
#include "src/image/allocation_bound.hpp"
#include "src/image/jpeg_checks.hpp"
#include "src/image/webp.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>
#include <stb_image.h>
#include <stb_image_resize.h>

namespace edgeshade {

namespace {

/// Decodes PNG or JPEG.
Image decodeByStb(std::span<const std::uint8_t> bytes, const std::string& name,
                  MemoryBudget& memory) {
    constexpr int largest = 16384;
    // The most that a byte can stand for: deflate, 1,032 bytes of up to 8 pixels each in PNG; JPEG,
    // one bit for a block of 64 pixels.
    constexpr std::uint64_t mostPixelsPerByte = 8 * 1032;
    if (const auto codes = oversizedHuffmanTable(bytes))
        throw InputError(name + " has a Huffman table of " + std::to_string(*codes) +
                         " codes; there can't be more than 256.");
    const auto size = static_cast<int>(bytes.size());
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels))
        throw InputError(imageTypeOf(bytes).empty() ? name + " is neither PNG, JPEG nor WebP."
                                                    : name + " can't be decoded: " +
                                                          clauseOf(stbi_failure_reason()) + ".");
    const std::string said = name + " has " + sizeText(width, height);
    if (width > largest || height > largest)
        throw InputError(said + "; at most " + std::to_string(largest) + " a side are read.");
    const std::uint64_t pixelCount = std::uint64_t(width) * static_cast<std::uint64_t>(height);
    if (pixelCount / mostPixelsPerByte > bytes.size())
        throw InputError(said + ", which is too many for " + std::to_string(bytes.size()) +
                         " bytes.");
    countPixels(width, height, name, memory);
    // Twice the file's bytes, twice 16 bits a channel, and a margin for small images.
    const AllocationBound bound(2 * bytes.size() + static_cast<std::size_t>(16 * pixelCount) +
                                (std::size_t{1} << 20));
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
    if (!pixels) {
        const std::string reason = clauseOf(stbi_failure_reason());
        throw InputError(
            name + " can't be decoded: " +
            (reason == "outofmem" ? "its data expand to more than its pixels" : reason) + ".");
    }
    const std::size_t count = std::size_t{4} * static_cast<std::size_t>(pixelCount);
    return {width, height, std::vector<std::uint8_t>(pixels.get(), pixels.get() + count)};
}

} // namespace

Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name,
                  MemoryBudget& memory) {
    if (bytes.size() > std::numeric_limits<int>::max())
        throw InputError(name + " has " + std::to_string(bytes.size()) +
                         " bytes; at most 2147483647 are read.");
    const std::string_view type = imageTypeOf(bytes);
    if (type == "image/webp") return decodeWebp(bytes, name, memory);
    if (type == "image/ktx2")
        throw InputError(name + " is KTX2, which is not read; 'gltf-transform ktxdecompress IN.glb "
                                "OUT.glb' converts it to PNG.");
    return decodeByStb(bytes, name, memory);
}

Image decodeImage(std::span<const std::uint8_t> bytes, const std::string& name) {
    MemoryBudget memory;
    return decodeImage(bytes, name, memory);
}

Image decodeImage(const GltfDocument& document, int image, MemoryBudget& memory) {
    const std::string name = document.where("images[") + std::to_string(image) + "]";
    return decodeImage(encodedImageBytes(document, image), name, memory);
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
