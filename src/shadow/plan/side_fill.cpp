#include "src/shadow/plan/side_fill.hpp"

namespace edgeshade {

glm::dvec4 pushedTo(const glm::dvec4& end, const glm::dvec3& p, const glm::dvec4& light) {
    const double height = glm::dot(end, glm::dvec4(p, 1.0)), ofLight = glm::dot(end, light);
    return {p * ofLight - glm::dvec3(light) * height, ofLight - height * light.w};
}

FillCost sideFill(const FillMeter& meter, const glm::dvec3& a, const glm::dvec3& b,
                  const glm::dvec4& light, const glm::dvec4& end) {
    const glm::dvec4 nearA(a, 1.0), nearB(b, 1.0);
    const glm::dvec4 farA = pushedTo(end, a, light), farB = pushedTo(end, b, light);
    FillCost cost = meter.of({farA, nearB, nearA});
    const bool meet = light.w == 0.0 && glm::dvec3(end) == glm::dvec3(0.0);
    if (!meet) cost += meter.of({nearB, farA, farB});
    return cost;
}

} // namespace edgeshade
