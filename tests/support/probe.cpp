#include "tests/support/probe.hpp"

#include "src/render/attributes.hpp"

#include <algorithm>

namespace edgeshade::test {

Probe::Probe(MultiplicityMethod method)
    : method_(method), context_({side, side}),
      capsProgram_(makeCapsProgram(method, SidesLayout::notInstanced, {}, {"PROBE"}, {"a_pixel"})) {
    std::vector<glm::vec2> centres;
    centres.reserve(std::size_t{side} * side);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            centres.emplace_back((2.0f * static_cast<float>(x) + 1.0f) / side - 1.0f,
                                 (2.0f * static_cast<float>(y) + 1.0f) / side - 1.0f);
    pixels_ = gl::vertexBuffer<glm::vec2>(centres);
}

void Probe::upload(const BatchShadow& shadow) {
    maxMultiplicity_ = shadow.sides.maxMultiplicity;
    sideCount_ = shadow.sides.recordCount();
    capCount_ = shadow.caps.recordCount();
    sides_ = gl::vertexBuffer<glm::vec4>(shadow.sides.records);
    caps_ = gl::vertexBuffer<glm::vec4>(shadow.caps.records);
}

std::vector<int> Probe::multiplicities(const glm::vec4& light) {
    auto program = sidesPrograms_.find(maxMultiplicity_);
    if (program == sidesPrograms_.end())
        program = sidesPrograms_
                      .emplace(maxMultiplicity_,
                               makeSidesProgram(method_, maxMultiplicity_,
                                                SidesLayout::notInstanced, {"PROBE"}, {"a_pixel"}))
                      .first;
    return draw(program->second, sides_, static_cast<std::size_t>(2 + maxMultiplicity_), sideCount_,
                light);
}

std::vector<int> Probe::signs(const glm::vec4& light) {
    return draw(capsProgram_, caps_, CapsData::vectorsPerRecord, capCount_, light);
}

std::vector<int> Probe::draw(gl::Program& program, const gl::Buffer& records, std::size_t vectors,
                             std::size_t count, const glm::vec4& light) {
    glViewport(0, 0, side, side);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    program.use();
    program.set("u_light", light);
    std::vector<int> numbers;
    std::vector<std::uint8_t> rgba(std::size_t{4} * side * side);
    for (std::size_t first = 0; first < count; first += std::size_t{side} * side) {
        const std::size_t drawn = std::min(count - first, std::size_t{side} * side);
        const auto rows = static_cast<int>((drawn + side - 1) / side);
        glClear(GL_COLOR_BUFFER_BIT);
        {
            AttributeBinding binding(nullptr);
            binding.addRecords(records, vectors, first * vectors * sizeof(glm::vec4), false);
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
