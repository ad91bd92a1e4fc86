#include "src/image/radiance_file.hpp"

#include "tests/support/hdr_writing.hpp"
#include "tests/support/input_error.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Bytes bytesOf(const std::string& text) {
    return Bytes(text.begin(), text.end());
}

const std::string header = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n";

Bytes fileOf(const std::string& size, std::initializer_list<int> pixels) {
    Bytes file = bytesOf(header + size + "\n");
    for (const int byte : pixels)
        file.push_back(static_cast<std::uint8_t>(byte));
    return file;
}

std::vector<glm::vec3> pixelsOf(const Bytes& bytes) {
    RadianceFile file(bytes, "'a.hdr'");
    std::vector<glm::vec3> pixels;
    for (int y = 0; y < file.height(); ++y) {
        const auto row = file.readRow();
        pixels.insert(pixels.end(), row.begin(), row.end());
    }
    return pixels;
}

void expectRefused(const Bytes& bytes, std::initializer_list<const char*> words) {
    expectInputError([&] { pixelsOf(bytes); }, {"'a.hdr'"});
    expectInputError([&] { pixelsOf(bytes); }, words);
}

/// Colours with runs, over 16 orders of magnitude.
glm::vec3 testPixel(int x, int y) {
    const float size = std::pow(10.0f, static_cast<float>(y % 17) - 8.0f);
    return size * glm::vec3(static_cast<float>(x / 5 % 7), 1.0f, static_cast<float>(x % 3));
}

} // namespace

TEST(RadianceFile, WhatIsWrittenComesBack) {
    for (const int width : {1, 7, 8, 9, 127, 128, 129, 700}) { // 8: the first that is encoded
        SCOPED_TRACE(width);
        const std::vector<glm::vec3> pixels = pixelsOf(hdrOf(width, 20, testPixel));
        ASSERT_EQ(pixels.size(), static_cast<std::size_t>(20 * width));
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < width; ++x) {
                const glm::vec3 written = testPixel(x, y);
                const glm::vec3 read = pixels[static_cast<std::size_t>(y * width + x)];
                const float step = std::max({written.r, written.g, written.b}) / 128.0f;
                for (int channel = 0; channel < 3; ++channel)
                    ASSERT_NEAR(read[channel], written[channel], step) << x << ", " << y;
            }
    }
}

TEST(RadianceFile, MantissasAreFractionsOf256) {
    const auto pixels = pixelsOf(fileOf("-Y 1 +X 3", {128, 0, 64, 129, 128, 128, 128, 0, //
                                                      255, 255, 255, 255}));
    EXPECT_EQ(pixels[0], glm::vec3(1.0f, 0.0f, 0.5f));
    EXPECT_EQ(pixels[1], glm::vec3(0.0f)); // exponent 0
    EXPECT_TRUE(std::isfinite(pixels[2].r));
}

TEST(RadianceFile, OldRunsRepeatThePixelBeforeThem) {
    const auto pixels = pixelsOf(
        fileOf("-Y 1 +X 260", {128, 0, 0, 129, 1, 1, 1, 2, 1, 1, 1, 1, 0, 128, 0, 129})); // 2 + 256
    EXPECT_EQ(pixels[0], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(pixels[258], glm::vec3(1.0f, 0.0f, 0.0f));
    EXPECT_EQ(pixels[259], glm::vec3(0.0f, 1.0f, 0.0f));
}

TEST(RadianceFile, AFileThatIsCutOffAnywhereIsRefused) {
    for (const int width : {3, 20}) {
        const Bytes whole = hdrOf(width, 3, testPixel);
        for (std::size_t size = 0; size < whole.size(); ++size) {
            SCOPED_TRACE(size);
            expectRefused(Bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)),
                          {});
        }
    }
}

TEST(RadianceFile, OtherFilesAreRefused) {
    expectRefused({}, {"is not a Radiance picture"});
    expectRefused(bytesOf("A poem,\nof two lines.\n"), {"is not a Radiance picture"});
    expectRefused(bytesOf("#?RADIANCE"), {"ends within its header"});
    expectRefused(bytesOf("#?RADIANCE\n\n-Y 1 +X 1\n"), {"has no FORMAT=32-bit_rle_rgbe"});
    expectRefused(bytesOf("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n"),
                  {"FORMAT=32-bit_rle_xyze"});
}

TEST(RadianceFile, OtherSizesAreRefused) {
    for (const char* size : {"+Y 1 +X 1", "-Y 1 -X 1", "+X 1 -Y 1", "-Y -1 +X 1", "-Y 1 +X",
                             "-Y 1 +X 1 ", "-Y 99999999999 +X 1", ""})
        expectRefused(fileOf(size, {128, 128, 128, 128}), {"has the size '", size});
    expectRefused(fileOf("-Y 0 +X 4", {}), {"4x0 pixels"});
    expectRefused(fileOf("-Y 1 +X 16385", {}), {"16385x1 pixels", "at most 16384"});
    expectRefused(fileOf("-Y 2000000000 +X 2000000000", {}), {"2000000000x2000000000 pixels"});
}

TEST(RadianceFile, RowsThatDoNotFitAreRefused) {
    expectRefused(fileOf("-Y 1 +X 8", {2, 2, 0, 9}), {"9 pixels in row 0", "8 wide"});
    expectRefused(fileOf("-Y 1 +X 8", {2, 2, 0, 8, 137, 1}), {"a run of 9 pixels in row 0", "8"});
    expectRefused(fileOf("-Y 1 +X 8", {2, 2, 0, 8, 0, 0, 0}), {"a run of 0 pixels"});
    expectRefused(fileOf("-Y 1 +X 2", {1, 1, 1, 1, 128, 128, 128, 128}), {"a run in row 0"});
    expectRefused(fileOf("-Y 1 +X 2", {128, 128, 128, 128, 1, 1, 1, 2}), {"a run in row 0"});
    expectRefused(fileOf("-Y 1 +X 2",
                         {9, 9, 9, 9, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 0}),
                  {"a run in row 0"}); // otherwise zeros would be shifted endlessly
}

} // namespace edgeshade::test
