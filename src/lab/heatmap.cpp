#include "src/lab/heatmap.hpp"

#include <algorithm>
#include <array>

namespace edgeshade::lab {
namespace {

constexpr int halo = 4; // pixels around a wrong pixel

std::array<std::uint8_t, 3> colorOf(PixelKind kind) {
    switch (kind) {
    case PixelKind::wronglyLit:
        return {230, 30, 30};
    case PixelKind::wronglyDark:
        return {40, 80, 240};
    case PixelKind::otherwiseWrong:
        return {20, 170, 60};
    default:
        return {240, 200, 0};
    }
}

} // namespace

std::vector<std::uint8_t> heatmap(const std::vector<std::uint8_t>& image,
                                  const std::vector<PixelKind>& kinds, int width, int height) {
    std::vector<std::uint8_t> map(image.size(), 255);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const int grey = (image[4 * i] + image[4 * i + 1] + image[4 * i + 2]) / 3;
        for (std::size_t c = 0; c < 3; ++c)
            map[4 * i + c] = static_cast<std::uint8_t>(128 + grey / 3);
    }
    const auto paint = [&](int x, int y, PixelKind kind, int share) {
        const auto color = colorOf(kind);
        std::uint8_t* pixel = &map[4 * (static_cast<std::size_t>(y) * width + x)];
        for (std::size_t c = 0; c < 3; ++c)
            pixel[c] = static_cast<std::uint8_t>((pixel[c] * (4 - share) + color[c] * share) / 4);
    };
    for (const bool halos : {true, false})
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const PixelKind kind = kinds[static_cast<std::size_t>(y) * width + x];
                if (kind == PixelKind::right) continue;
                if (!halos) {
                    paint(x, y, kind, 4);
                    continue;
                }
                for (int hy = std::max(0, y - halo); hy <= std::min(height - 1, y + halo); ++hy)
                    for (int hx = std::max(0, x - halo); hx <= std::min(width - 1, x + halo); ++hx)
                        paint(hx, hy, kind, 1);
            }
    return map;
}

} // namespace edgeshade::lab
