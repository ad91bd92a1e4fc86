// Parts that are left out with a warning, by the real program: one sentence that names the file,
// status 0, and the picture of the scene without them.
#include "tests/cli/left_out.hpp"

#include "src/image/png.hpp"
#include "tests/cli/documented.hpp"
#include "tests/cli/kept.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/webp_encoding.hpp"

#include <gtest/gtest.h>
#include <map>
#include <sstream>

namespace edgeshade::test {
namespace {

constexpr std::size_t mostMemory = std::size_t{1} << 30; // a small file must not take more

class LeftOutTest : public testing::TestWithParam<LeftOut> {};

/// The lines of standard error that warn, without the prefix.
std::vector<std::string> warningsOf(const ProcessResult& result) {
    constexpr std::string_view start = "warning: ";
    std::vector<std::string> warnings;
    std::istringstream lines(result.err);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(start)) warnings.push_back(line.substr(start.size()));
    return warnings;
}

ProcessResult run(const std::string& verb, const std::filesystem::path& input,
                  const std::filesystem::path& output) {
    std::vector<std::string> arguments = {verb, input};
    if (verb != "info") arguments.push_back(output);
    if (verb == "render") arguments.insert(arguments.end(), {"--size", "48x48"});
    if (verb == "info") arguments.insert(arguments.end(), {"--report", "-"});
    return runEdgeshade(arguments);
}

Bytes pictureOf(const std::filesystem::path& scene) {
    const TempFolder folder;
    const ProcessResult result = run("render", scene, folder / "picture.png");
    EXPECT_EQ(result.status, 0) << result.err;
    return result.status == 0 ? readFile(folder / "picture.png") : Bytes();
}

Bytes pictureOf(const GltfBuilder& gltf) {
    const TempFolder folder;
    return pictureOf(folder.write("scene.glb", gltf.glb()));
}

/// Picture of the sound scene with its material's factor.
const Bytes& plainPicture() {
    static const Bytes picture = [] {
        GltfBuilder gltf = soundScene();
        gltf.json["materials"][0]["pbrMetallicRoughness"].erase("baseColorTexture");
        return pictureOf(gltf);
    }();
    return picture;
}

const Bytes& soundPicture() {
    static const Bytes picture = pictureOf(soundScene());
    return picture;
}

Json imagesOf(const Bytes& glb) {
    return GlbParts(glb).json["images"];
}

/// Outcome of a verb on a row's input.
struct Outcome {
    ProcessResult result;
    std::string input, folder;
    Bytes output;     ///< of verbs that write a file
    Json images = {}; ///< of the input, for verbs that write a glTF file
};

Outcome outcomeIn(const TempFolder& folder, const LeftOut& row, const std::string& verb) {
    const std::filesystem::path input = row.make(folder);
    Outcome outcome{run(verb, input, folder / "output"), input, folder.path(), {}};
    if (outcome.result.status != 0 || verb == "info") return outcome;
    outcome.output = readFile(folder / "output");
    if (verb != "render") outcome.images = imagesOf(readFile(input));
    return outcome;
}

/// Runs each verb of a row once in this process.
const Outcome& outcomeOf(const LeftOut& row, const std::string& verb) {
    static std::map<std::pair<std::string, std::string>, Outcome> outcomes;
    return kept(outcomes, {row.name, verb}, [&] {
        const TempFolder folder;
        return outcomeIn(folder, row, verb);
    });
}

void expectWarning(const LeftOut& row, const std::string& verb) {
    SCOPED_TRACE(verb);
    const auto& [result, input, folder, output, images] = outcomeOf(row, verb);
    ASSERT_EQ(result.status, 0) << result.err;
    EXPECT_LT(result.peakBytes, mostMemory);
    const auto warnings = warningsOf(result);
    ASSERT_EQ(warnings.size(), 1u) << result.err;
    EXPECT_TRUE(warnings[0].ends_with(".") && !warnings[0].ends_with("..")) << warnings[0];
    EXPECT_NE(warnings[0].find(input), std::string::npos) << "the file is not named";
    for (const std::string& word : row.words)
        EXPECT_NE(warnings[0].find(word), std::string::npos)
            << "'" << word << "' is missing in " << warnings[0];
    if (verb == "render") {
        EXPECT_TRUE(output == plainPicture());
    } else if (verb == "info") {
        EXPECT_EQ(Json::parse(result.out)["warnings"], Json(warnings));
    } else {
        EXPECT_EQ(imagesOf(output), images) << "what can't be embedded stays as it is";
    }
}

/// An image of these bytes in one of the asset's views.
Json embeddedIn(GltfBuilder& gltf, const Bytes& image) {
    return {{"bufferView", gltf.addView(image)}, {"mimeType", "image/webp"}};
}

/// The sound scene with a second image, which `extension` names.
GltfBuilder withExtension(const std::string& extension, const Bytes& image) {
    GltfBuilder gltf = soundScene();
    gltf.useExtension(extension, false);
    const int index = gltf.addImage(embeddedIn(gltf, image));
    gltf.json["textures"][0]["extensions"] = {{extension, {{"source", index}}}};
    return gltf;
}

/// Draws it and returns its warnings.
std::vector<std::string> warningsAndPictureOf(const GltfBuilder& gltf, const Bytes& expected) {
    const TempFolder folder;
    const ProcessResult result =
        run("render", folder.write("scene.glb", gltf.glb()), folder / "out.png");
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_TRUE(readFile(folder / "out.png") == expected);
    return warningsOf(result);
}

/// A floor below a sheet with holes, cut out by a texture as PNG or as the same WebP.
GltfBuilder sheetWithHoles(bool png) {
    Bytes pixels;
    for (int i = 0; i < 8 * 8; ++i)
        for (const int value : {200, 4 * i, 90, (i + i / 8) % 2 == 0 ? 255 : 0})
            pixels.push_back(static_cast<std::uint8_t>(value));
    GltfBuilder gltf;
    gltf.addImage(
        {{"uri", png ? dataUri(encodePng(pixels, 8, 8)) : dataUri(webpOf(pixels, 8, 8))}});
    gltf.json["textures"] = {{{"source", 0}}};
    gltf.addMaterial({{"alphaMode", "MASK"},
                      {"doubleSided", true},
                      {"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
    gltf.addShapeNode(box(glm::vec3(4.0f, 0.1f, 4.0f)));
    const int mesh = gltf.addShape(box(glm::vec3(1.0f)), {{"material", 0}});
    gltf.addNode({{"mesh", mesh}, {"translation", {0, 2, 0}}});
    return gltf;
}

} // namespace

TEST_P(LeftOutTest, IsDrawnAllTheSameWithAWarning) {
    for (const std::string& verb : GetParam().verbs)
        expectWarning(GetParam(), verb);
}

void PrintTo(const LeftOut& row, std::ostream* stream) {
    *stream << row.name;
}

INSTANTIATE_TEST_SUITE_P(Table, LeftOutTest, testing::ValuesIn(leftOutImages()),
                         [](const auto& row) { return row.param.name; });

TEST(LeftOut, TheTableIsDocumented) {
    std::vector<std::string> rows;
    for (const LeftOut& row : leftOutImages()) {
        const Outcome& outcome = outcomeOf(row, row.verbs[0]);
        const std::string warning = withoutFolder(warningsOf(outcome.result).at(0), outcome.folder);
        std::string verbs;
        for (const std::string& verb : row.verbs)
            verbs += (verbs.empty() ? "" : ", ") + verb;
        rows.push_back("| " + row.name + " | " + verbs + " | " + cellOf(warning) + " |");
    }
    expectDocumented("left-out", rows, "bad-inputs-list.md");
}

TEST(LeftOut, TheTextureOfTheSceneIsSeen) {
    EXPECT_FALSE(soundPicture() == plainPicture());
}

TEST(LeftOut, WhatNothingSamplesIsNeitherReadNorWarnedAbout) {
    const TempFolder folder;
    GltfBuilder gltf = soundScene();
    const Json gone = {{"index", 1}}, nowhere = {{"index", 99}};
    gltf.addImage({{"uri", "gone.png"}});
    gltf.json["textures"].push_back({{"source", 1}});
    // A material that is drawn, but whose texture isn't sampled, since it would have no effect.
    Json& material = gltf.json["materials"][0];
    material["normalTexture"] = {{"index", 99}, {"scale", 0}};
    material["occlusionTexture"] = {{"index", "one"}, {"strength", 0}};
    material["emissiveTexture"] = 7;
    material["extensions"] = {
        {"KHR_materials_clearcoat", {{"clearcoatTexture", gone}, {"clearcoatFactor", 0}}},
        {"KHR_materials_specular", {{"specularTexture", nowhere}, {"specularFactor", 0}}}};
    // One material that no surface has, and one without a material.
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", gone}}}});
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", nowhere}}}});
    gltf.addImage({{"bufferView", 99}});
    gltf.addImage({{"uri", {{"not", "text"}}}});
    gltf.json["textures"].push_back({{"source", "not a number"}});
    const auto input = folder.write("scene.glb", gltf.glb());
    for (const char* verb : {"info", "render"}) {
        const ProcessResult result = run(verb, input, folder / "output");
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_TRUE(warningsOf(result).empty()) << result.err;
    }
    EXPECT_TRUE(readFile(folder / "output") == soundPicture());
}

TEST(LeftOut, AnImageOfSeveralMaterialsIsWarnedAboutOnce) {
    const TempFolder folder;
    GltfBuilder gltf = soundScene();
    gltf.json["images"][0] = {{"uri", "gone.png"}};
    gltf.json["textures"].push_back({{"source", 0}});
    for (const int texture : {0, 1}) {
        const int material = gltf.addMaterial(
            {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
        gltf.addShapeNode(box(glm::vec3(0.5f)), {{"material", material}});
    }
    const ProcessResult result =
        run("render", folder.write("scene.glb", gltf.glb()), folder / "out.png");
    EXPECT_EQ(warningsOf(result).size(), 1u) << result.err;
}

TEST(LeftOut, AWebpIsDrawnAsThePngOfItsPixels) {
    GltfBuilder gltf = soundScene();
    gltf.json["images"][0] = embeddedIn(gltf, smallWebp());
    EXPECT_TRUE(pictureOf(gltf) == soundPicture());
}

TEST(LeftOut, TheWebpOfAnExtensionComesFirst) {
    GltfBuilder gltf = withExtension("EXT_texture_webp", smallWebp());
    gltf.json["images"][0] = {{"uri", "gone.png"}}; // never searched for
    EXPECT_TRUE(warningsAndPictureOf(gltf, soundPicture()).empty());
}

TEST(LeftOut, WhereAWebpIsBrokenTheTexturesOwnImageIsTaken) {
    for (const Bytes& image : {Bytes(10), animatedWebp()}) {
        const auto warnings =
            warningsAndPictureOf(withExtension("EXT_texture_webp", image), soundPicture());
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].find("images[1]"), std::string::npos) << warnings[0];
    }
}

TEST(LeftOut, TheTexturesOwnImageIsTakenBeforeABasisOne) {
    const GltfBuilder gltf = withExtension("KHR_texture_basisu", Bytes(10));
    EXPECT_TRUE(warningsAndPictureOf(gltf, soundPicture()).empty());
}

TEST(LeftOut, CastersWithHolesAreTheSameInWebp) {
    const TempFolder folder;
    const auto png = folder.write("png.glb", sheetWithHoles(true).glb());
    const auto webp = folder.write("webp.glb", sheetWithHoles(false).glb());
    const auto render = [&](const std::filesystem::path& scene,
                            const std::vector<std::string>& more) {
        std::vector<std::string> arguments = {"render", scene, folder / "out.png", "--size",
                                              "120x90"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const ProcessResult result = runEdgeshade(arguments);
        EXPECT_EQ(result.status, 0) << result.err;
        return readFile(folder / "out.png");
    };
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{}, {"--cast-masked"}, {"--cast-masked", "--mask"}})
        EXPECT_TRUE(render(webp, options) == render(png, options));
    EXPECT_FALSE(render(png, {"--cast-masked"}) == render(png, {}));
}

TEST(LeftOut, TheOracleLeavesOutWhatIsLeftOutOfThePicture) {
    for (const bool broken : {false, true}) {
        const TempFolder folder;
        GltfBuilder gltf = sheetWithHoles(false);
        if (broken) gltf.json["images"][0] = {{"uri", "gone.png"}};
        const ProcessResult result =
            runEdgeshade({"compare", folder.write("scene.glb", gltf.glb()), "--views", "2",
                          "--size", "96x72", "--cast-masked", "--report", "-"});
        if (result.status == 3) GTEST_SKIP() << result.err;
        ASSERT_EQ(result.status, 0) << result.err;
        // The oracle, which does not filter, is unreliable at a hole's edge; without holes it is
        // right.
        const Json report = Json::parse(result.out);
        EXPECT_GT(report["visible_pixels"], 1000);
        if (broken) {
            EXPECT_EQ(report["wrong_mask_beyond_1px"], 0);
        }
    }
}

} // namespace edgeshade::test
