// Wrong usage: status 1, a message that names the option and the value, nothing written.
#include "tests/cli/message.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/run_edgeshade.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade::test {
namespace {

struct BadUsage {
    std::string name;
    std::vector<std::string> arguments; ///< IN and OUT stand for a sound scene and a fresh file
    std::vector<std::string> words;

    friend void PrintTo(const BadUsage& row, std::ostream* stream) { *stream << row.name; }
};

/// `render` with further arguments; `words` default to them.
BadUsage badRender(const std::string& name, const std::vector<std::string>& more,
                   const std::vector<std::string>& words = {}) {
    BadUsage row{name, {"render", "IN", "OUT"}, words.empty() ? more : words};
    row.arguments.insert(row.arguments.end(), more.begin(), more.end());
    return row;
}

BadUsage sunAt(const std::string& name, const std::string& place, const std::string& time,
               const std::vector<std::string>& words) {
    return badRender(name, {"--place", place, "--time-of-day", time}, words);
}

/// `render` with a valid sun by place and time.
BadUsage atNoon(const std::string& name, const std::vector<std::string>& more,
                const std::vector<std::string>& words = {}) {
    BadUsage row = badRender(name, more, words);
    row.arguments.insert(row.arguments.end(),
                         {"--place", "48.1,11.6", "--time-of-day", "2026-06-21T14:30+02:00"});
    return row;
}

/// A verb with more lights than a picture can have; the last one is a sun.
BadUsage tooManyLights(const std::string& name, std::vector<std::string> verb) {
    for (int i = 0; i < 1000; ++i)
        verb.insert(verb.end(), {"--light", "1,2,3"});
    verb.insert(verb.end(), {"--sun", "0,1,0"});
    return {name, verb, {"More than 1000 lights were requested"}};
}

const BadUsage usages[] = {
    {"NoVerb", {}, {}},
    {"UnknownVerb", {"shade", "IN", "OUT"}, {"shade"}},
    {"NoInput", {"info"}, {"FILE"}},
    {"PackWithoutOutput", {"pack", "IN"}, {"OUT"}},
    {"RenderWithoutOutput", {"render", "IN"}, {"OUT"}},
    {"TooManyFiles", {"pack", "IN", "OUT", "third.glb"}, {"third.glb"}},
    {"UnknownOption", {"pack", "IN", "OUT", "--fast"}, {"There is no option --fast"}},
    {"MistypedOption", {"render", "IN", "OUT", "--shadow", "map"}, {"--shadows", "meant"}},
    {"MistypedOptionWithItsValue",
     {"render", "IN", "OUT", "--camera-form=1,2,3"},
     {"no option --camera-form;", "--camera-from"}},
    {"MistypedSetting",
     {"compare", "IN", "--against", "shadow=map"},
     {"--against shadow=map", "is --shadows meant?"}},
    {"RemovedSetting",
     {"bench", "IN", "--against", "volume-ends=cost"},
     {"--volume-ends any more", "docs/what-did-not-pay.md"}},
    {"RemovedVolumeScissors",
     {"render", "IN", "OUT", "--volume-scissors", "on"},
     {"--volume-scissors any more", "docs/what-did-not-pay.md"}},
    {"RemovedAmbientTarget",
     {"render", "IN", "OUT", "--ambient-target", "on"},
     {"--ambient-target any more"}},
    {"RemovedCasterCulling",
     {"view", "IN", "--caster-culling", "on"},
     {"--caster-culling any more", "--shadows auto"}},
    {"RemovedCullSolids",
     {"render", "IN", "OUT", "--cull-solids", "on"},
     {"--cull-solids any more", "--cull auto"}},
    {"RemovedVolumeEnds",
     {"render", "IN", "OUT", "--volume-ends", "cost"},
     {"--volume-ends any more"}},
    {"OptionOfAnotherVerb", {"info", "IN", "--mask"}, {"--mask"}},
    {"OptionWithoutValue", {"render", "IN", "OUT", "--size"}, {"--size"}},
    badRender("CutoutsAndWholeTriangles", {"--cast-cutouts", "--cast-masked"}),
    badRender("SoftWithoutMaps", {"--soft", "pcss", "--light", "1,2,3", "--light-radius", "0.1"},
              {"--soft needs --shadows map"}),
    badRender("SoftWithoutAnExtent", {"--shadows", "map", "--soft", "pcss", "--light", "1,2,3"},
              {"--soft pcss needs a light with an extent"}),
    badRender("SoftAndPoints",
              {"--shadows", "map", "--soft", "pcss", "--sun", "0,1,0", "--sun-angle", "1",
               "--light-samples", "16"},
              {"--light-samples does not go with --soft"}),
    badRender("SoftOfAnotherWord",
              {"--shadows", "map", "--soft", "vsm", "--sun", "0,1,0", "--sun-angle", "1"},
              {"--soft", "vsm"}),
    badRender("FilterWithoutMaps", {"--filter", "vsm"}, {"--filter needs --shadows map"}),
    badRender("MapKindWithoutMaps", {"--map-kind", "cascades"}, {"--map-kind needs --shadows map"}),
    badRender("FilterOfAnotherWord", {"--shadows", "map", "--filter", "moments"},
              {"--filter", "moments"}),
    badRender("MapKindOfAnotherWord", {"--shadows", "map", "--map-kind", "trapezoid"},
              {"--map-kind", "trapezoid"}),
    badRender("CascadesWithoutCascades", {"--shadows", "map", "--sun", "0,1,0", "--cascades", "2"},
              {"--cascades needs --map-kind cascades"}),
    badRender("TooManyCascades",
              {"--shadows", "map", "--sun", "0,1,0", "--map-kind", "cascades", "--cascades", "5"},
              {"--cascades", "5"}),
    badRender("CascadesOfALamp", {"--shadows", "map", "--light", "1,2,3", "--map-kind", "cascades"},
              {"--map-kind cascades needs a sun"}),
    badRender("WarpWithoutWarping", {"--shadows", "map", "--sun", "0,1,0", "--warp", "rectilinear"},
              {"--warp needs --map-kind warped"}),
    badRender("WarpOfAnotherWord",
              {"--shadows", "map", "--sun", "0,1,0", "--map-kind", "warped", "--warp", "rtw"},
              {"--warp", "rtw"}),
    badRender("WarpedMapOfALamp", {"--shadows", "map", "--light", "1,2,3", "--map-kind", "warped"},
              {"--map-kind warped needs a sun"}),
    badRender("ParaboloidOfASun",
              {"--shadows", "map", "--sun", "0,1,0", "--map-kind", "paraboloid"},
              {"--map-kind paraboloid needs a lamp"}),
    badRender("FilterNoneOfThreeTexels", {"--shadows", "map", "--filter", "none", "--pcf", "3"},
              {"--pcf 3 does not go with --filter none"}),
    badRender("FilterAndAnotherSoft",
              {"--shadows", "map", "--filter", "vsm", "--soft", "pcss", "--sun", "0,1,0",
               "--sun-angle", "1"},
              {"--filter vsm does not go with --soft pcss"}),
    badRender("FilterPcssWithoutAnExtent", {"--shadows", "map", "--filter", "pcss"},
              {"--filter pcss needs a light with an extent"}),
    badRender("PcssOfCascades",
              {"--shadows", "map", "--filter", "pcss", "--map-kind", "cascades", "--sun", "0,1,0",
               "--sun-angle", "1"},
              {"need --map-kind cube"}),
    {"CascadesOfALampAgainst",
     {"compare", "IN", "--views", "1", "--light", "1,2,3", "--against",
      "shadows=map,map-kind=cascades"},
     {"--map-kind cascades needs a sun"}},
    {"SoftAgainstWithoutAnExtent",
     {"bench", "IN", "--frames", "1", "--against", "shadows=map,soft=pcss"},
     {"--soft pcss needs a light with an extent"}},
    badRender("CullWithoutAWord", {"--cull"}),
    badRender("CullOfAnotherWord", {"--cull", "back"}),
    badRender("CullAndPublishedRecords", {"--cull", "auto", "--layout", "published"}),
    badRender("CullAndBruteForce", {"--cull", "auto", "--layout", "brute-force"},
              {"--cull auto", "brute-force"}),
    badRender("CountOfPublishedRecords", {"--layout", "published", "--count", "z-pass"},
              {"--count needs --layout brute-force"}),
    badRender("CountWithoutBruteForce", {"--count", "z-fail"},
              {"--count needs --layout brute-force"}),
    badRender("CountOfAnotherWord", {"--layout", "brute-force", "--count", "zp+"},
              {"--count", "zp+", "z-fail, z-pass"}),
    badRender("EdgesOfBruteForce", {"--layout", "brute-force", "--multiplicity", "single-edge"},
              {"--multiplicity single-edge needs --layout published"}),
    badRender("TrianglesOfPublishedRecords",
              {"--layout", "published", "--multiplicity", "triangle"},
              {"--multiplicity triangle needs --layout brute-force"}),
    badRender("MultiDrawOfBruteForce", {"--layout", "brute-force", "--instancing", "multi-draw"},
              {"--instancing multi-draw", "--layout brute-force"}),
    badRender("PlanesOfVolumes", {"--planes", "4"}, {"--planes needs --shadows planar"}),
    badRender("NoPlanes", {"--shadows", "planar", "--planes", "0"}, {"--planes", "0"}),
    badRender("TooManyPlanes", {"--shadows", "planar", "--planes", "65"}, {"--planes", "65"}),
    badRender("DebugOfPlanes", {"--debug", "volumes", "--shadows", "planar"},
              {"--debug volumes", "--shadows volumes"}),
    {"PlanesOfMapsAgainst",
     {"bench", "IN", "--frames", "1", "--against", "shadows=map,planes=4"},
     {"--planes needs --shadows planar"}},
    badRender("GroundOfNoColour", {"--ground", "lava"}),
    badRender("GroundOfAShortColour", {"--ground", "#fff"}),
    {"UnknownEncoding", {"pack", "IN", "OUT", "--encoding", "zip"}, {"--encoding", "zip"}},
    {"EncodingByNumber", {"pack", "IN", "OUT", "--encoding", "0"}, {"--encoding", "0"}},
    {"NegativeTolerance",
     {"pack", "IN", "OUT", "--weld-tolerance", "-1"},
     {"--weld-tolerance", "-1"}},
    {"ToleranceNaN", {"pack", "IN", "OUT", "--weld-tolerance", "nan"}, {"--weld-tolerance", "nan"}},
    {"ToleranceInfinite",
     {"pack", "IN", "OUT", "--weld-tolerance", "inf"},
     {"--weld-tolerance", "inf"}},
    {"CasterErrorNegative",
     {"pack", "IN", "OUT", "--caster-error", "-0.1"},
     {"--caster-error", "-0.1"}},
    {"CasterErrorInfinite", {"info", "IN", "--caster-error", "inf"}, {"--caster-error", "inf"}},
    {"CasterErrorIsText",
     {"render", "IN", "OUT", "--caster-error", "1%"},
     {"--caster-error", "1%"}},
    {"FlatToleranceNegative",
     {"render", "IN", "OUT", "--flat-tolerance", "-1"},
     {"--flat-tolerance", "-1"}},
    {"FlatToleranceTooLarge",
     {"pack", "IN", "OUT", "--flat-tolerance", "45"},
     {"--flat-tolerance", "45", "not below"}},
    {"ToleranceIsText", {"info", "IN", "--weld-tolerance", "1mm"}, {"--weld-tolerance", "1mm"}},
    {"LimitOfZero", {"info", "IN", "--max-triangles", "0"}, {"--max-triangles", "'0'"}},
    {"LimitNegative", {"pack", "IN", "OUT", "--max-nodes", "-1"}, {"--max-nodes", "-1"}},
    {"LimitIsText", {"info", "IN", "--max-node-depth", "deep"}, {"--max-node-depth", "deep"}},
    {"LimitOfUnknownUnit", {"info", "IN", "--max-memory", "4T"}, {"--max-memory", "4T"}},
    {"LimitOfTooManyUnits", {"info", "IN", "--max-file", "1KB"}, {"--max-file", "1KB"}},
    {"LimitOfACountWithAUnit", {"info", "IN", "--max-nodes", "1K"}, {"--max-nodes", "1K"}},
    {"LimitPast64Bits",
     {"info", "IN", "--max-memory", "99999999999G"},
     {"--max-memory", "99999999999G"}},
    badRender("SizeOfZero", {"--size", "0x0"}),
    badRender("SizeIsText", {"--size", "abc"}),
    badRender("SizeOfOneNumber", {"--size", "640"}),
    badRender("SizeOfThreeNumbers", {"--size", "64x48x3"}),
    badRender("SizeNegative", {"--size", "-64x48"}),
    badRender("SizeTooLarge", {"--size", "99999999999x1"}),
    badRender("CameraMatrixTooShort", {"--camera-matrix", "1,0,0,0,0,1"},
              {"--camera-matrix", "16"}),
    badRender("CameraMatrixIsText", {"--camera-matrix", "1,0,0,0,0,1,0,0,0,0,one,0,0,0,0,1"},
              {"--camera-matrix", "one"}),
    badRender("CameraMatrixShears", {"--camera-matrix", "1,0,0,0,1,1,0,0,0,0,1,0,0,0,0,1"},
              {"camera's matrix", "shears"}),
    badRender("CameraMatrixMirrors", {"--camera-matrix", "-1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"},
              {"camera's matrix", "mirrors"}),
    badRender("CameraMatrixWithCamera",
              {"--camera-from", "1,2,3", "--camera-matrix", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"},
              {"--camera-matrix", "--camera-from"}),
    badRender("OrthoOfZero", {"--ortho", "0"}),
    badRender("OrthoIsText", {"--ortho", "high"}),
    badRender("OrthoWithNear", {"--ortho", "3", "--near", "0.1"}, {"--near", "--ortho"}),
    {"CameraMatrixWithViews",
     {"compare", "IN", "--views", "2", "--camera-matrix", "1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1"},
     {"--camera-matrix", "--views"}},
    badRender("FovOfZero", {"--fov", "0"}),
    badRender("FovOf180", {"--fov", "180"}),
    badRender("FovNaN", {"--fov", "nan"}),
    badRender("FovIsText", {"--fov", "wide"}),
    badRender("NearOfZero", {"--near", "0"}),
    badRender("NearNegative", {"--near", "-1"}),
    badRender("NearIsText", {"--near", "close"}),
    badRender("LightOfTwoNumbers", {"--light", "1,2"}),
    badRender("LightOfFourNumbers", {"--light", "1,2,3,4"}),
    badRender("LightIsText", {"--light", "a,b,c"}, {"--light", "'a'"}),
    badRender("LightInfinite", {"--light", "1,inf,0"}, {"--light", "'inf'"}),
    badRender("LightOfEmptyNumbers", {"--light", ",,"}, {"--light"}),
    badRender("SunWithoutDirection", {"--sun", "0,0,0"}),
    badRender("PlaceWithoutTime", {"--place", "48.1,11.6"}, {"--place", "--time-of-day"}),
    badRender("TimeWithoutPlace", {"--time-of-day", "2026-06-21T14:30Z"},
              {"--time-of-day", "--place"}),
    badRender("NorthWithoutPlace", {"--north", "10"}, {"--north", "--place"}),
    atNoon("PlaceAndSun", {"--sun", "0,1,0"}, {"--place", "--sun"}),
    atNoon("PlaceAndLightsOfTheFile", {"--lights", "file"}, {"--place", "--lights"}),
    atNoon("NorthIsText", {"--north", "up"}),
    atNoon("NorthNaN", {"--north", "nan"}),
    atNoon("NorthBeyondATurn", {"--north", "361"}),
    atNoon("PlaceTwice", {"--place", "1,2"}, {"--place"}),
    sunAt("PlaceOfOneNumber", "48.1", "2026-06-21T14:30Z", {"--place", "LAT,LON"}),
    sunAt("PlaceIsText", "Munich,Bavaria", "2026-06-21T14:30Z", {"--place", "Munich"}),
    sunAt("PlaceOfThreeNumbers", "48,11,520", "2026-06-21T14:30Z", {"--place"}),
    sunAt("LatitudePastThePole", "90.5,0", "2026-06-21T14:30Z", {"--place", "90.5", "latitude"}),
    sunAt("LongitudePastTheDateLine", "0,-181", "2026-06-21T14:30Z",
          {"--place", "-181", "longitude"}),
    sunAt("PlaceInfinite", "inf,0", "2026-06-21T14:30Z", {"--place", "inf"}),
    sunAt("TimeIsText", "0,0", "noon", {"--time-of-day", "'noon'", "2026-06-21T14:30+02:00"}),
    sunAt("TimeWithoutOffset", "0,0", "2026-06-21T14:30", {"--time-of-day", "offset from UTC"}),
    sunAt("TimeOfNoLeapDay", "0,0", "2025-02-29T12:00Z",
          {"--time-of-day", "month 2 of 2025 has no day 29"}),
    sunAt("TimeOfAnotherCentury", "0,0", "1776-07-04T12:00Z", {"--time-of-day", "1900 and 2100"}),
    badRender("CameraIsText", {"--camera-from", "here"}),
    badRender("CameraWithoutDirection", {"--camera-from", "1,2,3", "--camera-to", "1,2,3"},
              {"--camera-from", "--camera-to"}),
    badRender("UnknownShadows", {"--shadows", "foo"}),
    badRender("UnknownMultiplicity", {"--multiplicity", "foo"}),
    badRender("DebugOfAMask", {"--debug", "volumes", "--mask"}),
    badRender("DebugOfMaps", {"--debug", "volumes", "--shadows", "map"},
              {"--debug volumes", "--shadows volumes"}),
    badRender("DebugOfPrimitiveMapsWithoutAny", {"--debug", "primitive-map"},
              {"--debug primitive-map", "--shadows primitive-map"}),
    badRender("PrimitiveMapMemoryOfVolumes", {"--primitive-map-memory", "100000"},
              {"--primitive-map-memory", "--shadows lookup"}),
    badRender("PrimitiveMapMemoryTooSmall",
              {"--shadows", "primitive-map", "--primitive-map-memory", "12"},
              {"--primitive-map-memory", "12"}),
    badRender("UnknownDebug", {"--debug", "caps"}),
    badRender("UnknownSilhouettes", {"--silhouette", "some"}),
    badRender("ProposedSilhouettesOfPublishedRecords",
              {"--silhouette", "proposed", "--layout", "published"},
              {"--silhouette proposed", "--layout adapted"}),
    badRender("UnknownInstancing", {"--instancing", "foo"}),
    badRender("SamplesNegative", {"--samples", "-1"}),
    badRender("SamplesIsText", {"--samples", "four"}),
    badRender("AmbientAboveOne", {"--ambient", "1.5"}),
    badRender("UnknownShading", {"--shading", "toon"}),
    badRender("ExposureNaN", {"--exposure", "nan"}),
    badRender("ExposureOfBaseShading", {"--shading", "base", "--exposure", "1"},
              {"--exposure needs --shading full"}),
    badRender("EnvironmentOfBaseShading", {"--shading", "base", "--environment", "sky.hdr"},
              {"--environment needs --shading full"}),
    {"AgainstCastersOfANegativeError",
     {"bench", "IN", "--against", "caster-error=-1"},
     {"--against", "--caster-error", "-1"}},
    {"AgainstOtherSurfacesThatCast",
     {"compare", "IN", "--against", "cast-masked=1"},
     {"--against", "cast-masked"}},
    {"BenchOfNothing", {"bench"}, {"FILE", "--synthetic"}},
    {"BenchOfSceneAndSynthetic", {"bench", "IN", "--synthetic"}, {"--synthetic", "FILE"}},
    {"BenchSyntheticWithSize", {"bench", "--synthetic", "--size", "64x64"}, {"--size"}},
    {"BenchSyntheticOfPlanes",
     {"bench", "--synthetic", "--multiplicity", "plane"},
     {"--multiplicity", "--synthetic"}},
    {"BenchOfNoFrames", {"bench", "IN", "--frames", "0"}, {"--frames", "0"}},
    {"BenchWarmUpNegative", {"bench", "IN", "--warm-up", "-1"}, {"--warm-up", "-1"}},
    {"BenchTwoKindsOfSize",
     {"bench", "IN", "--size", "64x64", "--sizes", "all"},
     {"--size", "--sizes"}},
    {"BenchSizesIsText", {"bench", "IN", "--sizes", "64x64,big"}, {"--sizes", "big"}},
    {"BenchSizesOfNothing", {"bench", "IN", "--sizes", ","}, {"--sizes"}},
    {"BenchUnknownTiming", {"bench", "IN", "--timing", "guess"}, {"--timing", "guess"}},
    {"BenchAgainstNoPair", {"bench", "IN", "--against", "map"}, {"--against", "map"}},
    {"BenchAgainstUnknownOption",
     {"bench", "IN", "--against", "speed=high"},
     {"--against", "speed"}},
    {"BenchAgainstUnknownValue",
     {"bench", "IN", "--against", "shadows=soft"},
     {"--against", "soft"}},
    {"BenchAgainstMapSizeWithoutMap",
     {"bench", "IN", "--against", "map-size=512"},
     {"--map-size", "--shadows map"}},
    {"BenchAgainstMaskScaleOfAMap",
     {"bench", "IN", "--against", "shadows=map,mask-scale=1/2"},
     {"--mask-scale", "--shadows volumes"}},
    {"MaskScaleOfAMap",
     {"render", "IN", "OUT", "--shadows", "map", "--mask-scale", "1/2"},
     {"--mask-scale", "--shadows volumes"}},
    tooManyLights("LightsOfARenderTooMany", {"render", "IN", "OUT"}),
    tooManyLights("LightsOfACompareTooMany", {"compare", "IN"}),
    tooManyLights("LightsOfABenchTooMany", {"bench", "IN"}),
    tooManyLights("LightsOfATradeoffTooMany", {"tradeoff", "IN"}),
    {"LightRangeOfASun",
     {"render", "IN", "OUT", "--sun", "0,1,0", "--light-range", "3"},
     {"--light-range", "--light"}},
    {"LightRangeOfZero",
     {"render", "IN", "OUT", "--light", "0,1,0", "--light-range", "0"},
     {"--light-range", "0"}},
    {"LightRangeIsText",
     {"render", "IN", "OUT", "--light", "0,1,0", "--light-range", "far"},
     {"--light-range", "far"}},
    {"MaskScaleIsNoneOfThem",
     {"render", "IN", "OUT", "--mask-scale", "1/3"},
     {"--mask-scale", "1/3", "1/4"}},
    {"TradeoffOfNothing", {"tradeoff"}, {"FILE"}},
    {"TradeoffPlotOfNoKind", {"tradeoff", "IN", "--plot", "OUT"}, {"--plot", ".svg", ".png"}},
    {"TradeoffBudgetOfZero", {"tradeoff", "IN", "--budget-ms", "0"}, {"--budget-ms", "0"}},
    {"TradeoffBudgetIsText", {"tradeoff", "IN", "--budget-ms", "fast"}, {"--budget-ms", "fast"}},
    {"TradeoffBudgetNaN", {"tradeoff", "IN", "--budget-ms", "nan"}, {"--budget-ms", "nan"}},
    {"TradeoffWrongNaN",
     {"tradeoff", "IN", "--max-wrong-percent", "nan"},
     {"--max-wrong-percent", "nan"}},
    {"TradeoffCameraWithoutDirection",
     {"tradeoff", "IN", "--camera-from", "1,2,3", "--camera-to", "1,2,3"},
     {"--camera-from", "--camera-to"}},
    {"TradeoffWrongNegative",
     {"tradeoff", "IN", "--max-wrong-percent", "-1"},
     {"--max-wrong-percent", "-1"}},
    {"TradeoffTimeOfZero", {"tradeoff", "IN", "--time-limit", "0"}, {"--time-limit", "0"}},
    {"TradeoffTimeNaN", {"tradeoff", "IN", "--time-limit", "nan"}, {"--time-limit", "nan"}},
    {"TradeoffOfNoViews", {"tradeoff", "IN", "--views", "0"}, {"--views", "0"}},
    {"TradeoffAgainstUnknownOption",
     {"tradeoff", "IN", "--against", "speed=high"},
     {"--against", "speed"}},
    badRender("AmbientNaN", {"--ambient", "nan"}),
    badRender("SectionWithoutADirection", {"--section", "0,0,0,1"}),
    badRender("SectionOfThreeNumbers", {"--section", "0,1,0"}),
    badRender("SectionNaN", {"--section", "0,nan,0,1"}, {"--section", "nan"}),
    badRender("SectionBoxInsideOut", {"--section-box", "1,0,0,0,1,1"}),
    badRender("SectionBoxOfFiveNumbers", {"--section-box", "0,0,0,1,1"}),
    badRender("SectionFillOfNoColour", {"--section-fill", "red"}),
    badRender("SectionShadowsOfNoKind", {"--section-shadows", "half"}),
    {"SectionOfSevenPlanes",
     {"render", "IN", "OUT", "--section", "1,0,0,1", "--section", "1,0,0,1", "--section", "1,0,0,1",
      "--section", "1,0,0,1", "--section", "1,0,0,1", "--section", "1,0,0,1", "--section",
      "1,0,0,1"},
     {"--section", "1,0,0,1"}},
    {"SectionShadowsWithoutASection",
     {"render", "IN", "OUT", "--section-shadows", "whole"},
     {"--section-shadows", "--section-box"}},
};

class BadUsageTest : public testing::TestWithParam<BadUsage> {};

} // namespace

TEST_P(BadUsageTest, IsRefused) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const std::string input = folder.write("in.glb", gltf.glb());
    std::vector<std::string> arguments = GetParam().arguments;
    for (std::string& argument : arguments) {
        if (argument == "IN") argument = input;
        if (argument == "OUT") argument = folder / "out";
    }
    const ProcessResult result = runEdgeshade(arguments);
    const std::string message = messageOf(result);
    std::cout << GetParam().name << " | " << result.status << " | " << message << "\n";
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(result.signal, 0);
    EXPECT_EQ(result.out, "");
    EXPECT_FALSE(message.empty());
    for (const std::string& word : GetParam().words)
        EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' is missing";
    EXPECT_EQ(folder.names(), std::vector<std::string>{"in.glb"}) << "something was left behind";
}

INSTANTIATE_TEST_SUITE_P(Table, BadUsageTest, testing::ValuesIn(usages),
                         [](const auto& row) { return row.param.name; });

TEST(Usage, NumbersMayBeNegativeOrSigned) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const std::string input = folder.write("in.glb", gltf.glb());
    const ProcessResult result = runEdgeshade(
        {"render", input, folder / "out.png", "--size", "16x16", "--camera-from", "-3,+2,-1e1",
         "--camera-to", "-1,0,0", "--light", "-5,5,-5", "--sun", "-1,1,-1", "--near", "auto"});
    EXPECT_EQ(result.status, 0) << result.err;
}

TEST(Usage, APictureLargerThanTheGlCanIsNotPossibleHere) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const std::string input = folder.write("in.glb", gltf.glb());
    const ProcessResult result =
        runEdgeshade({"render", input, folder / "out.png", "--size", "65536x65536"});
    EXPECT_EQ(result.status, 3);
    expectOneSentence(result);
    EXPECT_NE(result.err.find("65536x65536"), std::string::npos);
    EXPECT_EQ(folder.names().size(), 1u);
}

TEST(Usage, MoreSamplesThanTheGlHasAreNotPossibleHere) {
    const TempFolder folder;
    GltfBuilder gltf;
    gltf.addShapeNode(tetrahedron());
    const std::string input = folder.write("in.glb", gltf.glb());
    const ProcessResult result =
        runEdgeshade({"render", input, folder / "out.png", "--size", "16x16", "--samples", "64"});
    EXPECT_EQ(result.status, 3);
    expectOneSentence(result);
    EXPECT_NE(result.err.find("64 samples"), std::string::npos);
}

} // namespace edgeshade::test
