// The closed chain on real models: their own records, with ten lights each.
#include "preprocess/volumes/shadow_data.hpp"
#include "shared_scene.hpp"
#include "tests/support/hard_lights.hpp"
#include "tests/support/open_edges.hpp"

#include <gtest/gtest.h>
#include <iostream>
#include <string>

namespace edgeshade::test {
namespace {

constexpr std::size_t lightsPerScene = 10;

/// Lights around, on and in line with triangles of the mesh, cycling through all kinds.
std::vector<glm::vec4> lightsFor(const WeldedMesh& mesh, std::uint64_t seed) {
    Random random(seed);
    std::vector<glm::vec4> lights;
    for (std::size_t i = 0; i < lightsPerScene; ++i) {
        const auto triangle =
            static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles.size())));
        Corners corners;
        for (std::size_t c = 0; c < 3; ++c)
            corners[c] = mesh.positions[mesh.triangles[triangle][c]];
        lights.push_back(randomLight(random, corners, static_cast<LightKind>(i % lightKindCount)));
    }
    return lights;
}

class SharedSceneChain : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(SharedSceneChain, IsClosedForTheRobustMethods) {
    using namespace shader_arithmetic;
    const std::string name = GetParam();
    SKIP_WITHOUT_SHARED_SCENE(name);
    BuildSeconds seconds;
    const auto topology = buildTopology(readSharedScene(name), true, seconds);
    const int maxMultiplicity = sceneMultiplicity(topology);
    std::size_t reference = 0, threeEdge = 0, singleEdge = 0, edges = 0, openFrames = 0;
    for (std::size_t b = 0; b < topology.size(); ++b) {
        const BatchTopology& of = *topology[b];
        if (of.mesh.welded.triangles.empty()) continue;
        const BatchShadow shadow = buildShadow(of, maxMultiplicity);
        edges += of.edges.edges.size();
        for (const glm::vec4& light : lightsFor(of.mesh.welded, b)) {
            reference += openEdgesOf<ReferenceEdge>(of, shadow, light);
            threeEdge += openEdgesOf<ThreeEdge>(of, shadow, light);
            const std::size_t open = openEdgesOf<SingleEdge>(of, shadow, light);
            singleEdge += open;
            openFrames += open > 0;
        }
    }
    EXPECT_GT(edges, 0u);
    EXPECT_EQ(reference, 0u);
    EXPECT_EQ(threeEdge, 0u);
    std::cout << "[ closed chain ] " << name << ", single edge: " << singleEdge << " of "
              << edges * lightsPerScene << " edge-light pairs open, under " << openFrames
              << " lights; reference edge: " << reference << ", three edge: " << threeEdge << "\n";
    RecordProperty("open_single_edge", std::to_string(singleEdge));
}

INSTANTIATE_TEST_SUITE_P(Scenes, SharedSceneChain,
                         testing::Values("bunny.draco", "car.draco", "city.draco", "duck", "engine",
                                         "garden.draco", "hospital-electrical", "oaktree", "temple",
                                         "truck.draco"));

} // namespace edgeshade::test
