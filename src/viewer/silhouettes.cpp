#include "src/viewer/silhouettes.hpp"

#include "src/shadow/silhouette/count_silhouettes.hpp"

namespace edgeshade::viewer {
namespace {

void count(const PlanePairShadow& shadow, const glm::dvec4& light, EdgeCounts& counts) {
    counts.edges += shadow.edges;
    counts.records += shadow.pairs.size() + shadow.singles.size();
    counts.silhouettes += countSilhouettes(shadow, light);
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
