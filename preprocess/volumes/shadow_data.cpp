#include "preprocess/volumes/shadow_data.hpp"

#include "preprocess/base/stopwatch.hpp"

#include <algorithm>

namespace edgeshade {

namespace {

/// Welds and hashes at once, as the hash takes long and depends on nothing else.
void weldAndHash(const Batch& batch, const std::vector<Material>& materials, bool castMasked,
                 Threads threads, BatchTopology& built) {
    inParallel(2, threads, [&](std::size_t task) {
        if (task == 0)
            built.hash =
                positionsHash(batch, castingSurfacesOf(*batch.geometry, materials, castMasked));
        else
            built.mesh = weldCasters(batch, castersOf(batch, materials, castMasked), threads);
    });
}

} // namespace

Topologies buildTopology(const Scene& scene, bool castMasked, BuildSeconds& seconds,
                         Threads threads) {
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    Topologies topology;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] != i) {
            topology.push_back(topology[first[i]]);
            continue;
        }
        Stopwatch watch;
        const Batch& batch = scene.batches[i];
        const auto built = std::make_shared<BatchTopology>();
        weldAndHash(batch, scene.materials, castMasked, threads, *built);
        seconds.weld += watch.lap();
        built->edges = buildEdges(built->mesh.welded, threads);
        seconds.edges += watch.lap();
        topology.push_back(built);
    }
    return topology;
}

int sceneMultiplicity(const Topologies& topology) {
    std::uint32_t largest = 0;
    for (const auto& batch : topology)
        largest = std::max(largest, batch->edges.largestOppositeCount());
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

Shadows buildShadows(const Scene& scene, bool castMasked) {
    BuildSeconds seconds;
    const Topologies topology = buildTopology(scene, castMasked, seconds);
    const int maxMultiplicity = sceneMultiplicity(topology);
    const std::vector<std::size_t> first = firstOfGeometry(scene.batches);
    Shadows shadows;
    for (std::size_t i = 0; i < first.size(); ++i)
        shadows.push_back(first[i] != i ? shadows[first[i]]
                                        : std::make_shared<const BatchShadow>(
                                              buildShadow(*topology[i], maxMultiplicity)));
    return shadows;
}

} // namespace edgeshade
