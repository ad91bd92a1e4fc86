// Triangles per second of the preprocessor's steps, on one thread and on all, beside
// meshoptimizer's adjacency of the same mesh in the same process. `preprocess_throughput
// SUBJECT...` prints JSON. A subject is a file, or a generated mesh: grid:1000000, boxes:N,
// tangle:N.
#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "preprocess/volumes/plane_pair_data.hpp"
#include "preprocess/volumes/shadow_data.hpp"
#include "tests/support/generated_meshes.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <iostream>
#include <limits>
#include <meshoptimizer.h>
#include <nlohmann/json.hpp>

namespace edgeshade {
namespace {

using Json = nlohmann::ordered_json;

/// Number of runs, of which the quickest counts; large meshes take seconds each.
int repeatsFor(std::size_t triangles) {
    return triangles > 2'000'000 ? 1 : 5;
}

/// Processor seconds of the quickest of several runs.
template <class Run>
double secondsOf(int repeats, Run run) {
    std::clock_t least = std::numeric_limits<std::clock_t>::max();
    for (int i = 0; i < repeats; ++i) {
        const std::clock_t start = std::clock();
        run();
        least = std::min(least, std::clock() - start);
    }
    return static_cast<double>(least) / CLOCKS_PER_SEC;
}

/// The casters of the batch that has the most of them.
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

/// This project's steps: weld, edges, plane-pair records; opposite-vertex records in place of the
/// last.
Json ours(const Subject& subject, const Scene& scene) {
    BatchTopology topology;
    constexpr Threads one{1};
    const int repeats = repeatsFor(subject.casters.indices.size() / 3);
    const double weld = secondsOf(
        repeats, [&] { topology.mesh = weldCasters(*subject.batch, subject.casters, one); });
    const double edges =
        secondsOf(repeats, [&] { topology.edges = buildEdges(topology.mesh.welded, one); });
    const double adapted = secondsOf(repeats, [&] {
        buildPlanePairs(topology.mesh, topology.edges, scene.materials, 0.0, one);
    });
    const double published = secondsOf(repeats, [&] {
        buildShadow(topology, recordMultiplicityFor(topology.edges.largestOppositeCount()));
    });
    return {{"weld", weld}, {"edges", edges}, {"adapted", adapted}, {"published", published}};
}

/// Elapsed seconds of all steps on all threads.
double onAllThreads(const Subject& subject, const Scene& scene) {
    using Clock = std::chrono::steady_clock;
    const int repeats = repeatsFor(subject.casters.indices.size() / 3);
    Clock::duration least = Clock::duration::max();
    for (int i = 0; i < repeats; ++i) {
        const Clock::time_point start = Clock::now();
        const CasterMesh mesh = weldCasters(*subject.batch, subject.casters);
        buildPlanePairs(mesh, buildEdges(mesh.welded), scene.materials);
        least = std::min(least, Clock::now() - start);
    }
    return std::chrono::duration<double>(least).count();
}

/// A scene of one mesh.
Scene generatedScene(const std::string& kind, std::size_t triangles) {
    test::Soup soup = test::generatedMesh(kind, triangles);
    Geometry geometry;
    geometry.groups = {{0, 0, static_cast<std::uint32_t>(soup.indices.size())}};
    geometry.positions = std::move(soup.positions);
    geometry.indices = std::move(soup.indices);
    Scene scene;
    scene.materials.resize(1);
    scene.batches.emplace_back().geometry = CopyOnWrite(std::move(geometry));
    return scene;
}

Scene sceneOf(const std::string& word) {
    const std::size_t colon = word.find(':');
    return colon == std::string::npos
               ? flattenScene(readGltf(word), 0.0)
               : generatedScene(word.substr(0, colon), std::stoul(word.substr(colon + 1)));
}

/// meshoptimizer's steps: one vertex for each position, then for each side of each triangle the
/// opposite vertex (of one other triangle at most).
Json meshoptimizers(const Subject& subject) {
    const auto& positions = subject.batch->geometry->positions;
    const std::vector<std::uint32_t>& indices = subject.casters.indices;
    const int repeats = repeatsFor(indices.size() / 3);
    std::vector<std::uint32_t> welded(indices.size()), adjacency(2 * indices.size());
    const double weld = secondsOf(repeats, [&] {
        meshopt_generateShadowIndexBuffer(welded.data(), indices.data(), indices.size(),
                                          positions.data(), positions.size(), sizeof(glm::vec3),
                                          sizeof(glm::vec3));
    });
    const double neighbours = secondsOf(repeats, [&] {
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
        const Scene scene = sceneOf(words[i]);
        const Subject subject = subjectOf(scene);
        if (!subject.batch || subject.casters.indices.empty()) continue;
        all.push_back({{"scene", path.stem().string()},
                       {"triangles", subject.casters.indices.size() / 3},
                       {"seconds", ours(subject, scene)},
                       {"seconds_on_all_threads", onAllThreads(subject, scene)},
                       {"threads", Threads().count},
                       {"meshoptimizer_seconds", meshoptimizers(subject)}});
    }
    std::cout << all.dump(1) << "\n";
    return 0;
}
