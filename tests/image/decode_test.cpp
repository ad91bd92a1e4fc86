#include "src/image/decode.hpp"

#include "src/image/jpeg_checks.hpp"
#include "src/image/png.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/webp_encoding.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <memory>
#include <stb_image_write.h>

/// From stb_image_write, which does not declare it.
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
    png.resize(33); // keeps the signature and the header
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
                     {"images[0]", "expand to more than its pixels"});
    EXPECT_EQ(decodeImage(pngInflatingTo(2 * (1 + 2 * 3)), "image").width, 2); // all that the image
                                                                               // needs
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

TEST(DecodeImage, LosslessWebpComesBackBitForBit) {
    Bytes pixels(64 * 32 * 4); // including the colours of clear pixels
    for (std::size_t i = 0; i < pixels.size(); ++i)
        pixels[i] = static_cast<std::uint8_t>(i * 7 + i / 256);
    const Image image = decodeImage(webpOf(pixels, 64, 32), "image");
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 32);
    EXPECT_EQ(image.rgba, pixels);
}

TEST(DecodeImage, LossyWebpComesBackAboutAsItWas) {
    Bytes pixels;
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 40; ++x)
            for (const int value : {5 * x, 5 * y, 100, 255 - 5 * x})
                pixels.push_back(static_cast<std::uint8_t>(value));
    const Image image = decodeImage(webpOf(pixels, 40, 48, true), "image");
    ASSERT_EQ(image.rgba.size(), pixels.size());
    for (std::size_t i = 0; i < pixels.size(); ++i)
        ASSERT_NEAR(image.rgba[i], pixels[i], 24) << "byte " << i;
}

TEST(DecodeImage, WebpThatIsCutOffAnywhereIsRefused) {
    const Bytes webp = smallWebp();
    for (std::size_t size = 0; size < webp.size() - 1; ++size) {
        SCOPED_TRACE(size);
        expectInputError([&] { decodeImage(std::span(webp).first(size), "'a.glb': images[0]"); },
                         {"images[0]"});
    }
}

TEST(DecodeImage, AnAnimatedWebpIsRefused) {
    expectInputError([] { decodeImage(animatedWebp(), "'a.glb': images[0]"); },
                     {"images[0]", "animated WebP"});
}

TEST(DecodeImage, WebpCountsAsMemoryBeforeItIsDecoded) {
    const Bytes webp = webpOf(Bytes(4 * 4000 * 3000), 4000, 3000);
    ASSERT_LT(webp.size(), 1000u);
    ReadingLimits limits;
    limits.memoryBytes = 100'000'000;
    MemoryBudget memory(limits);
    EXPECT_THROW(decodeImage(webp, "image", memory), LimitError);
    expectInputError([&] { decodeImage(webp, "'a.glb': images[0]", memory); },
                     {"images[0]", "4000x3000 pixels", "144000000 bytes of memory"});
}

TEST(DecodeImage, Ktx2IsRefusedWithWhatConvertsIt) {
    const Bytes ktx2 = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};
    expectInputError([&] { decodeImage(ktx2, "'a.glb': images[0]"); },
                     {"images[0] is KTX2", "'gltf-transform ktxdecompress IN.glb OUT.glb'"});
}

} // namespace edgeshade::test
