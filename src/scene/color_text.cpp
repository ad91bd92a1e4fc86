#include "src/scene/color_text.hpp"

#include "src/scene/srgb.hpp"

#include <charconv>
#include <cmath>

namespace edgeshade {

std::optional<glm::vec3> linearFromText(const std::string& text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    glm::vec3 srgb(0.0f);
    for (std::size_t i = 0; i < 3; ++i) {
        unsigned byte = 0;
        const char* const end = text.data() + 3 + 2 * i;
        const auto result = std::from_chars(end - 2, end, byte, 16);
        if (result.ec != std::errc() || result.ptr != end) return std::nullopt;
        srgb[static_cast<glm::length_t>(i)] = static_cast<float>(byte) / 255.0f;
    }
    return linearFromSrgb(srgb);
}

std::string textFromLinear(const glm::vec3& color) {
    const glm::vec4 srgb = srgbFromLinear(glm::vec4(color, 1.0f));
    std::string text = "#";
    for (glm::length_t i = 0; i < 3; ++i) {
        const auto byte = static_cast<int>(std::lround(255.0f * srgb[i]));
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

} // namespace edgeshade
