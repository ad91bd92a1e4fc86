// Triangles a second of the preprocessor's steps, on one thread, beside meshoptimizer's adjacency
// of the same mesh in the same process. `preprocess_throughput SCENE...` prints JSON.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "preprocess/volumes/shadow_data.hpp"

#include <algorithm>
#include <ctime>
#include <iostream>
#include <limits>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

constexpr int repeats = 5;

/// Seconds of the processor that the quickest of several runs took.
template <class Run>
double secondsOf(Run run) {
    std::clock_t least = std::numeric_limits<std::clock_t>::max();
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        run();
        least = std::min(least, std::clock() - start);
    }
    return static_cast<double>(least) / CLOCKS_PER_SEC;
}

/// The casters of the batch with the most of them.
struct Subject {
    const Batch* batch = nullptr;
    Casters casters;
};

Subject subjectOf(const Scene& scene) {
    Subject subject;
    for (const Batch& batch : scene.batches) {
        Casters casters = castersOf(batch, scene.materials, false);
        if (!subject.batch || casters.indices.size() > subject.casters.indices.size())
            subject = {&batch, std::move(casters)};
    }
    return subject;
}

/// Ours: weld, edges, plane-pair records; opposite-vertex records in place of the last.
Json ours(const Subject& subject, const Scene& scene) {
    BatchTopology topology;
    const double weld =
        secondsOf([&] { topology.mesh = weldCasters(*subject.batch, subject.casters); });
    const double edges = secondsOf([&] { topology.edges = buildEdges(topology.mesh.welded); });
    const double adapted =
        secondsOf([&] { buildPlanePairs(topology.mesh, topology.edges, scene.materials); });
    const double published = secondsOf([&] {
        buildShadow(topology, recordMultiplicityFor(topology.edges.largestOppositeCount()));
    });
    return {{"weld", weld}, {"edges", edges}, {"adapted", adapted}, {"published", published}};
}

/// meshoptimizer's: one vertex for each position, then the opposite vertex of every triangle's
/// every side (of one other triangle at most).
Json meshoptimizers(const Subject& subject) {
    const auto& positions = subject.batch->geometry->positions;
    const std::vector<std::uint32_t>& indices = subject.casters.indices;
    std::vector<std::uint32_t> welded(indices.size()), adjacency(2 * indices.size());
    const double weld = secondsOf([&] {
        meshopt_generateShadowIndexBuffer(welded.data(), indices.data(), indices.size(),
                                          positions.data(), positions.size(), sizeof(glm::vec3),
                                          sizeof(glm::vec3));
    });
    const double neighbours = secondsOf([&] {
        meshopt_generateAdjacencyIndexBuffer(adjacency.data(), welded.data(), welded.size(),
                                             &positions.front().x, positions.size(),
                                             sizeof(glm::vec3));
    });
    return {{"weld", weld}, {"adjacency", neighbours}};
}

} // namespace
} // namespace edgeshade

int main(int count, char** words) {
    using namespace edgeshade;
    Json all = Json::array();
    for (int i = 1; i < count; ++i) {
        const std::filesystem::path path = words[i];
        const Scene scene = flattenScene(readGltf(path), 0.0);
        const Subject subject = subjectOf(scene);
        if (!subject.batch || subject.casters.indices.empty()) continue;
        all.push_back({{"scene", path.stem().string()},
                       {"triangles", subject.casters.indices.size() / 3},
                       {"seconds", ours(subject, scene)},
                       {"meshoptimizer_seconds", meshoptimizers(subject)}});
    }
    std::cout << all.dump(1) << "\n";
    return 0;
}
