// `render`: pictures as the options request them, and the same picture for every path of the data.
#include "src/image/decode.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace edgeshade::test {
namespace {

const std::string pavilion = std::string(EDGESHADE_ASSETS) + "/pavilion.glb";
const ChildProcess::Environment strictEs2 = {{"MESA_GLES_VERSION_OVERRIDE", "2.0"}};

/// Draws a scene of 320x180; more options replace these.
Bytes pictureOf(const std::string& scene, const std::vector<std::string>& more = {},
                const ChildProcess::Environment& environment = {}) {
    const TempFolder folder;
    std::vector<std::string> arguments = {"render", scene, folder / "picture.png"};
    if (std::find(more.begin(), more.end(), "--size") == more.end())
        arguments.insert(arguments.end(), {"--size", "320x180"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = runEdgeshade(arguments, environment);
    EXPECT_EQ(result.status, 0) << result.err;
    return result.status == 0 ? readFile(folder / "picture.png") : Bytes();
}

/// The pavilion drawn without options.
const Bytes& pavilionPicture() {
    static const Bytes picture = pictureOf(pavilion);
    return picture;
}

} // namespace

TEST(Rendering, APictureHasTheSizeThatWasAskedFor) {
    for (const auto& [width, height] : {std::pair(1, 1), {33, 7}, {640, 2}}) {
        const std::string size = std::to_string(width) + "x" + std::to_string(height);
        const Image image = decodeImage(pictureOf(pavilion, {"--size", size}), size);
        EXPECT_EQ(image.width, width);
        EXPECT_EQ(image.height, height);
    }
}

/// A camera at (5, 4, 6) that looks at (0, 0.5, 0), as a view matrix.
std::string viewMatrix() {
    std::ostringstream text;
    text.precision(17);
    const glm::dmat4 view = glm::lookAt(glm::dvec3(5, 4, 6), glm::dvec3(0, 0.5, 0), {0, 1, 0});
    for (int i = 0; i < 16; ++i)
        text << (i == 0 ? "" : ",") << view[i / 4][i % 4];
    return text.str();
}

TEST(Rendering, AViewMatrixIsACamera) {
    EXPECT_EQ(pictureOf(pavilion, {"--camera-from", "5,4,6", "--camera-to", "0,0.5,0"}),
              pictureOf(pavilion, {"--camera-matrix", viewMatrix()}));
}

TEST(Rendering, AnOrthographicPictureIsAsHighAsWasAskedFor) {
    // A cube of 1 from the front, in a picture of 4: a quarter of its height.
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(box(glm::vec3(0.5f)));
    const std::string file = folder.write("box.glb", gltf.glb());
    const Image image =
        decodeImage(pictureOf(file, {"--ortho", "4", "--camera-from", "0,0,9", "--camera-to",
                                     "0,0,0", "--size", "320x160", "--mask"}),
                    "box.png");
    int surface = 0;
    for (int y = 0; y < image.height; ++y)
        surface += image.rgba[4 * static_cast<std::size_t>(y * image.width + 160) + 3] != 0;
    EXPECT_NEAR(surface, 40, 1);
}

TEST(Rendering, PublishedRecordsAreRefusedInAnOrthographicPicture) {
    const TempFolder folder;
    const ProcessResult result =
        runEdgeshade({"render", pavilion, folder / "picture.png", "--ortho", "9", "--size", "64x48",
                      "--multiplicity", "reference-edge"});
    EXPECT_EQ(result.status, 3);
    EXPECT_NE(result.err.find("--multiplicity plane"), std::string::npos) << result.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "picture.png"));
}

TEST(Rendering, TexelsAreLookedUpAsTheSamplerSays) {
    const auto coloursWith = [](int magFilter) {
        const TempFolder folder;
        GltfBuilder gltf;
        gltf.addImage({{"uri", dataUri(smallPng(), "image/png")}});
        gltf.json["samplers"] = {{{"magFilter", magFilter}}};
        gltf.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
        gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
        gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", 0}});
        const Image image =
            decodeImage(pictureOf(folder.write("box.glb", gltf.glb()),
                                  {"--shading", "base", "--ambient", "1", "--camera-from", "3,3,6",
                                   "--camera-to", "0,0,0"}),
                        "box.png");
        std::set<std::array<std::uint8_t, 3>> colours;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            colours.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
        return colours.size();
    };
    EXPECT_LE(coloursWith(9728), 5u) << "nearest: four texels and what is behind them";
    EXPECT_GT(coloursWith(9729), 50u) << "linear";
}

/// A Radiance picture of 4 x 2 pixels in one colour, which share an exponent.
Bytes smallPanorama(std::uint8_t red, std::uint8_t green, std::uint8_t blue) {
    const std::string header = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 4\n";
    Bytes bytes(header.begin(), header.end());
    for (int i = 0; i < 8; ++i)
        bytes.insert(bytes.end(), {red, green, blue, 129});
    return bytes;
}

TEST(Rendering, SurfacesReflectTheEnvironmentThatWasAskedFor) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addMaterial({{"pbrMetallicRoughness", {{"metallicFactor", 1}, {"roughnessFactor", 0.2}}}});
    gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", 0}});
    const std::string file = folder.write("box.glb", gltf.glb());
    const std::string warm = folder.write("warm.hdr", smallPanorama(200, 100, 50));
    const auto middle = [&](const std::vector<std::string>& options) {
        const Image image = decodeImage(pictureOf(file, options), "box.png");
        const std::size_t i =
            4 * static_cast<std::size_t>(image.width * (image.height / 2) + image.width / 2);
        return glm::ivec3(image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]);
    };
    const glm::ivec3 neutral = middle({}), lit = middle({"--environment", warm}),
                     bright = middle({"--environment", warm, "--exposure", "1"});
    EXPECT_EQ(neutral.r, neutral.b);
    EXPECT_GT(lit.r, lit.g + 20);
    EXPECT_GT(lit.g, lit.b + 20);
    EXPECT_GT(bright.g, lit.g + 10);
    const ProcessResult missing = runEdgeshade(
        {"render", file, folder / "picture.png", "--environment", folder / "gone.hdr"});
    EXPECT_EQ(missing.status, 2);
    EXPECT_NE(missing.err.find("gone.hdr"), std::string::npos) << missing.err;
    EXPECT_FALSE(std::filesystem::exists(folder / "picture.png"));
}

TEST(Rendering, AGroundReceivesTheShadowOfWhatIsAboveIt) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(box({1, 1, 1}));
    const std::string file = folder.write("box.glb", gltf.glb());
    const std::vector<std::string> view = {"--sun", "-1,2,0",      "--camera-from",
                                           "0,9,9", "--camera-to", "0,0,0"};
    const auto darkPixels = [&](const std::vector<std::string>& ground) {
        std::vector<std::string> options = view;
        options.insert(options.end(), ground.begin(), ground.end());
        options.push_back("--mask");
        const Image mask = decodeImage(pictureOf(file, options), "mask.png");
        int dark = 0;
        for (std::size_t i = 0; i < mask.rgba.size(); i += 4)
            dark += mask.rgba[i] == 0 && mask.rgba[i + 3] == 255;
        return dark;
    };
    const int without = darkPixels({});
    EXPECT_EQ(darkPixels({"--ground", "off"}), without);
    EXPECT_GT(darkPixels({"--ground", "catcher"}), without + 300);
    EXPECT_EQ(darkPixels({"--ground", "#204060"}), darkPixels({"--ground", "catcher"}));
}

TEST(Rendering, CutoutsThatVolumesDoNotCountAreWarnedOf) {
    const TempFolder folder;
    const auto told = [&](const std::string& method) {
        return runEdgeshade({"render", pavilion, folder / "picture.png", "--size", "64x36",
                             "--cast-cutouts", "--shadows", method})
            .err;
    };
    EXPECT_NE(told("volumes").find("--cast-cutouts"), std::string::npos);
    EXPECT_EQ(told("primitive-map"), "");
}

TEST(Rendering, BaseShadingIsAsItWas) {
    // sRGB(0.5) * (0.35 + 0.65 * max(0, N.L)) under a sun from above, metal or not.
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addMaterial({{"emissiveFactor", {1, 1, 1}},
                      {"pbrMetallicRoughness", {{"baseColorFactor", {0.2140411, 0, 0, 1}}}}});
    gltf.addShapeNode(box({4, 0.1f, 4}), {{"material", 0}});
    const Image image =
        decodeImage(pictureOf(folder.write("box.glb", gltf.glb()),
                              {"--shading", "base", "--sun", "0,1,0", "--camera-from", "0,9,0.01",
                               "--camera-to", "0,0,0"}),
                    "box.png");
    const std::size_t i =
        4 * static_cast<std::size_t>(image.width * (image.height / 2) + image.width / 2);
    EXPECT_NEAR(image.rgba[i], 128, 1);
    EXPECT_EQ(image.rgba[i + 1], 0);
}

TEST(Rendering, CullShowsSingleSidedMaterialsFromTheirFrontAlone) {
    const TempFolder folder;
    const auto fromWithin = [&](bool doubleSided, const std::string& cull) {
        GltfBuilder gltf;
        gltf.addMaterial({{"doubleSided", doubleSided}});
        gltf.addShapeNode(box({1, 1, 1}), {{"material", 0}});
        return pictureOf(folder.write("box.glb", gltf.glb()),
                         {"--cull", cull, "--camera-from", "0,0,0.5", "--camera-to", "0,0,0"});
    };
    EXPECT_NE(fromWithin(false, "auto"), fromWithin(false, "off"));
    EXPECT_EQ(fromWithin(true, "auto"), fromWithin(true, "off"));
}

TEST(Rendering, ProposedSilhouettesDrawWhatAllDo) {
    for (const char* kind : {"picture", "mask"}) {
        std::vector<std::string> all = {"--silhouette", "all"},
                                 proposed = {"--silhouette", "proposed"};
        if (kind == std::string("mask")) {
            all.push_back("--mask");
            proposed.push_back("--mask");
        }
        EXPECT_EQ(pictureOf(pavilion, all), pictureOf(pavilion, proposed));
    }
}

TEST(Rendering, PrimitiveMapsDrawWhatVolumesDo) {
    for (const std::vector<std::string>& lights :
         {std::vector<std::string>{"--sun", "0.4,0.8,0.5"},
          {"--light", "0.3,1.4,0.2"},
          {"--light", "6,5,3", "--sun", "-0.5,1,0.2", "--light-range", "9"}})
        for (const char* kind : {"picture", "mask"}) {
            std::vector<std::string> counted = lights;
            if (kind == std::string("mask")) counted.push_back("--mask");
            std::vector<std::string> lookedUp = counted;
            lookedUp.insert(lookedUp.end(), {"--shadows", "primitive-map"});
            const Image a = decodeImage(pictureOf(pavilion, counted), "a.png");
            const Image b = decodeImage(pictureOf(pavilion, lookedUp), "b.png");
            std::size_t different = 0;
            for (std::size_t i = 0; i < a.rgba.size(); i += 4)
                different += std::abs(a.rgba[i] - b.rgba[i]) > 2;
            EXPECT_LE(different, a.rgba.size() / 4 / 1000) << kind << " of " << lights.front();
        }
}

TEST(Rendering, ReportsSayHowEachLightsShadowsAreMade) {
    const TempFolder folder;
    const auto lightsOf = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", pavilion, folder / "out.png", "--size", "64x48",
                                   "--shading", "base", "--report", folder / "report.json"});
        const ProcessResult result = runEdgeshade(more);
        EXPECT_EQ(result.status, 0) << result.err;
        const Bytes report = readFile(std::filesystem::path(folder / "report.json"));
        return nlohmann::json::parse(report.begin(), report.end())["lights"];
    };
    auto lights = lightsOf({"--light", "1,2,3", "--sun", "0.1,1,0.2", "--shadows", "auto"});
    ASSERT_EQ(lights.size(), 2u);
    EXPECT_EQ(lights[0]["position"], nlohmann::json({1.0, 2.0, 3.0, 1.0}));
    for (const auto& light : lights) {
        EXPECT_EQ(light["method"], "primitive-map");
        EXPECT_EQ(light["why"], "at rest");
        EXPECT_GT(light["bytes"], 0);
        EXPECT_GT(light["build_ms"], 0.0);
    }
    // 3 x 256 x 256 texels of distances, and as many of depth.
    lights = lightsOf({"--shadows", "map", "--map-size", "256", "--map-kind", "cascades",
                       "--cascades", "3", "--sun", "0.1,1,0.2"});
    EXPECT_EQ(lights[0]["method"], "map");
    EXPECT_EQ(lights[0]["bytes"], (3 * 4 + 4) * 256 * 256);
    EXPECT_NE(lights[0]["why"].get<std::string>().find("cascades"), std::string::npos);
    // Two texels for each, filtered moments; the warp's nodes and casters beside them.
    lights = lightsOf({"--shadows", "map", "--map-size", "256", "--map-kind", "warped", "--filter",
                       "msm", "--sun", "0.1,1,0.2"});
    EXPECT_GT(lights[0]["bytes"], (2 * 4 + 2 * 4) * 256 * 256);
    EXPECT_NE(lights[0]["why"].get<std::string>().find("four moments"), std::string::npos);
    lights = lightsOf({"--shadows", "primitive-map", "--gl-limits", "es2-minimum"});
    EXPECT_EQ(lights[0]["method"], "volumes");
    EXPECT_EQ(lights[0]["why"], "the GL can't sample float textures exactly");
    EXPECT_EQ(lightsOf({"--shadows", "primitive-map", "--cast-masked"})[0]["why"],
              "some casters are alpha-tested");
    EXPECT_EQ(lightsOf({"--shadows", "primitive-map", "--caster-error", "0.05"})[0]["why"],
              "casters are simplified");
    EXPECT_EQ(lightsOf({})[0]["method"], "volumes");
}

TEST(Rendering, WarnsOfLightsThatGetNoPrimitiveMapWhereOneWasAskedFor) {
    const TempFolder folder;
    const auto told = [&](const std::string& shadows) {
        return runEdgeshade({"render", pavilion, folder / "out.png", "--size", "64x48", "--shadows",
                             shadows, "--sun", "0.1,1,0.2", "--gl-limits", "es2-minimum"})
            .err;
    };
    EXPECT_NE(told("primitive-map")
                  .find("warning: Light 0: --shadows primitive-map is not for it: the GL can't "
                        "sample float textures exactly. Its shadows are those of volumes."),
              std::string::npos);
    EXPECT_EQ(told("auto").find("warning"), std::string::npos);
    EXPECT_EQ(told("volumes").find("warning"), std::string::npos);
}

TEST(Rendering, ComparingWarnsOnceOfLightsThatGetNoPrimitiveMap) {
    for (const std::vector<std::string>& light :
         {std::vector<std::string>{"--sun", "0.1,1,0.2"},
          {"--sun", "0.1,1,0.2", "--sun-angle", "0.53", "--light-samples", "2"}}) {
        std::vector<std::string> arguments = {
            "compare", pavilion,    "--size",        "64x48",       "--views",
            "2",       "--shadows", "primitive-map", "--gl-limits", "es2-minimum"};
        arguments.insert(arguments.end(), light.begin(), light.end());
        const ProcessResult result = runEdgeshade(arguments);
        ASSERT_EQ(result.status, 0) << result.err;
        const std::string sentence = "--shadows primitive-map is not for it: the GL can't sample "
                                     "float textures exactly. Its shadows are those of volumes.";
        const std::size_t first = result.err.find(sentence);
        EXPECT_NE(first, std::string::npos) << result.err;
        EXPECT_EQ(result.err.find(sentence, first + 1), std::string::npos);
    }
}

TEST(Rendering, InAStillAnAnimationMovesNothing) {
    const TempFolder folder;
    const ProcessResult result = runEdgeshade(
        {"render", pavilion, folder / "out.png", "--size", "64x48", "--shadows", "primitive-map",
         "--sun", "0.5,1,0.4", "--sun-angle", "0.53", "--report", "-"});
    ASSERT_EQ(result.status, 0) << result.err;
    const auto light = nlohmann::json::parse(result.out)["lights"][0];
    EXPECT_EQ(light["method"], "primitive-map") << light["why"];
}

TEST(Rendering, DebugTintsThePictureByWhatPrimitiveMapsHold) {
    EXPECT_NE(pictureOf(pavilion, {"--debug", "primitive-map", "--shadows", "primitive-map"}),
              pictureOf(pavilion, {"--shadows", "primitive-map"}));
}

TEST(Rendering, DebugTintsThePictureByItsVolumes) {
    EXPECT_NE(pictureOf(pavilion, {"--debug", "volumes"}), pavilionPicture());
    EXPECT_EQ(pictureOf(pavilion, {"--debug", "none"}), pavilionPicture());
    EXPECT_NE(pictureOf(pavilion, {"--debug", "volumes", "--layout", "published"}),
              pictureOf(pavilion, {"--debug", "volumes"}));
}

TEST(Rendering, ExplainsWhatIsDrawnAndWhy) {
    const TempFolder folder;
    const auto explained = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"render", pavilion, folder / "out.png", "--size", "64x48",
                                   "--shading", "base", "--explain", "--camera-from", "4,2,9"});
        const ProcessResult result = runEdgeshade(more);
        EXPECT_EQ(result.status, 0) << result.err;
        return result.out;
    };
    const std::string words = explained({"--light", "2,3,2"});
    for (const char* part : {"light 0, at 2,3,2: ", "those that can be silhouettes", "z-pass",
                             "the stencil count starts at ", "batch 0: "})
        EXPECT_NE(words.find(part), std::string::npos) << part << " is not in\n" << words;
    EXPECT_NE(explained({"--silhouette", "all"}).find("all "), std::string::npos);
    EXPECT_NE(
        explained({"--light", "2,3,2", "--light-range", "0.5"}).find("beyond the light's range"),
        std::string::npos);
    // The last pass of a grey mask draws the lamp's points as lights.
    const std::string points = explained(
        {"--light", "200,300,200", "--light-radius", "1", "--light-samples", "3", "--mask"});
    EXPECT_NE(points.find("the sum of its points"), std::string::npos) << points;
    for (const char* of : {"light 0, at ", "light 1, at ", "light 2, at "}) {
        double x = 0, y = 0, z = 0;
        const std::size_t found = points.find(of);
        ASSERT_NE(found, std::string::npos) << of << " is not in\n" << points;
        ASSERT_EQ(std::sscanf(points.c_str() + found + std::strlen(of), "%lf,%lf,%lf", &x, &y, &z),
                  3);
        EXPECT_LT(glm::distance(glm::dvec3(x, y, z), glm::dvec3(200, 300, 200)), 1.1) << points;
    }
    EXPECT_NE(explained({"--light", "200,300,200", "--light-radius", "1", "--light-samples", "3",
                         "--mask", "--layout", "brute-force"})
                  .find("the sum of its points"),
              std::string::npos);
    EXPECT_NE(explained({"--shadows", "map"}).find("shadow maps"), std::string::npos);
    const std::string maps =
        explained({"--shadows", "map", "--map-size", "256", "--filter", "vsm", "--map-kind",
                   "cascades", "--cascades", "3", "--sun", "0,1,0", "--light", "2,3,2"});
    EXPECT_NE(maps.find("up to 3 cascades of 256 x 256 texels, variance, 5 wide"),
              std::string::npos)
        << maps;
    EXPECT_NE(maps.find("a cube's six faces of 256 x 256 texels"), std::string::npos) << maps;
    EXPECT_NE(explained({"--shadows", "planar", "--planes", "2"}).find("onto 2 planes"),
              std::string::npos);
    EXPECT_NE(explained({"--layout", "brute-force"}).find("z-fail with caps"), std::string::npos);
    EXPECT_NE(explained({"--layout", "brute-force", "--count", "z-pass", "--light", "2,3,2"})
                  .find("light 0: z-pass, near caps"),
              std::string::npos);
    const std::string warped = explained({"--shadows", "map", "--map-size", "256", "--map-kind",
                                          "warped", "--warp", "non-orthogonal", "--sun", "0,1,0"});
    EXPECT_NE(warped.find("one map, warped by a non-orthogonal grid, of 256 x 256 texels"),
              std::string::npos)
        << warped;
    EXPECT_NE(explained({"--layout", "published"}).find("opposite-vertex records"),
              std::string::npos);
}

TEST(Rendering, DrawingTwiceGivesTheSameFile) {
    EXPECT_EQ(pictureOf(pavilion), pavilionPicture());
}

TEST(Rendering, ThePictureShowsSomething) {
    const Image image = decodeImage(pavilionPicture(), "picture");
    const std::size_t middle = std::size_t{4} * (90 * 320 + 160);
    EXPECT_FALSE(std::equal(image.rgba.begin(), image.rgba.begin() + 4,
                            image.rgba.begin() + static_cast<std::ptrdiff_t>(middle)));
    EXPECT_NE(pictureOf(pavilion, {"--shadows", "none"}), pavilionPicture());
}

TEST(Rendering, AMaskIsBlackWhiteOrClear) {
    const Image image = decodeImage(pictureOf(pavilion, {"--mask"}), "mask");
    std::size_t lit = 0, dark = 0, clear = 0;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        const std::array<std::uint8_t, 4> pixel = {image.rgba[i], image.rgba[i + 1],
                                                   image.rgba[i + 2], image.rgba[i + 3]};
        if (pixel == std::array<std::uint8_t, 4>{255, 255, 255, 255})
            ++lit;
        else if (pixel == std::array<std::uint8_t, 4>{0, 0, 0, 255})
            ++dark;
        else if (pixel == std::array<std::uint8_t, 4>{0, 0, 0, 0})
            ++clear;
    }
    EXPECT_EQ(lit + dark + clear, image.rgba.size() / 4);
    EXPECT_GT(lit, 0u);
    EXPECT_GT(dark, 0u);
    EXPECT_GT(clear, 0u);
}

TEST(Rendering, SoftMapsMakeAMaskGreyWithoutCountingPoints) {
    const auto greysOf = [](const std::vector<std::string>& more) {
        std::vector<std::string> words = {"--mask", "--shadows", "map"};
        words.insert(words.end(), more.begin(), more.end());
        const Image mask = decodeImage(pictureOf(pavilion, words), "mask");
        std::set<int> greys;
        for (std::size_t i = 0; i < mask.rgba.size(); i += 4)
            if (mask.rgba[i + 3] == 255) greys.insert(mask.rgba[i]);
        return greys;
    };
    const std::vector<std::string> sun = {"--sun", "1,1,0.5", "--sun-angle", "6"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.end(), sun.begin(), sun.end());
        return greysOf(more);
    };
    EXPECT_GT(with({"--soft", "pcss"}).size(), 10u);
    EXPECT_GT(with({"--soft", "pcss", "--smooth", "2"}).size(), 10u);
    EXPECT_GT(with({"--soft", "pcf", "--pcf", "5"}).size(), 10u);
    EXPECT_EQ(with({"--soft", "pcf"}), (std::set<int>{0, 255}));
    EXPECT_EQ(with({"--soft", "none", "--light-samples", "2"}), (std::set<int>{0, 128, 255}));
}

TEST(Rendering, PackedFilesGiveThePictureOfTheirSource) {
    const TempFolder folder;
    for (const char* encoding : {"expanded", "indexed", "none"}) {
        SCOPED_TRACE(encoding);
        const std::string file = folder / (std::string(encoding) + ".glb");
        ASSERT_EQ(runEdgeshade({"pack", pavilion, file, "--encoding", encoding}).status, 0);
        EXPECT_TRUE(pictureOf(file) == pavilionPicture());
        EXPECT_TRUE(pictureOf(file, {"--mask"}) == pictureOf(pavilion, {"--mask"}));
    }
}

TEST(Rendering, EveryWayOfInstancingGivesTheSamePicture) {
    for (const char* way : {"on", "off", "multi-draw"}) {
        SCOPED_TRACE(way);
        EXPECT_TRUE(pictureOf(pavilion, {"--instancing", way}) == pavilionPicture());
    }
}

TEST(Rendering, AStrictEs2ContextGivesTheSamePicture) {
    EXPECT_TRUE(pictureOf(pavilion, {}, strictEs2) == pavilionPicture());
    EXPECT_TRUE(pictureOf(pavilion, {"--instancing", "off"}, strictEs2) == pavilionPicture());
}

TEST(Rendering, WithoutInstancedDrawingAskingForItIsNotPossibleHere) {
    const TempFolder folder;
    for (const char* way : {"on", "multi-draw"}) {
        SCOPED_TRACE(way);
        const ProcessResult result = runEdgeshade(
            {"render", pavilion, folder / "picture.png", "--size", "32x18", "--instancing", way},
            strictEs2);
        EXPECT_EQ(result.status, 3);
        EXPECT_NE(result.err.find("--instancing"), std::string::npos) << result.err;
        EXPECT_TRUE(folder.names().empty());
    }
}

TEST(Rendering, ComparingDoesNotFallBackEither) {
    const ProcessResult result = runEdgeshade(
        {"compare", pavilion, "--views", "1", "--size", "32x18", "--instancing", "on"}, strictEs2);
    EXPECT_EQ(result.status, 3);
    if (result.err.find("Embree") != std::string::npos) GTEST_SKIP() << result.err;
    EXPECT_NE(result.err.find("--instancing"), std::string::npos) << result.err;
}

TEST(Rendering, OtherCasterSettingsThanThoseOfThePackedFileAreSaid) {
    const TempFolder folder;
    const std::string file = folder / "packed.glb";
    ASSERT_EQ(runEdgeshade({"pack", pavilion, file}).status, 0);
    const ProcessResult result =
        runEdgeshade({"render", file, folder / "picture.png", "--size", "32x18", "--cast-masked"});
    EXPECT_EQ(result.status, 0);
    EXPECT_NE(result.err.find("warning: "), std::string::npos);
    EXPECT_TRUE(pictureOf(file, {"--cast-masked"}) == pictureOf(pavilion, {"--cast-masked"}));
}

TEST(Rendering, SimplifiedCastersOfAPackedFileCastWhatThoseMadeAtLoadCast) {
    const TempFolder folder;
    const std::string file = folder / "packed.glb";
    ASSERT_EQ(runEdgeshade({"pack", pavilion, file, "--caster-error", "0.05"}).status, 0);
    const Bytes coarse = pictureOf(pavilion, {"--caster-error", "0.05"});
    EXPECT_TRUE(pictureOf(file, {}) == coarse);
    EXPECT_TRUE(pictureOf(file, {"--layout", "published"}) ==
                pictureOf(pavilion, {"--caster-error", "0.05", "--layout", "published"}));
    EXPECT_FALSE(pictureOf(pavilion, {}) == coarse);
    // The file also keeps the tolerance of flat edges.
    ASSERT_EQ(runEdgeshade({"pack", pavilion, file, "--flat-tolerance", "20"}).status, 0);
    EXPECT_TRUE(pictureOf(file, {}) == pictureOf(pavilion, {"--flat-tolerance", "20"}));
    // The picture without shadows stays the same.
    EXPECT_TRUE(pictureOf(file, {"--shadows", "none"}) ==
                pictureOf(pavilion, {"--shadows", "none"}));
}

TEST(Rendering, ASceneWithoutTrianglesIsAnEmptyPicture) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addNode({{"name", "nothing"}});
    const Image image = decodeImage(
        pictureOf(folder.write("empty.glb", gltf.glb()), {"--mask", "--size", "8x8"}), "picture");
    EXPECT_EQ(image.rgba, std::vector<std::uint8_t>(8 * 8 * 4, 0));
}

TEST(Rendering, EveryNumberOfSamplesThatTheGlHasWorks) {
    const Image image = decodeImage(pictureOf(pavilion, {"--samples", "4"}), "picture");
    EXPECT_EQ(image.width, 320);
}

TEST(Rendering, AVariantIsDrawn) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.useExtension("KHR_materials_variants", false);
    gltf.addMaterial({{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}});
    gltf.addMaterial({{"alphaMode", "BLEND"}});
    gltf.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "glass"}}};
    const Json mappings = {{{"material", 1}, {"variants", {0}}}};
    gltf.addShapeNode(
        box(glm::vec3(1.0f)),
        {{"material", 0}, {"extensions", {{"KHR_materials_variants", {{"mappings", mappings}}}}}});
    const auto scene = folder.write("scene.glb", gltf.glb());
    const auto packedScene = folder / "packed.glb";
    ASSERT_EQ(runEdgeshade({"pack", scene, packedScene, "--encoding", "indexed"}).status, 0);

    const Bytes own = pictureOf(scene), glass = pictureOf(scene, {"--variant", "glass"});
    EXPECT_NE(own, glass);
    // The packed data no longer fit these casters; they are not used, and no warning is needed.
    EXPECT_EQ(pictureOf(packedScene, {"--variant", "glass"}), glass);
    EXPECT_EQ(pictureOf(packedScene), own);
    const ProcessResult unknown = runEdgeshade(
        {"render", scene, folder / "picture.png", "--size", "320x180", "--variant", "gold"});
    EXPECT_EQ(unknown.status, 0);
    EXPECT_NE(unknown.err.find("warning: "), std::string::npos);
    EXPECT_NE(unknown.err.find("has no variant 'gold'; it has 'glass'."), std::string::npos);
    EXPECT_EQ(readFile(folder / "picture.png"), own);
    EXPECT_NE(runEdgeshade({"info", scene}).out.find("variant                   glass"),
              std::string::npos);
}

TEST(Rendering, TheOracleKnowsUnlitSurfaces) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.useExtension("KHR_materials_unlit");
    gltf.addMaterial({{"extensions", {{"KHR_materials_unlit", Json::object()}}}});
    gltf.addShapeNode(box(glm::vec3(1.0f)), {{"material", 0}});
    gltf.addNode({{"mesh", gltf.addShape(box(glm::vec3(1.0f)))},
                  {"translation", {0, -1.25, 0}},
                  {"scale", {4.0, 0.1, 4.0}}});
    const auto scene = folder.write("scene.glb", gltf.glb());
    const ProcessResult result =
        runEdgeshade({"compare", scene, "--size", "64x48", "--report", folder / "report.json"});
    if (result.status == 3) GTEST_SKIP() << result.err; // built without the oracle
    ASSERT_EQ(result.status, 0) << result.err;
    const Bytes text = readFile(folder / "report.json");
    const Json report = Json::parse(text.begin(), text.end());
    EXPECT_GT(report["visible_pixels"], 10000);
    EXPECT_EQ(report["wrong_image_beyond_1px"], 0);
    EXPECT_LE(report["wrong_image_pixels"], report["wrong_mask_pixels"]);
}

} // namespace edgeshade::test
