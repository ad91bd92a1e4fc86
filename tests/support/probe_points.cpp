#include "tests/support/probe_points.hpp"

#include <algorithm>

namespace edgeshade::test {

ProbePoints::ProbePoints() : context_({side, side}) {
    std::vector<glm::vec2> centres;
    centres.reserve(std::size_t{side} * side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            centres.emplace_back((2.0f * static_cast<float>(x) + 1.0f) / side - 1.0f,
                                 (2.0f * static_cast<float>(y) + 1.0f) / side - 1.0f);
    pixels_ = gl::vertexBuffer<glm::vec2>(centres);
}

std::vector<int> ProbePoints::draw(
    std::size_t count,
    const std::function<void(AttributeBinding& binding, std::size_t first)>& bind) const {
    glViewport(0, 0, side, side);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    std::vector<int> numbers;
    std::vector<std::uint8_t> rgba(std::size_t{4} * side * side);
    for (std::size_t first = 0; first < count; first += std::size_t{side} * side) {
        const std::size_t drawn = std::min(count - first, std::size_t{side} * side);
        const auto rows = static_cast<int>((drawn + side - 1) / side);
        glClear(GL_COLOR_BUFFER_BIT);
        {
            AttributeBinding binding(nullptr);
            bind(binding, first);
            binding.add(pixels_, 2, GL_FLOAT, false, sizeof(glm::vec2), 0, false);
            glDrawArrays(GL_POINTS, 0, static_cast<int>(drawn));
        }
        glReadPixels(0, 0, side, rows, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
        for (std::size_t i = 0; i < drawn; ++i)
            numbers.push_back(rgba[4 * i] - 128);
    }
    gl::requireNoError("probing");
    return numbers;
}

} // namespace edgeshade::test
