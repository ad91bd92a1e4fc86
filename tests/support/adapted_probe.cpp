#include "tests/support/adapted_probe.hpp"

#include "src/render/attributes.hpp"

#include <algorithm>
#include <numeric>

namespace edgeshade::test {

AdaptedProbe::AdaptedProbe()
    : context_({side, side}),
      pairsProgram_(makeAdaptedSidesProgram({true, false}, {"PROBE"}, {"a_pixel"})),
      singlesProgram_(makeAdaptedSidesProgram({false, false}, {"PROBE"}, {"a_pixel"})),
      capsProgram_(makeAdaptedCapsProgram(false, false, {"PROBE"}, {"a_pixel"})) {
    std::vector<glm::vec2> centres;
    centres.reserve(std::size_t{side} * side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            centres.emplace_back((2.0f * static_cast<float>(x) + 1.0f) / side - 1.0f,
                                 (2.0f * static_cast<float>(y) + 1.0f) / side - 1.0f);
    pixels_ = gl::vertexBuffer<glm::vec2>(centres);
}

void AdaptedProbe::upload(const AdaptedShadow& shadow) {
    pairCount_ = shadow.pairs.size();
    singleCount_ = shadow.singles.size();
    capCount_ = shadow.caps.size();
    pairs_ = gl::vertexBuffer<PairRecord>(shadow.pairs);
    singles_ = gl::vertexBuffer<SingleRecord>(shadow.singles);
    caps_ = gl::vertexBuffer<CapRecord>(shadow.caps);
}

AdaptedSigns AdaptedProbe::signs(const glm::vec4& light, const glm::vec2& counted) {
    return {draw(pairsProgram_, pairs_, {3, 3, 4, 4}, pairCount_, light, counted),
            draw(singlesProgram_, singles_, {3, 3, 4}, singleCount_, light, counted),
            draw(capsProgram_, caps_, {3, 3, 3, 4}, capCount_, light, counted)};
}

std::vector<int> AdaptedProbe::draw(gl::Program& program, const gl::Buffer& records,
                                    const std::vector<int>& components, std::size_t count,
                                    const glm::vec4& light, const glm::vec2& counted) {
    glViewport(0, 0, side, side);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    program.use();
    program.set("u_light", light);
    program.set("u_counted", counted);
    const std::size_t stride =
        sizeof(float) *
        static_cast<std::size_t>(std::accumulate(components.begin(), components.end(), 0));
    std::vector<int> numbers;
    std::vector<std::uint8_t> rgba(std::size_t{4} * side * side);
    for (std::size_t first = 0; first < count; first += std::size_t{side} * side) {
        const std::size_t drawn = std::min(count - first, std::size_t{side} * side);
        const auto rows = static_cast<int>((drawn + side - 1) / side);
        glClear(GL_COLOR_BUFFER_BIT);
        {
            AttributeBinding binding(nullptr);
            binding.add(pixels_, 1, GL_FLOAT, false, sizeof(glm::vec2), 0, false); // no corner
            std::size_t offset = first * stride;
            for (const int size : components) {
                binding.add(records, size, GL_FLOAT, false, stride, offset, false);
                offset += sizeof(float) * static_cast<std::size_t>(size);
            }
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
