#include "web/scene_transfer.hpp"

#include "web/map_transfer.hpp"

#include "preprocess/gltf/gltf_document.hpp"
#include "src/scene/load.hpp"
#include "src/scene/pose.hpp"
#include "tests/support/moving_scenes.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Bytes withMark(Bytes png, int mark) {
    png.push_back(static_cast<std::uint8_t>(mark)); // behind the image's end
    return png;
}

/// The worker's transfer of a scene with two images that materials use, and an unused one between
/// them.
LoadedScene transferred(bool animated) {
    GltfBuilder gltf;
    for (int mark = 0; mark < 3; ++mark)
        gltf.addImage({{"uri", dataUri(withMark(smallPng(), mark), "image/png")}});
    gltf.json["textures"] = {{{"source", 2}}, {{"source", 0}}};
    for (const int texture : {0, 1}) {
        gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
        gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", texture}});
    }
    if (animated) gltf.animate(0);
    const TempFolder folder;
    LoadedScene loaded = loadScene(folder.write("scene.glb", gltf.glb()), std::nullopt);
    loaded.images.clear(); // the page decodes them
    return web::fromTransfer(web::toTransfer(loaded));
}

} // namespace

TEST(SceneTransfer, PicturesInUseGoAlong) {
    for (const bool animated : {false, true}) {
        SCOPED_TRACE(animated);
        const LoadedScene scene = transferred(animated);
        EXPECT_EQ(scene.scene.triangleCount(), 24u);
        ASSERT_EQ(scene.document->json["images"].size(), 3u);
        for (const int image : {0, 2})
            EXPECT_EQ(encodedImageBytes(*scene.document, image), withMark(smallPng(), image));
    }
}

TEST(SceneTransfer, WhatDeformsMovesAlikeThere) {
    for (const GltfBuilder& gltf : {walkingFigure(6, 6), morphingBall(6, 6)}) {
        const TempFolder folder;
        LoadedScene here = loadScene(folder.write("scene.glb", gltf.glb()), std::nullopt);
        LoadedScene there = web::fromTransfer(web::toTransfer(here));
        for (LoadedScene* scene : {&here, &there})
            ASSERT_TRUE(poseScene(*scene, 0.3));
        for (std::size_t b = 0; b < here.scene.batches.size(); ++b) {
            EXPECT_EQ(there.scene.batches[b].geometry->positions,
                      here.scene.batches[b].geometry->positions);
            EXPECT_EQ(there.scene.batches[b].geometry->normals,
                      here.scene.batches[b].geometry->normals);
            const auto &ofHere = *here.planePairs[b], &ofThere = *there.planePairs[b];
            ASSERT_EQ(ofThere.pairs.size(), ofHere.pairs.size());
            for (std::size_t i = 0; i < ofHere.pairs.size(); ++i)
                EXPECT_EQ(ofThere.pairs[i].plane1, ofHere.pairs[i].plane1);
        }
    }
}

TEST(SceneTransfer, CamerasAndLightsGoAlong) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    gltf.json["cameras"] = {
        {{"type", "perspective"}, {"name", "wide"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}};
    gltf.json["extensions"]["KHR_lights_punctual"]["lights"] = {
        {{"type", "spot"},
         {"color", {1, 0.5, 0}},
         {"range", 7},
         {"spot", {{"outerConeAngle", 0.5}}}}};
    gltf.addNode({{"name", "desk"},
                  {"camera", 0},
                  {"translation", {1, 2, 3}},
                  {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    const TempFolder folder;
    const LoadedScene loaded = loadScene(folder.write("scene.glb", gltf.glb()), std::nullopt);
    const LoadedScene taken = web::fromTransfer(web::toTransfer(loaded));
    ASSERT_EQ(taken.scene.cameras.size(), 1u);
    EXPECT_EQ(taken.scene.cameras[0].name, "wide");
    EXPECT_EQ(taken.scene.cameras[0].nodeName, "desk");
    EXPECT_EQ(taken.scene.cameras[0].worldFromCamera, loaded.scene.cameras[0].worldFromCamera);
    EXPECT_EQ(taken.scene.cameras[0].height, 1.0);
    ASSERT_EQ(taken.scene.lights.size(), 1u);
    EXPECT_EQ(taken.scene.lights[0].kind, SceneLight::Kind::spot);
    EXPECT_EQ(taken.scene.lights[0].position, glm::dvec3(1, 2, 3));
    EXPECT_EQ(taken.scene.lights[0].color, glm::dvec3(1, 0.5, 0));
    EXPECT_EQ(taken.scene.lights[0].range, 7.0);
    EXPECT_EQ(taken.scene.lights[0].outerCone, 0.5);
}

TEST(MapTransfer, TasksGoThereAndMapsComeBack) {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    const int above = gltf.addShapeNode(box(glm::vec3(0.5f)));
    gltf.json["nodes"][above]["translation"] = {0, 2, 0};
    const TempFolder folder;
    const LoadedScene loaded = loadScene(folder.write("scene.glb", gltf.glb()), std::nullopt);
    for (const glm::dvec4& light : {glm::dvec4(0.3, 1, 0.2, 0), glm::dvec4(0, 1.2, 0, 1)}) {
        PrimitiveMapTask task;
        task.light.position = light;
        task.light.cone = Cone();
        if (light.w == 0.0) task.light.extent = {.shape = LightExtent::Shape::disc, .radius = 0.01};
        task.settings.receivers.add(glm::dvec3(-2.0));
        task.settings.receivers.add(glm::dvec3(2.0));
        task.settings.size = 64;
        task.settings.splitAbove = 1;
        task.settings.othersReceive = true;
        task.settings.cutouts.resize(2);
        task.settings.cutouts[1].cutoff = 0.25f;
        const PrimitiveMapTask there = web::taskFromTransfer(web::toTransfer(task));
        EXPECT_EQ(there.light.position, light);
        EXPECT_EQ(there.light.range, task.light.range);
        ASSERT_TRUE(there.light.cone);
        EXPECT_EQ(there.light.cone->outer, task.light.cone->outer);
        EXPECT_EQ(there.settings.cutouts.at(1).cutoff, 0.25f);
        EXPECT_EQ(there.light.extent, task.light.extent);
        EXPECT_EQ(there.settings.receivers.low, task.settings.receivers.low);

        PrimitiveMapJob here(loaded, task, {}), elsewhere(loaded, there, {});
        here.finish();
        elsewhere.finish();
        const BuiltPrimitiveMap& built = here.built();
        const BuiltPrimitiveMap back = web::builtFromTransfer(web::toTransfer(elsewhere.built()));
        ASSERT_TRUE(built.map && back.map);
        EXPECT_EQ(back.light, task.light);
        EXPECT_EQ(back.map->tiles.tiles, built.map->tiles.tiles);
        EXPECT_EQ(back.map->tiles.mapFromWorld, built.map->tiles.mapFromWorld);
        EXPECT_EQ(back.map->extended, light.w == 0.0);
        EXPECT_EQ(back.map->meanList, built.map->meanList);
        EXPECT_EQ(back.map->size, built.map->size);
        EXPECT_EQ(back.map->longestList, built.map->longestList);
        EXPECT_EQ(back.map->texels, built.map->texels);
        EXPECT_EQ(back.map->headers, built.map->headers);
        EXPECT_EQ(back.map->entries, built.map->entries);
        ASSERT_EQ(back.triangles.size(), built.triangles.size());
        ASSERT_EQ(back.triangles[0].size(), built.triangles[0].size());
        for (std::size_t chunk = 0; chunk < built.triangles[0].size(); ++chunk) {
            EXPECT_EQ(back.triangles[0][chunk].lightSide, built.triangles[0][chunk].lightSide);
            EXPECT_EQ(back.triangles[0][chunk].indices, built.triangles[0][chunk].indices);
            EXPECT_EQ(back.triangles[0][chunk].vertices.size(),
                      built.triangles[0][chunk].vertices.size());
        }
    }
}

TEST(MapTransfer, ALightThatIsTooFarHasNoMap) {
    BuiltPrimitiveMap built;
    built.tooFar = true;
    built.milliseconds = 3.5;
    const BuiltPrimitiveMap back = web::builtFromTransfer(web::toTransfer(built));
    EXPECT_TRUE(back.tooFar);
    EXPECT_FALSE(back.map);
    EXPECT_EQ(back.milliseconds, 3.5);
}

} // namespace edgeshade::test
