#include "tests/support/plane_pair_probe.hpp"

#include <numeric>

namespace edgeshade::test {

PlanePairProbe::PlanePairProbe()
    : pairsProgram_(makePlanePairSidesProgram({true, false}, {"PROBE"}, {"a_pixel"})),
      singlesProgram_(makePlanePairSidesProgram({false, false}, {"PROBE"}, {"a_pixel"})),
      capsProgram_(makePlanePairCapsProgram({}, {"PROBE"}, {"a_pixel"})) {}

void PlanePairProbe::upload(const PlanePairShadow& shadow) {
    pairCount_ = shadow.pairs.size();
    singleCount_ = shadow.singles.size();
    capCount_ = shadow.caps.size();
    pairs_ = gl::vertexBuffer<PairRecord>(shadow.pairs);
    singles_ = gl::vertexBuffer<SingleRecord>(shadow.singles);
    caps_ = gl::vertexBuffer<CapRecord>(shadow.caps);
}

PlanePairSigns PlanePairProbe::signs(const glm::vec4& light, const glm::vec2& counted) {
    return {draw(pairsProgram_, pairs_, {3, 3, 4, 4}, pairCount_, light, counted),
            draw(singlesProgram_, singles_, {3, 3, 4}, singleCount_, light, counted),
            draw(capsProgram_, caps_, {3, 3, 3, 4}, capCount_, light, counted)};
}

std::vector<int> PlanePairProbe::draw(gl::Program& program, const gl::Buffer& records,
                                      const std::vector<int>& components, std::size_t count,
                                      const glm::vec4& light, const glm::vec2& counted) {
    program.use();
    program.set("u_light", light);
    program.set("u_counted", counted);
    const std::size_t stride =
        sizeof(float) *
        static_cast<std::size_t>(std::accumulate(components.begin(), components.end(), 0));
    return points_.draw(count, [&](AttributeBinding& binding, std::size_t first) {
        // A point has no corner attribute.
        binding.add(points_.pixels(), 1, GL_FLOAT, false, sizeof(glm::vec2), 0, false);
        std::size_t offset = first * stride;
        for (const int size : components) {
            binding.add(records, size, GL_FLOAT, false, stride, offset, false);
            offset += sizeof(float) * static_cast<std::size_t>(size);
        }
    });
}

} // namespace edgeshade::test
