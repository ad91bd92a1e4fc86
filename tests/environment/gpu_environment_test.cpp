// Results of shaders_es2/environment.glsl on the GL against its twin on the processor.
#include "src/scene/gpu_environment.hpp"

#include "preprocess/base/file_io.hpp"
#include "src/environment/neutral.hpp"
#include "src/environment/reading.hpp"
#include "src/gl/headless_context.hpp"
#include "src/render/drawing/attributes.hpp"
#include "tests/environment/sky.hpp"
#include "tests/support/environment_lookup.hpp"
#include "tests/support/hdr_writing.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

constexpr int side = 64;                        // side of the picture, with one query per pixel
constexpr glm::vec3 channels(0.2f, 0.3f, 0.5f); // distinguishable in one number
constexpr float largest = 32.0f;                // the largest value written to 16 bits

struct Query {
    glm::vec2 pixel; ///< in normalised device coordinates
    glm::vec4 query; ///< direction, roughness
};

std::string shader(const std::string& file) {
    const Bytes bytes = readFile(std::string(EDGESHADE_SHADERS) + "/" + file);
    return {bytes.begin(), bytes.end()};
}

std::string fragmentSource() {
    const std::string include = "#include \"environment_layout.glsl\"";
    std::string lookup = shader("environment.glsl");
    const std::size_t at = lookup.find(include);
    EXPECT_NE(at, std::string::npos);
    lookup.replace(at, include.size(), shader("environment_layout.glsl"));
    return "precision highp float;\n" + lookup + R"glsl(
varying vec4 v_query;
void main() {
#ifdef DIFFUSE
    vec3 radiance = environmentDiffuse(v_query.xyz);
#else
    vec3 radiance = environmentSpecular(v_query.xyz, v_query.w);
#endif
    float number = dot(radiance, vec3(0.2, 0.3, 0.5)) / 32.0 * 255.0;
    gl_FragColor = vec4(floor(number) / 255.0, fract(number), 0.0, 1.0);
}
)glsl";
}

constexpr char vertexSource[] = R"glsl(
attribute vec2 a_pixel;
attribute vec4 a_query;
varying vec4 v_query;
void main() {
    v_query = a_query;
    gl_Position = vec4(a_pixel, 0.0, 1.0);
    gl_PointSize = 1.0;
}
)glsl";

std::vector<Query> makeQueries() {
    const std::vector<glm::vec3> directions = testDirections();
    std::vector<Query> queries;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const auto i = static_cast<std::size_t>(y * side + x);
            const glm::vec3& one = directions[i % directions.size()];
            const glm::vec3& other = directions[i / directions.size() * 7 % directions.size()];
            const glm::vec3 between = glm::normalize(one + 0.4f * other);
            const glm::vec2 pixel = (2.0f * glm::vec2(x, y) + 1.0f) / float(side) - 1.0f;
            queries.push_back({pixel, {between, static_cast<float>(i % 41) / 40.0f}});
        }
    return queries;
}

/// Draws the numbers, one per query.
std::vector<float> drawn(const gl::HeadlessContext& context, const Environment& environment,
                         const std::vector<Query>& queries,
                         const std::vector<std::string>& defines) {
    const GpuEnvironment gpu(environment);
    const gl::Program program(vertexSource, fragmentSource().c_str(), defines,
                              {"a_pixel", "a_query"});
    const gl::Buffer buffer = gl::vertexBuffer<Query>(queries);
    program.use();
    gpu.bind(program, 3);
    glViewport(0, 0, side, side);
    glDisable(GL_DITHER);
    {
        AttributeBinding binding(nullptr);
        binding.add(buffer, 2, GL_FLOAT, false, sizeof(Query), 0, false);
        binding.add(buffer, 4, GL_FLOAT, false, sizeof(Query), sizeof(glm::vec2), false);
        glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(queries.size()));
    }
    const std::vector<std::uint8_t> rgba = context.readPixels();
    std::vector<float> numbers;
    for (int y = side - 1; y >= 0; --y) // pixels are read from the top
        for (int x = 0; x < side; ++x) {
            const std::uint8_t* pixel = rgba.data() + 4 * (y * side + x);
            numbers.push_back(largest * (pixel[0] + pixel[1] / 255.0f) / 255.0f);
        }
    return numbers;
}

Environment coloured() {
    return readEnvironment(panoramaOf(256, 128,
                                      [](const glm::vec3& direction) {
                                          return glm::vec3(lopsidedSky(glm::dvec3(direction)));
                                      }),
                           "'a.hdr'", EnvironmentScale::asStored);
}

} // namespace

TEST(GpuEnvironment, ReflectionsAreAsOnTheProcessor) {
    const gl::HeadlessContext context({side, side});
    const std::vector<Query> queries = makeQueries();
    for (const Environment& environment : {neutralEnvironment(), coloured()}) {
        const std::vector<float> numbers = drawn(context, environment, queries, {});
        float worst = 0.0f, sum = 0.0f;
        for (std::size_t i = 0; i < queries.size(); ++i) {
            const glm::vec4& query = queries[i].query;
            const float expected = glm::dot(
                test::environmentSpecular(environment, glm::vec3(query), query.w), channels);
            // Some GLs filter to 8 bits: the multiplier, 64 or more, and the colour are off by one.
            const float error = std::abs(numbers[i] - expected);
            ASSERT_LT(error, 0.04f * expected + 0.002f)
                << query.x << ", " << query.y << ", " << query.z << ", roughness " << query.w;
            worst = std::max(worst, error / expected);
            sum += error / expected;
        }
        RecordProperty("worst", std::to_string(worst));
        RecordProperty("mean", std::to_string(sum / static_cast<float>(queries.size())));
        EXPECT_LT(sum / static_cast<float>(queries.size()), 0.01f);
    }
}

TEST(GpuEnvironment, DiffuseLightIsAsOnTheProcessor) {
    const gl::HeadlessContext context({side, side});
    const std::vector<Query> queries = makeQueries();
    const Environment environment = coloured();
    const std::vector<float> numbers = drawn(context, environment, queries, {"DIFFUSE"});
    for (std::size_t i = 0; i < queries.size(); ++i)
        ASSERT_NEAR(
            numbers[i],
            glm::dot(test::environmentDiffuse(environment, glm::vec3(queries[i].query)), channels),
            0.002f);
}

} // namespace edgeshade::test
