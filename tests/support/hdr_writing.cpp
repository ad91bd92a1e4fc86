#include "tests/support/hdr_writing.hpp"

#include <cmath>
#include <numbers>
#include <stb_image_write.h>
#include <vector>

namespace edgeshade::test {

Bytes hdrOf(int width, int height, const std::function<glm::vec3(int x, int y)>& pixel) {
    std::vector<glm::vec3> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            pixels.push_back(pixel(x, y));
    Bytes file;
    stbi_write_hdr_to_func(
        [](void* to, void* data, int size) {
            const auto* bytes = static_cast<const std::uint8_t*>(data);
            static_cast<Bytes*>(to)->insert(static_cast<Bytes*>(to)->end(), bytes, bytes + size);
        },
        &file, width, height, 3, &pixels.front().x);
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
