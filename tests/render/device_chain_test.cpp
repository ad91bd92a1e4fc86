// The closed chain on the numbers that the GL really computes (docs/method.md, C1).

#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/lights.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/plane_pair_probe.hpp"
#include "tests/support/posed_chain.hpp"
#include "tests/support/probe.hpp"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade {
namespace {

constexpr std::size_t lightsPerScene = 100;
constexpr std::size_t planePairLightsPerScene = 12; // each makes a map of all edges

std::filesystem::path shippedScene() {
    return std::filesystem::path(EDGESHADE_ASSETS) / "pavilion.glb";
}

/// Every available scene: the one that ships and those of ../shared.
std::vector<std::filesystem::path> scenePaths() {
    std::vector<std::filesystem::path> paths = {shippedScene()};
    if (!std::filesystem::is_directory(EDGESHADE_SHARED_SCENES)) {
        std::cout << "[ closed chain ] no shared scenes here: the shipped one alone\n";
        return paths;
    }
    for (const auto& entry : std::filesystem::directory_iterator(EDGESHADE_SHARED_SCENES))
        if (entry.path().extension() == ".glb") paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    return paths;
}

struct Count {
    std::size_t edges = 0; ///< edge-light pairs
    std::size_t open = 0;
};

Count countOpen(test::Probe& probe, const std::filesystem::path& path, std::size_t lights) {
    const Scene scene = flattenScene(readGltf(path), 0.0);
    BuildSeconds seconds;
    const auto topology = buildTopology(scene, true, seconds);
    const int maxMultiplicity = sceneMultiplicity(topology);
    Count count;
    for (const auto& of : topology) {
        const BatchTopology& batch = *of;
        if (batch.edges.edges.empty()) continue;
        probe.upload(buildShadow(batch, maxMultiplicity));
        for (const glm::vec4& light : test::hardLights(batch.mesh.welded, lights, 3)) {
            count.edges += batch.edges.edges.size();
            count.open += test::openEdges(batch, maxMultiplicity, probe.multiplicities(light),
                                          probe.signs(light));
        }
    }
    return count;
}

Count countOpenInAll(MultiplicityMethod method, const char* name, std::size_t lights) {
    test::Probe probe(method);
    Count total;
    for (const auto& path : scenePaths()) {
        const Count count = countOpen(probe, path, lights);
        std::cout << "[ closed chain ] device, " << name << ", " << path.filename().string() << ": "
                  << count.open << " open of " << count.edges << " edge-light pairs\n";
        total.edges += count.edges;
        total.open += count.open;
    }
    return total;
}

/// Plane-pair records: first with every triangle counted, then with only the light-facing ones of
/// closed clusters.
Count countOpenPlanePairs(test::PlanePairProbe& probe, const std::filesystem::path& path,
                          std::size_t lights) {
    const Scene scene = flattenScene(readGltf(path), 0.0);
    Count count;
    for (const Batch& batch : scene.batches) {
        const CasterMesh mesh = weldCasters(batch, castersOf(batch, scene.materials, true));
        if (mesh.welded.triangles.empty()) continue;
        const EdgeList edges = buildEdges(mesh.welded);
        const PlanePairShadow shadow = buildPlanePairs(mesh, edges, scene.materials);
        probe.upload(shadow);
        const bool closed = std::all_of(shadow.clusters.begin(), shadow.clusters.end(),
                                        [](const ShadowCluster& c) { return c.closed; });
        for (const glm::vec4& light : test::hardLights(mesh.welded, lights, 3)) {
            for (const glm::vec2& counted : {test::countAll, test::countLightFacing}) {
                if (counted == test::countLightFacing && !closed) continue;
                count.edges += edges.edges.size();
                count.open += test::openEdges(mesh, edges, shadow, probe.signs(light, counted));
            }
        }
    }
    return count;
}

TEST(ClosedChainOnTheDevice, PlanesNeverOpen) {
    test::PlanePairProbe probe;
    std::size_t open = 0;
    for (const auto& path : scenePaths()) {
        const Count count = countOpenPlanePairs(probe, path, planePairLightsPerScene);
        std::cout << "[ closed chain ] device, plane, " << path.filename().string() << ": "
                  << count.open << " open of " << count.edges << " edge-light pairs\n";
        open += count.open;
    }
    EXPECT_EQ(open, 0u);
}

TEST(ClosedChainOnTheDevice, WhatDeformsNeverOpensInAnyPose) {
    test::PlanePairProbe probe;
    test::Random random(9);
    std::size_t edges = 0, open = 0;
    for (const test::GltfBuilder& gltf : {test::walkingFigure(6, 8), test::morphingBall(8, 10)}) {
        Scene scene = flattenScene(parseGltf(gltf.glb(), "test.glb"), 0.0);
        for (Batch& batch : scene.batches) {
            if (!batch.deforms()) continue;
            const PlanePairShadow rest = buildPlanePairs(
                batch, castersOf(batch, scene.materials, true), scene.materials, 0.0);
            for (int pose = 0; pose < 100; ++pose) {
                ASSERT_TRUE(poseBatch(batch, test::randomShape(batch, random, 0.01 * pose)));
                const PlanePairShadow posed = posedPlanePairs(rest, batch);
                probe.upload(posed);
                const glm::vec3 vertex =
                    batch.geometry->positions[batch.geometry->positions.size() / 3];
                for (const glm::vec4& light : {glm::vec4(0.3f, 0.8f, 0.4f, 0),
                                               glm::vec4(0.5f, 2, 1, 1), glm::vec4(vertex, 1)}) {
                    edges += posed.pairs.size() + posed.singles.size();
                    open += test::openEdgesOfPose(posed, probe.signs(light, test::countAll));
                }
            }
        }
    }
    std::cout << "[ closed chain ] device, plane, deforming: " << open << " open of " << edges
              << " edge-light pairs\n";
    EXPECT_EQ(open, 0u);
}

TEST(ClosedChainOnTheDevice, ReferenceEdgeNeverOpens) {
    EXPECT_EQ(
        countOpenInAll(MultiplicityMethod::referenceEdge, "reference-edge", lightsPerScene).open,
        0u);
}

TEST(ClosedChainOnTheDevice, ThreeEdgeNeverOpens) {
    EXPECT_EQ(countOpenInAll(MultiplicityMethod::threeEdge, "three-edge", lightsPerScene).open, 0u);
}

TEST(ClosedChainOnTheDevice, SingleEdgeOpensSoTheTestCanFail) {
    test::Probe probe(MultiplicityMethod::singleEdge);
    EXPECT_GT(countOpen(probe, shippedScene(), 12).open, 0u);
}

} // namespace
} // namespace edgeshade
