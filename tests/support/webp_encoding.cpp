#include "tests/support/webp_encoding.hpp"

#include "src/image/decode.hpp"
#include "tests/support/gltf_builder.hpp"

#include <stdexcept>
#include <string_view>
#include <webp/encode.h>

namespace edgeshade::test {
namespace {

void append(Bytes& bytes, std::string_view text) {
    bytes.insert(bytes.end(), text.begin(), text.end());
}

void append(Bytes& bytes, std::size_t number, int width) {
    for (int i = 0; i < width; ++i)
        bytes.push_back(static_cast<std::uint8_t>(number >> 8 * i));
}

/// Appends a chunk of a RIFF file; `content` has an even number of bytes.
void appendChunk(Bytes& bytes, std::string_view name, const Bytes& content) {
    append(bytes, name);
    append(bytes, content.size(), 4);
    bytes.insert(bytes.end(), content.begin(), content.end());
}

} // namespace

Bytes webpOf(std::span<const std::uint8_t> rgba, int width, int height, bool lossy) {
    WebPConfig config;
    WebPPicture picture;
    if (!WebPConfigInit(&config) || !WebPPictureInit(&picture))
        throw std::runtime_error("another libwebp than this was built with");
    config.lossless = lossy ? 0 : 1;
    config.exact = 1;
    picture.use_argb = 1;
    picture.width = width;
    picture.height = height;
    WebPMemoryWriter writer;
    WebPMemoryWriterInit(&writer);
    picture.writer = WebPMemoryWrite;
    picture.custom_ptr = &writer;
    const bool encoded = WebPPictureImportRGBA(&picture, rgba.data(), 4 * width) != 0 &&
                         WebPEncode(&config, &picture) != 0;
    Bytes webp(writer.mem, writer.mem + writer.size);
    WebPPictureFree(&picture);
    WebPMemoryWriterClear(&writer);
    if (!encoded) throw std::runtime_error("a test's WebP can't be encoded");
    return webp;
}

Bytes smallWebp() {
    const Image image = decodeImage(smallPng(), "small.png");
    return webpOf(image.rgba, image.width, image.height);
}

Bytes animatedWebp() {
    const Bytes still = smallWebp();
    Bytes frame;
    append(frame, 0, 6); // its position
    append(frame, 1, 3); // its width and height, minus 1
    append(frame, 1, 3);
    append(frame, 100, 3); // milliseconds
    append(frame, 0, 1);
    frame.insert(frame.end(), still.begin() + 12, still.end());
    Bytes canvas = {0x12, 0, 0, 0}; // animated, with alpha
    append(canvas, 1, 3);
    append(canvas, 1, 3);
    Bytes chunks;
    append(chunks, "WEBP");
    appendChunk(chunks, "VP8X", canvas);
    appendChunk(chunks, "ANIM", Bytes(6));
    appendChunk(chunks, "ANMF", frame);
    Bytes webp;
    appendChunk(webp, "RIFF", chunks);
    return webp;
}

} // namespace edgeshade::test
