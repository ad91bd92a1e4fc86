#include "tests/lab/extreme_check.hpp"
#include "tests/support/emitted_chain.hpp"
#include "tests/support/open_edges.hpp"
#include "tests/support/plane_pair_chain.hpp"

namespace edgeshade::test {
namespace {

using namespace shader_arithmetic;

constexpr std::size_t mostChainVertices = 600; // a chain's memory grows with their square

template <class Method>
std::size_t openEdgesOfBatch(const BatchTopology& topology, const BatchShadow& shadow,
                             const glm::vec4& light) {
    std::size_t open = openEdgesOf<Method>(topology, shadow, light);
    const auto& positions = topology.mesh.welded.positions;
    if (positions.size() > mostChainVertices) return open;
    const auto sides = expandSides(shadow.sides, 0, shadow.sides.recordCount());
    const auto caps = expandCaps(shadow.caps, 0, shadow.caps.recordCount());
    const Chain chain =
        emittedChain<Method>(positions, sides, shadow.sides.vectorsPerRecord(), caps, light);
    return open + !chain.isCycle();
}

std::size_t openEdgesOfBatch(const BatchTopology& topology, const PlanePairShadow& shadow,
                             const glm::vec4& light) {
    const PlanePairSigns signs = signsOf(shadow, light, countAll);
    std::size_t open = openEdges(topology.mesh, topology.edges, shadow, signs);
    const auto& positions = topology.mesh.welded.positions;
    if (positions.size() <= mostChainVertices) open += openClusters(positions, shadow, light);
    return open;
}

} // namespace

std::size_t openEdgesOf(const LoadedScene& scene, const std::vector<Light>& lights) {
    BuildSeconds seconds;
    const auto topology = buildTopology(scene.scene, scene.settings.castMasked, seconds);
    std::size_t open = 0;
    for (std::size_t b = 0; b < topology.size(); ++b)
        for (const Light& light : lights) {
            const glm::vec4 inBatch = lightInObject(light, scene.scene.batches[b].worldFromBatch);
            open += openEdgesOfBatch<ReferenceEdge>(*topology[b], *scene.shadows[b], inBatch);
            open += openEdgesOfBatch<ThreeEdge>(*topology[b], *scene.shadows[b], inBatch);
            open += openEdgesOfBatch(*topology[b], *scene.planePairs[b], inBatch);
        }
    return open;
}

} // namespace edgeshade::test
