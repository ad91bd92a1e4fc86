#include "tests/support/probe.hpp"

namespace edgeshade::test {

Probe::Probe(MultiplicityMethod method)
    : method_(method),
      capsProgram_(makeCapsProgram(method, SidesLayout::notInstanced, {}, {"PROBE"}, {"a_pixel"})) {
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
    program.use();
    program.set("u_light", light);
    return points_.draw(count, [&](AttributeBinding& binding, std::size_t first) {
        binding.addRecords(records, vectors, first * vectors * sizeof(glm::vec4), false);
    });
}

} // namespace edgeshade::test
