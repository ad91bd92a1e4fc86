#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

/// Expects that reading a packed file gives the packed scene, for every encoding.
void expectRoundTrip(const Bytes& asset, const CasterSettings& settings = {}) {
    const auto expected = built(asset, settings);
    for (const Encoding encoding : everyEncoding) {
        SCOPED_TRACE(nameOf(encoding));
        expectSameShadows(readBack(packed(asset, encoding, settings)), expected);
    }
}

void expectSharedSceneRoundTrip(const std::string& name) {
    const std::filesystem::path path = std::filesystem::path(EDGESHADE_SHARED_SCENES) / name;
    if (!std::filesystem::exists(path)) GTEST_SKIP() << name << " is not here";
    expectRoundTrip(readFile(path));
}

} // namespace

TEST(PackRoundTrip, ATetrahedron) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    expectRoundTrip(gltf.glb());
}

TEST(PackRoundTrip, AVariedScene) {
    expectRoundTrip(variedScene().glb());
}

TEST(PackRoundTrip, AVariedSceneWhoseMaskedSurfacesCast) {
    expectRoundTrip(variedScene().glb(), {0.0, true});
}

TEST(PackRoundTrip, AVariedSceneWithAWeldTolerance) {
    expectRoundTrip(variedScene().glb(), {0.4, false});
}

TEST(PackRoundTrip, AVariedSceneWithSimplifiedCasters) {
    for (const double error : {0.001, 0.5, 100.0})
        expectRoundTrip(variedScene().glb(), {0.0, true, error});
}

TEST(PackRoundTrip, TheDuckWithSimplifiedCasters) {
    const std::filesystem::path path = std::filesystem::path(EDGESHADE_SHARED_SCENES) / "duck.glb";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << "duck.glb is not here";
    const Bytes duck = readFile(path);
    expectRoundTrip(duck, {0.0, false, 0.01});
    EXPECT_LT(built(duck, {0.0, false, 0.01}).front()->caps.recordCount(),
              built(duck).front()->caps.recordCount() / 2);
}

TEST(PackRoundTrip, ASceneWithoutTriangles) {
    GltfBuilder gltf;
    gltf.addNode({{"name", "nothing"}});
    expectRoundTrip(gltf.glb());
}

TEST(PackRoundTrip, ASceneWhereNothingCasts) {
    GltfBuilder gltf;
    gltf.addMaterial({{"alphaMode", "BLEND"}});
    gltf.addShapeNode(tetrahedron(), {{"material", 0}});
    expectRoundTrip(gltf.glb());
}

TEST(PackRoundTrip, AnEdgeWithMoreTrianglesThanARecordHolds) {
    for (const int pages : {1, 2, 5, 6, 11}) {
        SCOPED_TRACE(pages);
        GltfBuilder gltf;
        gltf.addShapeNode(book(pages));
        expectRoundTrip(gltf.glb());
    }
}

TEST(PackRoundTrip, EdgesThatNeed16BitIndices) {
    GltfBuilder gltf;
    for (int i = 0; i < 40; ++i)
        gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(1.0f)))},
                      {"translation", {3.0 * i, 0.1 * i, 0.0}}});
    expectRoundTrip(gltf.glb());
}

TEST(PackRoundTrip, CompressedVerticesWithAFallbackBuffer) {
    expectRoundTrip(meshoptScene(box(glm::vec3(1.0f, 2.0f, 3.0f))).glb());
}

TEST(PackRoundTrip, ThePavilion) {
    expectRoundTrip(readFile(std::filesystem::path(EDGESHADE_ASSETS) / "pavilion.glb"));
}

TEST(PackRoundTrip, TheDuck) {
    expectSharedSceneRoundTrip("duck.glb");
}

TEST(PackRoundTrip, TheOakWithSixTrianglesAnEdge) {
    expectSharedSceneRoundTrip("oaktree.glb");
}

TEST(PackRoundTrip, TheTruckCompressedByDraco) {
    expectSharedSceneRoundTrip("truck.draco.glb");
}

} // namespace edgeshade::test
