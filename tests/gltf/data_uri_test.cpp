#include "preprocess/gltf/data_uri.hpp"
#include "preprocess/gltf/gltf_reading.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/scene_triangles.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

std::string decoded(const std::string& uri) {
    const Bytes bytes = dataOfUri(uri, "field");
    return std::string(bytes.begin(), bytes.end());
}

void expectRefused(const std::string& uri, const char* what) {
    expectInputError([&] { dataOfUri(uri, "'a.gltf': buffers[0].uri"); },
                     {"'a.gltf': buffers[0].uri is a data URI that can't be decoded", what});
}

} // namespace

TEST(DataUri, IsToldByItsScheme) {
    EXPECT_TRUE(isDataUri("data:,"));
    EXPECT_TRUE(isDataUri("DATA:,"));
    EXPECT_FALSE(isDataUri("data.bin"));
    EXPECT_FALSE(isDataUri("dat"));
    EXPECT_FALSE(isDataUri(""));
}

TEST(DataUri, MayHaveAnyMediaTypeOrNone) {
    for (const char* type :
         {"", "application/octet-stream", "application/gltf-buffer", "image/jpg", "image/x-vendor",
          "text/plain;charset=utf-8", "application/octet-stream;charset=utf-8;name=a"})
        EXPECT_EQ(decoded(std::string("data:") + type + ";base64,aGVsbG8="), "hello") << type;
}

TEST(DataUri, MaySpellBase64InCapitalsAndWithSpaces) {
    EXPECT_EQ(decoded("data:image/png;BASE64,aGVsbG8="), "hello");
    EXPECT_EQ(decoded("Data:image/png; base64 ,aGVsbG8="), "hello");
}

TEST(DataUri, DecodesEveryLengthOfBase64) {
    EXPECT_EQ(decoded("data:;base64,"), "");
    EXPECT_EQ(decoded("data:;base64,YQ=="), "a");
    EXPECT_EQ(decoded("data:;base64,YWI="), "ab");
    EXPECT_EQ(decoded("data:;base64,YWJj"), "abc");
    EXPECT_EQ(decoded("data:;base64,/+8A"), std::string("\xFF\xEF\0", 3));
}

TEST(DataUri, DecodesEveryByte) {
    Bytes all(256 * 3 + 1);
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = static_cast<std::uint8_t>(i * 7);
    EXPECT_EQ(dataOfUri(dataUri(all), "field"), all);
}

TEST(DataUri, MayLackPaddingAndBreakLines) {
    EXPECT_EQ(decoded("data:;base64,YQ"), "a");
    EXPECT_EQ(decoded("data:;base64,YWI"), "ab");
    EXPECT_EQ(decoded("data:;base64,aGVs\r\n bG8="), "hello");
    EXPECT_EQ(decoded("data:;base64,aGVs%0AbG8%3D"), "hello");
}

TEST(DataUri, IsPercentEncodedWithoutBase64) {
    EXPECT_EQ(decoded("data:,hello%20you"), "hello you");
    EXPECT_EQ(decoded("data:application/octet-stream,%00%ff%2C,"), std::string("\0\xFF,,", 4));
    EXPECT_EQ(decoded("data:text/plain;base64x,aGVsbG8="), "aGVsbG8=");
}

TEST(DataUri, WhatIsNoneIsRefused) {
    expectRefused("data:application/octet-stream;base64", "no comma");
    expectRefused("data:;base64,aGV@", "character 3 after the comma");
    expectRefused("data:;base64,aGV-", "character 3 after the comma"); // from another base64
                                                                       // alphabet
    expectRefused("data:;base64,YQ==YQ==", "character 4 after the comma");
    expectRefused("data:;base64,A", "within a group of four");
    expectRefused("data:;base64,AAAAA", "within a group of four");
    expectRefused("data:;base64,YWJj=", "within a group of four");
    expectRefused("data:;base64,YWI==", "within a group of four");
    expectRefused("data:;base64,YWJj====", "within a group of four");
}

TEST(DataUri, BuffersMayBeWrittenInAnyOfTheseWays) {
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    std::string escaped = "data:,";
    for (const std::uint8_t byte : gltf.binary) {
        char text[4];
        std::snprintf(text, sizeof text, "%%%02X", byte);
        escaped += text;
    }
    for (const std::string& uri :
         {escaped, dataUri(gltf.binary, ""), dataUri(gltf.binary, "text/plain;charset=utf-8")}) {
        const std::string text = gltf.gltf(uri);
        EXPECT_EQ(sceneOf(Bytes(text.begin(), text.end())).triangleCount(), 4u)
            << uri.substr(0, 40);
    }
}

TEST(DataUri, ImagesMayBeWrittenInAnyOfTheseWays) {
    for (const char* type : {"", "image/jpg", "image/png;charset=utf-8"}) {
        GltfBuilder gltf;
        gltf.addImage({{"uri", dataUri(smallPng(), type)}});
        EXPECT_EQ(encodedImageBytes(parseGltf(gltf.glb(), "test.glb"), 0), smallPng()) << type;
    }
}

} // namespace edgeshade::test
