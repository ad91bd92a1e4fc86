#include "tests/support/hdr_writing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::test {
namespace {

using Rgbe = std::array<std::uint8_t, 4>;

/// One exponent for all channels, with mantissas as fractions of 256.
Rgbe rgbeOf(const glm::vec3& color) {
    const float brightest = std::max({color.r, color.g, color.b});
    if (brightest < 1e-32f) return {};
    int exponent = 0;
    const float scale = std::frexp(brightest, &exponent) * 256.0f / brightest;
    const glm::vec3 mantissas = color * scale;
    return {static_cast<std::uint8_t>(mantissas.r), static_cast<std::uint8_t>(mantissas.g),
            static_cast<std::uint8_t>(mantissas.b), static_cast<std::uint8_t>(exponent + 128)};
}

/// Encodes runs of equal bytes (128 plus their number), and other bytes after their number.
void appendEncoded(Bytes& file, std::span<const std::uint8_t> values) {
    while (!values.empty()) {
        const auto most = values.first(std::min<std::size_t>(values.size(), 127));
        const auto other = std::adjacent_find(most.begin(), most.end(), std::not_equal_to());
        const std::size_t equal =
            other == most.end() ? most.size() : static_cast<std::size_t>(other - most.begin()) + 1;
        const auto pair = std::adjacent_find(most.begin(), most.end());
        const std::size_t different = static_cast<std::size_t>(pair - most.begin());
        const std::size_t count = equal > 1 ? equal : different;
        file.push_back(static_cast<std::uint8_t>(equal > 1 ? 128 + equal : different));
        file.insert(file.end(), values.begin(),
                    values.begin() + static_cast<std::ptrdiff_t>(equal > 1 ? 1 : different));
        values = values.subspan(count);
    }
}

void appendRow(Bytes& file, const std::vector<Rgbe>& row) {
    const std::size_t width = row.size();
    if (width < 8) {
        for (const Rgbe& pixel : row)
            file.insert(file.end(), pixel.begin(), pixel.end());
        return;
    }
    file.insert(file.end(), {2, 2, static_cast<std::uint8_t>(width >> 8),
                             static_cast<std::uint8_t>(width & 0xFF)});
    for (std::size_t channel = 0; channel < 4; ++channel) {
        Bytes values;
        for (const Rgbe& pixel : row)
            values.push_back(pixel[channel]);
        appendEncoded(file, values);
    }
}

} // namespace

Bytes hdrOf(int width, int height, const std::function<glm::vec3(int x, int y)>& pixel) {
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " +
                               std::to_string(height) + " +X " + std::to_string(width) + "\n";
    Bytes file(header.begin(), header.end());
    for (int y = 0; y < height; ++y) {
        std::vector<Rgbe> row;
        for (int x = 0; x < width; ++x)
            row.push_back(rgbeOf(pixel(x, y)));
        appendRow(file, row);
    }
    return file;
}

Bytes panoramaOf(int width, int height,
                 const std::function<glm::vec3(const glm::vec3& direction)>& radiance) {
    constexpr float pi = std::numbers::pi_v<float>;
    return hdrOf(width, height, [&](int x, int y) {
        const float elevation =
            pi * (0.5f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height));
        const float turn =
            2.0f * pi * ((static_cast<float>(x) + 0.5f) / static_cast<float>(width) - 0.5f);
        const float level = std::cos(elevation);
        return radiance({level * std::sin(turn), std::sin(elevation), -level * std::cos(turn)});
    });
}

} // namespace edgeshade::test
