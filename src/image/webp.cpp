#include "src/image/webp.hpp"

#include "preprocess/base/error.hpp"

#include <string_view>
#ifdef EDGESHADE_HAS_WEBP
#include <webp/decode.h>
#endif

namespace edgeshade {

void requireStillWebp(std::span<const std::uint8_t> bytes, const std::string& name) {
    // Layout of an extended file's header (WebP container specification).
    constexpr std::size_t firstChunk = 12, flags = firstChunk + 8;
    constexpr std::uint8_t isAnimated = 0x02;
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (bytes.size() > flags && text.substr(firstChunk).starts_with("VP8X") &&
        (bytes[flags] & isAnimated) != 0)
        throw InputError(name + " is an animated WebP; only still pictures are drawn.");
}

#ifdef EDGESHADE_HAS_WEBP

Image decodeWebp(std::span<const std::uint8_t> bytes, const std::string& name,
                 MemoryBudget& memory) {
    requireStillWebp(bytes, name);
    Image image;
    if (!WebPGetInfo(bytes.data(), bytes.size(), &image.width, &image.height))
        throw InputError(name + " is WebP, but its header can't be read.");
    countPixels(image.width, image.height, name, memory);
    image.rgba.resize(std::size_t{4} * static_cast<std::size_t>(image.width) *
                      static_cast<std::size_t>(image.height));
    if (!WebPDecodeRGBAInto(bytes.data(), bytes.size(), image.rgba.data(), image.rgba.size(),
                            4 * image.width))
        throw InputError(name + " is WebP that can't be decoded.");
    return image;
}

#else

Image decodeWebp(std::span<const std::uint8_t>, const std::string& name, MemoryBudget&) {
    throw InputError(name + " is WebP, but this program was built without libwebp.");
}

#endif

} // namespace edgeshade
