#include "src/shadow/silhouette/count_silhouettes.hpp"

namespace edgeshade {
namespace {

int sideOf(const glm::vec4& plane, const glm::dvec4& light) {
    const double side = glm::dot(glm::dvec4(plane), light);
    return (side > 0.0) - (side < 0.0);
}

} // namespace

std::size_t countSilhouettes(const PlanePairShadow& shadow, const glm::dvec4& light) {
    std::size_t count = 0;
    for (const PairRecord& pair : shadow.pairs)
        count += sideOf(pair.plane0, light) != sideOf(pair.plane1, light);
    for (const SingleRecord& single : shadow.singles)
        count += sideOf(single.plane, light) != 0;
    return count;
}

} // namespace edgeshade
