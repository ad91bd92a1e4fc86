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
    return byGeometry(scene.batches, [&](std::size_t i) -> std::shared_ptr<const BatchTopology> {
        Stopwatch watch;
        const auto built = std::make_shared<BatchTopology>();
        weldAndHash(scene.batches[i], scene.materials, castMasked, threads, *built);
        seconds.weld += watch.lap();
        built->edges = buildEdges(built->mesh.welded, threads);
        seconds.edges += watch.lap();
        return built;
    });
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
    return byGeometry(scene.batches, [&](std::size_t i) {
        return std::make_shared<const BatchShadow>(buildShadow(*topology[i], maxMultiplicity));
    });
}

} // namespace edgeshade
