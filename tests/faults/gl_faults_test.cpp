// Failures of the GL: status 3, one sentence, no output, and no GL object is left when the program
// ends.
#include "faulty_gl.hpp"
#include "tests/cli/message.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade::test {
namespace {

struct GlFault {
    std::string name;
    ChildProcess::Environment environment;
    std::vector<std::string> options;
    std::string word; ///< required in the message
};

ChildProcess::Environment preloaded(const std::string& fault) {
    return {{"LD_PRELOAD", EDGESHADE_PRELOADS}, {faultVariable, fault}};
}

/// A folder with a scene and the program's output.
class GlFaults : public testing::Test {
  protected:
    GlFaults() {
        GltfBuilder gltf;
        gltf.addShapeNode(tetrahedron());
        input_ = folder_.write("in.glb", gltf.glb());
    }

    ProcessResult render(ChildProcess::Environment environment,
                         const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"render", input_, folder_ / "out.png"};
        if (more.empty() || more.front() != "--size")
            arguments.insert(arguments.end(), {"--size", "32x32"});
        arguments.insert(arguments.end(), more.begin(), more.end());
        environment.emplace_back(leakVariable, folder_ / "leaks");
        return ChildProcess(EDGESHADE_PROGRAM, arguments, environment).wait();
    }

    /// Objects alive in the GL at the end of the last preloaded run.
    std::string leaks() const {
        if (!std::filesystem::exists(folder_ / "leaks")) return "no list was written";
        const Bytes bytes = readFile(folder_ / "leaks");
        return {bytes.begin(), bytes.end()};
    }

    void expectRefusal(const ProcessResult& result, const std::string& word) const {
        EXPECT_EQ(result.status, 3) << result.err;
        expectOneSentence(result);
        EXPECT_NE(result.err.find(word), std::string::npos) << result.err;
        EXPECT_FALSE(std::filesystem::exists(folder_ / "out.png"));
        EXPECT_EQ(folder_.partialFiles(), 0u);
    }

    TempFolder folder_;
    std::string input_;
};

class OneGlFault : public GlFaults, public testing::WithParamInterface<GlFault> {};

const std::vector<std::string> map = {"--shadows", "map", "--map-size", "64"};

const std::vector<GlFault> faults = {
    {"NoDriverAtAll",
     {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/nowhere.json"}},
     {},
     "No EGL display can be opened"},
    {"ADriverThatCantBeLoaded",
     {{"LIBGL_DRIVERS_PATH", "/nowhere"},
      {"EGL_LOG_LEVEL", "fatal"},
      {"LD_PRELOAD", EDGESHADE_PRELOADS}},
     {},
     "No EGL display can be opened"},
    {"NoPictureWithAStencil", preloaded(fault::noConfig), {}, "8-bit stencil"},
    {"NoContext", preloaded(fault::noContext), {}, "can't make an OpenGL ES 2 context"},
    {"NoMemoryForThePicture", preloaded(fault::noSurface), {}, "32x32 here: it is out of memory"},
    {"AContextThatCantBeUsed", preloaded(fault::noCurrent), {}, "OpenGL ES 2 context"},
    {"NoStencil", preloaded(fault::noStencil), {}, "24 bits of depth and 0 of stencil"},
    {"NoDepth", preloaded(fault::noDepth), {}, "0 bits of depth"},
    {"APictureBeyondAll", preloaded(""), {"--size", "65536x65536"}, "65536x65536 is too large"},
    {"MoreSamplesThanThereAre", preloaded(""), {"--samples", "64"}, "64 samples"},
    {"NoSamplesWithoutExtensions", preloaded(fault::noExtensions), {"--samples", "4"}, "4 samples"},
    {"NoInstancingWithoutExtensions",
     preloaded(fault::noExtensions),
     {"--instancing", "on"},
     "--instancing off"},
    {"NoCoarseMaskWithoutExtensions",
     preloaded(fault::noExtensions),
     {"--mask-scale", "1/2"},
     "GL_OES_standard_derivatives"},
    {"AVertexShaderIsRefused", preloaded("no-compile:1"), {}, "vertex shader: 0:1: too many words"},
    {"AFragmentShaderIsRefused", preloaded("no-compile:2"), {}, "compile a fragment shader"},
    {"AProgramIsRefused", preloaded("no-link:1"), {}, "can't link a program"},
    {"NoMemoryForAMultisampledPicture",
     preloaded("no-memory:1"),
     {"--samples", "4"},
     "samples per pixel: the GL is out of memory"},
    {"NoMultisampledFramebuffer", preloaded(fault::noTarget), {"--samples", "4"}, "4 samples"},
    {"NoShadowMapFramebuffer", preloaded(fault::noTarget), map, "into a shadow map of 64 texels"},
    {"NoCoarseMaskFramebuffer",
     preloaded(fault::noTarget),
     {"--mask-scale", "1/2"},
     "'--mask-scale 1' works without it"},
    {"ALostContext", preloaded("lost:1"), {}, "has lost its context"},
    {"AContextLostLater", preloaded("lost:3"), {}, "has lost its context"},
    {"AContextLostSilently", preloaded("lost-silently:2"), {}, "has lost its context"},
    {"AContextLostWithShadowMaps", preloaded("lost:1"), map, "has lost its context"},
};

} // namespace

TEST_P(OneGlFault, EndsWithASentence) {
    const GlFault& fault = GetParam();
    const ProcessResult result = render(fault.environment, fault.options);
    expectRefusal(result, fault.word);
    const bool counted = fault.environment.front().first == "LD_PRELOAD" ||
                         fault.environment.back().first == "LD_PRELOAD";
    if (counted) {
        EXPECT_EQ(leaks(), "");
    }
    std::cout << "[ fault ] " << fault.name << ": " << messageOf(result) << "\n";
}

INSTANTIATE_TEST_SUITE_P(, OneGlFault, testing::ValuesIn(faults),
                         [](const auto& test) { return test.param.name; });

/// Makes every allocation fail in turn.
TEST_F(GlFaults, AnyAllocationMayBeRefused) {
    const std::vector<std::vector<std::string>> ways = {
        {}, {"--layout", "published"}, map, {"--instancing", "off"}, {"--mask-scale", "1/2"}};
    for (const auto& way : ways) {
        int refused = 0;
        for (int turn = 1; turn <= 60; ++turn) {
            SCOPED_TRACE((way.empty() ? "volumes" : way[0] + " " + way[1]) + ", allocation " +
                         std::to_string(turn));
            const ProcessResult result =
                render(preloaded("no-memory:" + std::to_string(turn)), way);
            EXPECT_EQ(leaks(), "");
            if (result.status == 0) break;
            ++refused;
            expectRefusal(result, "memory");
        }
        EXPECT_GE(refused, 4);
        EXPECT_LT(refused, 60);
        std::filesystem::remove(folder_ / "out.png");
    }
}

/// The same for every shader and every program.
TEST_F(GlFaults, AnyShaderMayBeRefused) {
    for (const char* word : {fault::noCompile, fault::noLink}) {
        int refused = 0;
        for (int turn = 1; turn <= 40; ++turn) {
            SCOPED_TRACE(std::string(word) + " " + std::to_string(turn));
            const ProcessResult result =
                render(preloaded(std::string(word) + ":" + std::to_string(turn)));
            EXPECT_EQ(leaks(), "");
            if (result.status == 0) break;
            ++refused;
            expectRefusal(result, "This GL can't ");
        }
        EXPECT_GE(refused, 3);
        EXPECT_LT(refused, 40);
        std::filesystem::remove(folder_ / "out.png");
    }
}

/// The faults above mean nothing if the preloaded GL draws something else, or counts nothing.
TEST_F(GlFaults, WithoutOneThePictureIsTheSame) {
    ASSERT_EQ(render(preloaded("")).status, 0);
    EXPECT_EQ(leaks(), "");
    const Bytes picture = readFile(folder_ / "out.png");
    ASSERT_EQ(render({}).status, 0);
    EXPECT_EQ(readFile(folder_ / "out.png"), picture);
}

/// A GL with only ES 2.0 is no fault.
TEST_F(GlFaults, NoExtensionIsNeeded) {
    ASSERT_EQ(render(preloaded(fault::noExtensions)).status, 0);
    EXPECT_EQ(leaks(), "");
    const Bytes picture = readFile(folder_ / "out.png");
    ASSERT_EQ(render({}).status, 0);
    EXPECT_EQ(readFile(folder_ / "out.png"), picture);
}

/// Verbs that draw without writing a picture.
TEST_F(GlFaults, MeasuringEndsWithASentenceToo) {
    for (const char* verb : {"bench", "compare"})
        for (const char* fault : {"no-stencil", "no-memory:4", "no-compile:3", "lost:2"}) {
            SCOPED_TRACE(std::string(verb) + ", " + fault);
            std::vector<std::string> arguments = {verb,    input_,     "--size",
                                                  "32x32", "--report", folder_ / "report.json"};
            if (verb == std::string("bench")) arguments.insert(arguments.end(), {"--frames", "2"});
            if (verb == std::string("compare")) arguments.insert(arguments.end(), {"--views", "1"});
            auto environment = preloaded(fault);
            environment.emplace_back(leakVariable, folder_ / "leaks");
            const ProcessResult result =
                ChildProcess(EDGESHADE_PROGRAM, arguments, environment).wait();
            EXPECT_EQ(result.status, 3) << result.err;
            expectOneSentence(result);
            EXPECT_EQ(leaks(), "");
            EXPECT_FALSE(std::filesystem::exists(folder_ / "report.json"));
        }
}

} // namespace edgeshade::test
