#include "src/image/zlib.hpp"

#include "preprocess/base/error.hpp"

#include <cstdlib>
#include <memory>
#include <stb_image.h>
#include <stb_image_write.h>

// Defined in stb_image_write.h but not among its declarations.
extern "C" unsigned char* stbi_zlib_compress(unsigned char* data, int size, int* compressedSize,
                                             int quality);

namespace edgeshade {
namespace {

constexpr std::size_t most = std::size_t{1} << 30; // stb counts in int

} // namespace

Bytes deflated(std::span<const std::uint8_t> bytes) {
    if (bytes.size() > most)
        throw Error(ExitStatus::unavailable, "The picture is too large to be compressed.");
    constexpr int quality = 8;
    int size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> stream(
        stbi_zlib_compress(const_cast<unsigned char*>(bytes.data()), static_cast<int>(bytes.size()),
                           &size, quality),
        std::free);
    if (!stream) throw std::bad_alloc();
    return Bytes(stream.get(), stream.get() + size);
}

std::optional<Bytes> inflated(std::span<const std::uint8_t> stream, std::size_t size) {
    if (size > most || stream.size() > most) return std::nullopt;
    Bytes bytes(size + 1); // one more, to notice a stream that is too long
    const int found = stbi_zlib_decode_buffer(
        reinterpret_cast<char*>(bytes.data()), static_cast<int>(bytes.size()),
        reinterpret_cast<const char*>(stream.data()), static_cast<int>(stream.size()));
    if (found < 0 || static_cast<std::size_t>(found) != size) return std::nullopt;
    bytes.resize(size);
    return bytes;
}

} // namespace edgeshade
