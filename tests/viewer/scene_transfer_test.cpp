#include "web/scene_transfer.hpp"

#include "preprocess/gltf/gltf_document.hpp"
#include "src/scene/load.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Bytes withMark(Bytes png, int mark) {
    png.push_back(static_cast<std::uint8_t>(mark)); // behind the picture's end
    return png;
}

/// What a worker hands over of a scene of two pictures that materials use, and one between them
/// that none does.
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

} // namespace edgeshade::test
