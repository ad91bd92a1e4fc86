#include "src/image/png16.hpp"
#include "src/image/zlib.hpp"

#include <gtest/gtest.h>
#include <memory>
#include <stb_image.h>

namespace edgeshade {

TEST(GreyAlphaPng, HoldsEverySixteenBits) {
    constexpr int width = 301, height = 7;
    std::vector<std::uint16_t> pixels;
    for (int i = 0; i < width * height; ++i) {
        pixels.push_back(static_cast<std::uint16_t>(i * 31));
        pixels.push_back(i % 3 == 0 ? 0 : 65535);
    }
    const Bytes png = encodeGreyAlphaPng(pixels, width, height);
    EXPECT_EQ(png, encodeGreyAlphaPng(pixels, width, height));
    int w = 0, h = 0, channels = 0;
    const std::unique_ptr<stbi_us, void (*)(void*)> read(
        stbi_load_16_from_memory(png.data(), static_cast<int>(png.size()), &w, &h, &channels, 0),
        stbi_image_free);
    ASSERT_TRUE(read);
    EXPECT_EQ(w, width);
    EXPECT_EQ(h, height);
    ASSERT_EQ(channels, 2);
    EXPECT_EQ(std::vector<std::uint16_t>(read.get(), read.get() + pixels.size()), pixels);
}

TEST(GreyAlphaPng, HasTheChecksumsThatReadersAskFor) {
    const std::vector<std::uint16_t> pixel = {0x1234, 0xFFFF};
    const Bytes png = encodeGreyAlphaPng(pixel, 1, 1);
    // The checksum of an empty IEND is known.
    const Bytes end = {0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xAE, 0x42, 0x60, 0x82};
    ASSERT_GT(png.size(), end.size());
    EXPECT_TRUE(std::equal(end.begin(), end.end(), png.end() - 12));
}

TEST(Zlib, GivesBackWhatItTook) {
    for (const std::size_t size : {1u, 1000u, 100000u}) {
        Bytes bytes;
        for (std::size_t i = 0; i < size; ++i)
            bytes.push_back(static_cast<std::uint8_t>(i * i / 7));
        EXPECT_EQ(inflated(deflated(bytes), size), bytes) << size;
    }
}

TEST(Zlib, RefusesWhatIsBrokenOrOfAnotherSize) {
    const Bytes bytes(1000, 7);
    Bytes stream = deflated(bytes);
    EXPECT_FALSE(inflated(stream, 999));
    EXPECT_FALSE(inflated(stream, 1001));
    EXPECT_FALSE(inflated(std::span(stream).first(stream.size() / 2), 1000));
    EXPECT_FALSE(inflated({}, 1000));
    stream[0] = 0xFF;
    EXPECT_FALSE(inflated(stream, 1000));
}

} // namespace edgeshade
