#include "preprocess/volumes/shadow_data.hpp"

#include "preprocess/base/stopwatch.hpp"

#include <algorithm>

namespace edgeshade {

std::vector<BatchTopology> buildTopology(const Scene& scene, bool castMasked,
                                         BuildSeconds& seconds) {
    std::vector<BatchTopology> topology;
    for (const Batch& batch : scene.batches) {
        Stopwatch watch;
        BatchTopology& built = topology.emplace_back();
        const Casters casters = castersOf(batch, scene.materials, castMasked);
        built.hash = positionsHash(batch, castingSurfacesOf(batch, scene.materials, castMasked));
        built.mesh = weldCasters(batch, casters);
        seconds.weld += watch.lap();
        built.edges = buildEdges(built.mesh.welded);
        seconds.edges += watch.lap();
    }
    return topology;
}

int sceneMultiplicity(const std::vector<BatchTopology>& topology) {
    std::uint32_t largest = 0;
    for (const BatchTopology& batch : topology)
        largest = std::max(largest, batch.edges.largestOppositeCount());
    return recordMultiplicityFor(largest);
}

BatchShadow buildShadow(const BatchTopology& topology, int maxMultiplicity) {
    const WeldedMesh& welded = topology.mesh.welded;
    return {buildSides(welded.positions, topology.edges, maxMultiplicity), buildCaps(welded),
            topology.mesh.groups};
}

BatchShadow buildShadow(const Batch& batch, const std::vector<Material>& materials,
                        bool castMasked) {
    BatchTopology topology;
    topology.mesh = weldCasters(batch, castersOf(batch, materials, castMasked));
    topology.edges = buildEdges(topology.mesh.welded);
    return buildShadow(topology, recordMultiplicityFor(topology.edges.largestOppositeCount()));
}

std::vector<BatchShadow> buildShadows(const Scene& scene, bool castMasked) {
    BuildSeconds seconds;
    const auto topology = buildTopology(scene, castMasked, seconds);
    const int maxMultiplicity = sceneMultiplicity(topology);
    std::vector<BatchShadow> shadows;
    for (const BatchTopology& batch : topology)
        shadows.push_back(buildShadow(batch, maxMultiplicity));
    return shadows;
}

} // namespace edgeshade
