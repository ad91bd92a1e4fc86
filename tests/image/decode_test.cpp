#include "src/image/decode.hpp"

#include "src/image/jpeg_checks.hpp"
#include "src/image/png.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <stb_image_write.h>

/// Of stb_image_write, which does not declare it.
extern "C" unsigned char* stbi_zlib_compress(unsigned char* data, int size, int* compressedSize,
                                             int quality);

namespace edgeshade::test {
namespace {

/// The PNG of 2x2 pixels with data that inflate to `size` zeros.
Bytes pngInflatingTo(int size) {
    std::vector<unsigned char> zeros(static_cast<std::size_t>(size), 0);
    int length = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> data(
        stbi_zlib_compress(zeros.data(), size, &length, 8), std::free);
    Bytes png = smallPng();
    png.resize(33); // signature and header
    for (int shift = 24; shift >= 0; shift -= 8)
        png.push_back(static_cast<std::uint8_t>(length >> shift));
    png.insert(png.end(), {'I', 'D', 'A', 'T'});
    png.insert(png.end(), data.get(), data.get() + length);
    const Bytes small = smallPng();
    png.insert(png.end(), small.end() - 16, small.end()); // a checksum, and IEND
    return png;
}

Bytes jpegOf(int width, int height, int channels) {
    Bytes pixels(static_cast<std::size_t>(width * height * channels));
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint8_t>(i * 31);
    Bytes jpeg;
    stbi_write_jpg_to_func(
        [](void* to, void* data, int size) {
            const auto* bytes = static_cast<const std::uint8_t*>(data);
            static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), bytes, bytes + size);
        },
        &jpeg, width, height, channels, pixels.data(), 90);
    return jpeg;
}

} // namespace

TEST(DecodeImage, WhatIsEncodedComesBack) {
    Bytes pixels(64 * 32 * 4);
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
    const Image image = decodeImage(encodePng(pixels, 64, 32), "image");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 32);
    EXPECT_EQ(image.rgba, pixels);
}

TEST(DecodeImage, OrdinaryJpegsPassTheirCheck) {
    for (const int channels : {1, 3})
        for (const int size : {1, 8, 17, 300}) {
            const Bytes jpeg = jpegOf(size, size, channels);
            EXPECT_FALSE(oversizedHuffmanTable(jpeg));
            EXPECT_EQ(decodeImage(jpeg, "image").width, size);
        }
}

TEST(DecodeImage, WhatInflatesBeyondItsPixelsIsRefusedBeforeThat) {
    const Bytes bomb = pngInflatingTo(50'000'000);
    ASSERT_LT(bomb.size(), 500'000u);
    expectInputError([&] { decodeImage(bomb, "'a.glb': images[0]"); },
                     {"images[0]", "larger than its pixels"});
    EXPECT_EQ(decodeImage(pngInflatingTo(2 * (1 + 2 * 3)), "image").width, 2); // all that it needs
}

TEST(DecodeImage, PicturesCountAsMemory) {
    ReadingLimits limits;
    limits.memoryBytes = 1'000'000;
    MemoryBudget memory(limits);
    const Bytes jpeg = jpegOf(200, 200, 3); // 480,000 bytes, decoded
    EXPECT_NO_THROW(decodeImage(jpeg, "image", memory));
    EXPECT_NO_THROW(decodeImage(jpeg, "image", memory));
    expectInputError([&] { decodeImage(jpeg, "'a.glb': images[2]", memory); },
                     {"images[2]", "200x200 pixels", "480000 bytes of memory", "1000000"});
}

TEST(DecodeImage, AFewBytesAreNoLargePicture) {
    Bytes png = smallPng();
    png[18] = png[22] = 0x3F; // 16128 pixels a side, about
    expectInputError([&] { decodeImage(png, "'a.glb': images[0]"); },
                     {"images[0]", "16130x16130 pixels", "bytes"});
}

} // namespace edgeshade::test
