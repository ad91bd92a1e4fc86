#include "preprocess/gltf/gltf_reading.hpp"
#include "preprocess/packing/pack.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/meshopt_encoding.hpp"
#include "tests/support/packing.hpp"
#include "tests/support/scene_triangles.hpp"
#include "tests/support/temp_folder.hpp"
#include "tests/support/webp_encoding.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

Bytes textBytes(const std::string& text) {
    return Bytes(text.begin(), text.end());
}

/// The bytes of view `view`.
Bytes viewOf(const GlbParts& parts, std::size_t view) {
    const Json& json = parts.json["bufferViews"].at(view);
    const auto first = parts.binary.begin() + json.value("byteOffset", std::ptrdiff_t{0});
    return Bytes(first, first + json.at("byteLength").get<std::ptrdiff_t>());
}

} // namespace

TEST(PackContent, EverythingOfTheSourceIsKept) {
    GltfBuilder gltf = variedScene();
    gltf.json["asset"]["generator"] = "a test";
    gltf.json["extras"] = {{"answer", 42}, {"nested", {{"list", {1, 2.5, "three", nullptr}}}}};
    gltf.useExtension("VENDOR_unknown", false);
    gltf.json["extensions"] = {{"VENDOR_unknown", {{"z", 1}, {"a", 2}}}};
    gltf.json["nodes"][0]["extensions"] = {{"VENDOR_unknown", {{"of", "a node"}}}};
    gltf.json["cameras"] = {
        {{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.01}}}}};
    const GlbParts before(gltf.glb());
    for (const Encoding encoding : everyEncoding) {
        GlbParts after(packed(gltf.glb(), encoding));
        EXPECT_TRUE(std::equal(before.binary.begin(), before.binary.begin() + gltf.binary.size(),
                               after.binary.begin()));
        EXPECT_EQ(after.json["extensionsUsed"].back(), shadowExtensionName);
        after.json["extensionsUsed"].erase(after.json["extensionsUsed"].size() - 1);
        after.json["extensions"].erase(shadowExtensionName);
        after.json["buffers"] = before.json["buffers"];
        for (const char* section : {"accessors", "bufferViews"}) {
            auto& items = after.json[section];
            const std::size_t count = before.json[section].size();
            while (items.size() > count)
                items.erase(items.size() - 1);
        }
        EXPECT_EQ(after.json.dump(), before.json.dump()) << nameOf(encoding);
    }
}

TEST(PackContent, TheExtensionIsUsedAndNotRequired) {
    const GlbParts parts(packed(variedScene().glb(), Encoding::indexed));
    EXPECT_EQ(parts.json["extensionsUsed"], Json::array({shadowExtensionName}));
    EXPECT_FALSE(parts.json.contains("extensionsRequired"));
    EXPECT_EQ(parts.json["extensions"][shadowExtensionName]["version"], shadowExtensionVersion);
}

TEST(PackContent, NameAndExtrasOfABufferAreKept) {
    GltfBuilder gltf = variedScene();
    gltf.json["buffers"] = {{{"name", "geometry"}, {"extras", {{"kept", true}}}}};
    const GlbParts parts(packed(gltf.glb(), Encoding::indexed));
    EXPECT_EQ(parts.json["buffers"][0].value("name", ""), "geometry");
    EXPECT_TRUE(parts.json["buffers"][0].contains("extras"));
}

TEST(PackContent, ExternalBuffersAndImagesAreEmbedded) {
    const TempFolder folder;
    GltfBuilder gltf = variedScene();
    gltf.addImage({{"uri", "my%20picture.png"}, {"name", "beside"}});
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    gltf.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
    folder.write("my picture.png", smallPng());
    folder.write("scene.bin", gltf.binary);
    const Bytes asset = textBytes(gltf.gltf("scene.bin"));
    for (const Encoding encoding : everyEncoding) {
        const GlbParts parts(packed(asset, encoding, {}, folder / "scene.gltf"));
        EXPECT_EQ(parts.json["buffers"].size(), 1u);
        EXPECT_EQ(parts.json.dump().find("\"uri\""), std::string::npos);
        ASSERT_EQ(parts.json["images"].size(), 2u);
        EXPECT_EQ(parts.json["images"][0]["name"], "beside");
        for (const Json& image : parts.json["images"]) {
            EXPECT_EQ(image["mimeType"], "image/png");
            EXPECT_EQ(viewOf(parts, image["bufferView"].get<std::size_t>()), smallPng());
        }
        expectSameShadows(readBack(parts.glb()), built(gltf.glb()));
    }
}

TEST(PackContent, ImagesOfAFileWithoutBuffersOrViewsAreEmbedded) {
    // Different numbers of members, since adding the first view, itself a member, may move all
    // others in memory.
    for (int more = 0; more < 8; ++more)
        for (const bool hasBuffer : {false, true}) {
            GltfBuilder gltf;
            gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}, {"name", "first"}});
            gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}, {"name", "second"}});
            for (int i = 0; i < more; ++i)
                gltf.json["member" + std::to_string(i)] = i;
            if (hasBuffer) gltf.binary = {1, 2, 3};
            SCOPED_TRACE(gltf.json.dump());
            const GlbParts parts(packed(gltf.glb(), Encoding::indexed));
            EXPECT_EQ(parts.json["buffers"].size(), 1u);
            EXPECT_EQ(parts.json.value("member" + std::to_string(more - 1), -1), more - 1);
            ASSERT_EQ(parts.json["images"].size(), 2u);
            for (std::size_t i = 0; i < 2; ++i) {
                EXPECT_EQ(parts.json["images"][i], Json({{"name", gltf.json["images"][i]["name"]},
                                                         {"bufferView", i},
                                                         {"mimeType", "image/png"}}));
                EXPECT_EQ(viewOf(parts, i), smallPng());
            }
        }
}

TEST(PackContent, SeveralBuffersBecomeOne) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const Bytes second = bytesOf(std::vector<float>{0, 0, 5, 1, 0, 5, 0, 1, 5});
    Bytes shifted = {1, 2, 3, 4};
    shifted.insert(shifted.end(), second.begin(), second.end());
    gltf.json["bufferViews"].push_back(
        {{"buffer", 1}, {"byteOffset", 4}, {"byteLength", second.size()}});
    const int positions = gltf.addAccessor(static_cast<int>(gltf.json["bufferViews"].size()) - 1,
                                           componentTypeOf<float>, 3, "VEC3",
                                           {{"min", {0, 0, 5}}, {"max", {1, 1, 5}}});
    gltf.addNode({{"mesh", gltf.addMesh({{"attributes", {{"POSITION", positions}}}})}});
    gltf.binary.push_back(0); // so that the second blob needs padding
    gltf.json["buffers"] = {Json::object(),
                            {{"byteLength", shifted.size()}, {"uri", dataUri(shifted)}}};
    const Bytes asset = gltf.glb();
    for (const Encoding encoding : everyEncoding) {
        const Bytes glb = packed(asset, encoding);
        EXPECT_EQ(GlbParts(glb).json["buffers"].size(), 1u);
        expectSameTriangles(worldTriangles(sceneOf(glb)), worldTriangles(sceneOf(asset)));
        expectSameShadows(readBack(glb), built(asset));
    }
}

TEST(PackContent, CompressedGeometryStaysCompressed) {
    const GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
    for (const Encoding encoding : everyEncoding) {
        const Bytes glb = packed(gltf.glb(), encoding);
        const GlbParts parts(glb);
        ASSERT_EQ(parts.json["buffers"].size(), 2u);
        EXPECT_FALSE(parts.json["buffers"][1].contains("uri"));
        EXPECT_TRUE(parts.json["buffers"][1].contains("extensions"));
        EXPECT_TRUE(parts.json["bufferViews"][0].contains("extensions"));
        expectSameTriangles(worldTriangles(sceneOf(glb)), worldTriangles(sceneOf(gltf)));
    }
}

TEST(PackContent, AFallbackBufferMayStandInFront) {
    // The compressed bytes in an external buffer 1, the fallback as buffer 0.
    GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
    const Bytes expected = gltf.glb();
    std::swap(gltf.json["buffers"][0], gltf.json["buffers"][1]);
    gltf.json["buffers"][1] = {{"byteLength", gltf.binary.size()}, {"uri", dataUri(gltf.binary)}};
    for (Json& view : gltf.json["bufferViews"]) {
        view["buffer"] = 0;
        view["extensions"]["EXT_meshopt_compression"]["buffer"] = 1;
    }
    const Bytes asset = textBytes(gltf.json.dump());
    expectSameTriangles(worldTriangles(sceneOf(asset)), worldTriangles(sceneOf(expected)));
    for (const Encoding encoding : everyEncoding) {
        const Bytes glb = packed(asset, encoding);
        EXPECT_EQ(GlbParts(glb).json["buffers"].size(), 2u);
        expectSameShadows(readBack(glb), built(expected));
    }
}

TEST(PackContent, AFallbackBufferKeepsNoUri) {
    GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
    Json fallback = gltf.json["buffers"][1];
    fallback["byteLength"] = 0;
    fallback["uri"] = "data:application/octet-stream;base64,AA==";
    gltf.json["buffers"].push_back(fallback);
    const GlbParts parts(packed(gltf.glb(), Encoding::indexed));
    ASSERT_EQ(parts.json["buffers"].size(), 3u);
    EXPECT_FALSE(parts.json["buffers"][2].contains("uri"));
}

TEST(PackContent, ViewsOfABufferWithoutBytesKeepOne) {
    const Json meshopt = {{"EXT_meshopt_compression", {{"fallback", true}}}};
    for (const Json& buffer :
         {Json({{"byteLength", 0}, {"uri", "data:application/octet-stream;base64,AA=="}}),
          Json({{"byteLength", 8}, {"extensions", meshopt}})}) {
        GltfBuilder gltf;
        gltf.json["buffers"] = Json::array({buffer});
        gltf.json["bufferViews"] = {{{"buffer", 0}, {"byteLength", buffer["byteLength"]}}};
        const Bytes once = packed(gltf.glb(), Encoding::indexed);
        EXPECT_EQ(packed(once, Encoding::indexed), once);
    }
}

TEST(PackContent, AccessorsNeedNoViews) {
    GltfBuilder gltf; // all zeros
    const int zeros = gltf.addAccessor(-1, componentTypeOf<float>, 3, "VEC3");
    gltf.addNode({{"mesh", gltf.addMesh({{"attributes", {{"POSITION", zeros}}}})}});
    EXPECT_TRUE(parseGltf(gltf.glb(), "test.glb").decodedViews.empty());
    EXPECT_EQ(sceneOf(packed(gltf.glb(), Encoding::indexed)).triangleCount(), 1u);
}

TEST(PackContent, IndicesOfNothingNameNothingAfterwards) {
    // Refers to the first view and accessor of the shadow data, which don't exist yet.
    GltfBuilder gltf = variedScene();
    const std::size_t accessor = gltf.json["accessors"].size();
    gltf.addImage({{"bufferView", gltf.json["bufferViews"].size()}});
    for (const char* key : {"input", "output"}) {
        SCOPED_TRACE(key);
        GltfBuilder broken = gltf;
        broken.json["animations"][0]["samplers"][0][key] = accessor;
        const GlbParts parts(packed(broken.glb(), Encoding::indexed));
        EXPECT_GT(parts.json["accessors"].size(), accessor);
        EXPECT_FALSE(parts.json["animations"][0]["samplers"][0].contains(key));
        EXPECT_FALSE(parts.json["images"][0].contains("bufferView"));
    }
}

TEST(PackContent, AViewPastItsBuffersEndIsCut) {
    // Nothing uses it, but it would reach into the shadow data.
    for (const std::size_t past : {0, 100}) {
        GltfBuilder gltf = variedScene();
        const std::size_t length = gltf.binary.size();
        const std::size_t view = gltf.json["bufferViews"].size();
        gltf.json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", length - 8 + past}, {"byteLength", 12}});
        const GlbParts parts(packed(gltf.glb(), Encoding::indexed));
        EXPECT_EQ(viewOf(parts, view).size(), past == 0 ? 8u : 0u);
        EXPECT_EQ(packed(parts.glb(), Encoding::indexed), parts.glb());
    }
}

TEST(PackContent, ACompressedViewPastItsBuffersEndIsRefused) {
    GltfBuilder gltf = meshoptScene(box(glm::vec3(1.0f)));
    gltf.json["bufferViews"][2]["buffer"] = 0;
    expectInputError([&] { packed(gltf.glb(), Encoding::indexed); },
                     {"test.glb", "bufferViews[2]", "buffer 0"});
}

TEST(PackContent, WhatKindOfPictureAnImageIsItsBytesSay) {
    const Bytes ktx2 = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n', 0};
    const std::pair<Bytes, const char*> kinds[] = {
        {smallPng(), "image/png"}, {smallWebp(), "image/webp"}, {ktx2, "image/ktx2"}};
    for (const auto& [bytes, type] : kinds)
        for (const Json& said : {Json(), Json{{"mimeType", "image/jpeg"}}}) {
            GltfBuilder gltf = variedScene();
            Json image = said.is_null() ? Json::object() : said;
            image["uri"] = dataUri(bytes, "image/jpeg");
            gltf.addImage(image);
            const Packed result = packedWithWarnings(gltf.glb(), Encoding::none);
            EXPECT_TRUE(result.warnings.empty());
            const GlbParts parts(result.glb);
            EXPECT_EQ(parts.json["images"][0]["mimeType"], type);
            EXPECT_FALSE(parts.json["images"][0].contains("uri"));
            EXPECT_EQ(viewOf(parts, parts.json["images"][0]["bufferView"].get<std::size_t>()),
                      bytes);
        }
}

TEST(PackContent, AnImageThatCantBeEmbeddedStaysAsItIsWithAWarning) {
    const TempFolder folder;
    folder.write("image.gif", std::string_view("GIF89a"));
    GltfBuilder gltf = variedScene();
    gltf.addImage({{"uri", "gone.png"}, {"name", "kept"}});
    gltf.addImage({{"uri", "../outside.png"}});
    gltf.addImage({{"uri", "image.gif"}, {"mimeType", "image/gif"}});
    gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
    for (const Encoding encoding : everyEncoding) {
        const Packed result = packedWithWarnings(gltf.glb(), encoding, {}, folder / "scene.glb");
        const Json images = GlbParts(result.glb).json["images"];
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(images[i], gltf.json["images"][i]);
        EXPECT_TRUE(images[3].contains("bufferView"));
        ASSERT_EQ(result.warnings.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NE(result.warnings[i].find("images[" + std::to_string(i) + "]"),
                      std::string::npos);
            EXPECT_TRUE(result.warnings[i].ends_with("; it is not embedded."));
        }
        EXPECT_NE(result.warnings[0].find("gone.png' does not exist"), std::string::npos);
        // Packing it again gives the same.
        EXPECT_EQ(packed(result.glb, encoding, {}, folder / "scene.glb"), result.glb);
    }
}

TEST(PackContent, AnImageBeyondALimitIsAnError) {
    const TempFolder folder;
    folder.write("large.png", Bytes(200'000));
    GltfBuilder gltf = variedScene();
    gltf.addImage({{"uri", "large.png"}});
    ReadingLimits limits;
    limits.fileBytes = 100'000;
    const auto path = folder.write("scene.glb", gltf.glb());
    PackInput input = readForPacking(path, {}, limits);
    expectInputError([&] { packBytes(input, Encoding::none); },
                     {"images[0].uri", "large.png", "limit for a file is 100000"});
}

} // namespace edgeshade::test
