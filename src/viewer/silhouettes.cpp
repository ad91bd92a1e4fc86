#include "src/viewer/silhouettes.hpp"

namespace edgeshade::viewer {
namespace {

int sideOf(const glm::vec4& plane, const glm::dvec4& light) {
    const double side = glm::dot(glm::dvec4(plane), light);
    return (side > 0.0) - (side < 0.0);
}

void count(const PlanePairShadow& shadow, const glm::dvec4& light, EdgeCounts& counts) {
    counts.edges += shadow.edges;
    counts.records += shadow.pairs.size() + shadow.singles.size();
    for (const PairRecord& pair : shadow.pairs)
        counts.silhouettes += sideOf(pair.plane0, light) != sideOf(pair.plane1, light);
    for (const SingleRecord& single : shadow.singles)
        counts.silhouettes += sideOf(single.plane, light) != 0;
}

} // namespace

EdgeCounts countEdges(const LoadedScene& loaded, const Light& light) {
    EdgeCounts counts;
    for (std::size_t i = 0; i < loaded.planePairs.size(); ++i)
        count(*loaded.planePairs[i],
              glm::inverse(loaded.scene.batches[i].worldFromBatch) * light.position, counts);
    return counts;
}

} // namespace edgeshade::viewer
