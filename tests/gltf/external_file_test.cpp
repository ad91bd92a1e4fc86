#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/reading/flatten.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/scene_triangles.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

GltfBuilder boxScene() {
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(1.0f)));
    return gltf;
}

Scene readScene(const std::filesystem::path& path) {
    return flattenScene(readGltf(path), 0.0);
}

} // namespace

TEST(ExternalFile, ADataUriIsDecoded) {
    const TempFolder folder;
    const auto path = folder.write("scene.gltf", boxScene().gltf());
    expectSameTriangles(worldTriangles(readScene(path)), worldTriangles(sceneOf(boxScene())));
}

TEST(ExternalFile, ADataUriMayEndAtAnyOfThreeBytes) {
    for (std::size_t extra = 0; extra < 3; ++extra) {
        GltfBuilder gltf = boxScene();
        gltf.binary.resize(gltf.binary.size() + extra, 7);
        const TempFolder folder;
        const GltfDocument document = readGltf(folder.write("scene.gltf", gltf.gltf()));
        EXPECT_EQ(document.buffers.at(0), gltf.binary);
    }
}

TEST(ExternalFile, BuffersLieBesideTheAsset) {
    const TempFolder folder;
    folder.write("scene.bin", boxScene().binary);
    const auto path = folder.write("scene.gltf", boxScene().gltf("scene.bin"));
    expectSameTriangles(worldTriangles(readScene(path)), worldTriangles(sceneOf(boxScene())));
}

TEST(ExternalFile, BuffersMayLieInAFolderBelow) {
    const TempFolder folder;
    folder.write("data/scene.bin", boxScene().binary);
    const auto path = folder.write("scene.gltf", boxScene().gltf("data/scene.bin"));
    EXPECT_EQ(readScene(path).triangleCount(), 12u);
}

TEST(ExternalFile, PercentEncodedNamesAreDecoded) {
    const TempFolder folder;
    folder.write("a b%\xC3\xA9.bin", boxScene().binary);
    const auto path = folder.write("scene.gltf", boxScene().gltf("a%20b%25%C3%A9.bin"));
    EXPECT_EQ(readScene(path).triangleCount(), 12u);
}

TEST(ExternalFile, APercentEncodedWayOutOfTheFolderIsRefused) {
    const TempFolder folder;
    folder.write("scene.bin", boxScene().binary);
    const auto path = folder.write("below/scene.gltf", boxScene().gltf("%2E%2E/scene.bin"));
    expectInputError([&] { readScene(path); }, {"scene.gltf", "buffers[0].uri", "%2E%2E"});
}

TEST(ExternalFile, BackslashesAndDetoursLeadToTheSameFile) {
    const TempFolder folder;
    folder.write("data/scene.bin", boxScene().binary);
    for (const char* uri :
         {"data\\scene.bin", "data%5Cscene.bin", ".\\data\\scene.bin", ".//data/scene.bin",
          "gone/../data/scene.bin", ".//gone\\..\\data/./scene.bin", "data//scene.bin"}) {
        const auto path = folder.write("scene.gltf", boxScene().gltf(uri));
        EXPECT_EQ(readScene(path).triangleCount(), 12u) << uri;
    }
}

TEST(ExternalFile, ImagesLieBehindBackslashesToo) {
    const TempFolder folder;
    folder.write("textures/small.png", smallPng());
    for (const char* uri :
         {"textures\\small.png", "textures%5csmall.png", ".//a/../textures/small.png"}) {
        GltfBuilder gltf = boxScene();
        gltf.addImage({{"uri", uri}});
        const GltfDocument document = readGltf(folder.write("scene.gltf", gltf.gltf()));
        EXPECT_EQ(encodedImageBytes(document, 0), smallPng()) << uri;
    }
}

TEST(ExternalFile, BackslashesAreNoWayOut) {
    const TempFolder folder;
    folder.write("scene.bin", boxScene().binary);
    for (const char* uri : {"..\\scene.bin", "a\\..\\..\\scene.bin", "%2e%2e%5Cscene.bin",
                            "\\scene.bin", "C:\\scene.bin", "\\\\host\\scene.bin"}) {
        const auto path = folder.write("below/scene.gltf", boxScene().gltf(uri));
        expectInputError([&] { readScene(path); },
                         {"buffers[0].uri", "only files in the asset's own folder"});
    }
}

TEST(ExternalFile, AFileMayBeLongerThanItsBuffer) {
    const TempFolder folder;
    Bytes longer = boxScene().binary;
    longer.resize(longer.size() + 100, 0xEE);
    folder.write("scene.bin", longer);
    const auto path = folder.write("scene.gltf", boxScene().gltf("scene.bin"));
    EXPECT_EQ(readScene(path).triangleCount(), 12u);
}

} // namespace edgeshade::test
