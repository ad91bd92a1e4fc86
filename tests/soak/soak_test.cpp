// Long runs: memory must not grow.
#include "memory.hpp"
#include "src/bench/flythrough.hpp"
#include "src/gl/headless_context.hpp"
#include "src/viewer/viewer.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/gltf_builder.hpp"
#include "tests/support/headless.hpp"
#include "tests/support/scene_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade::test {
namespace {

constexpr int width = 96, height = 64;

/// Growth that counts as flat: changes inside allocators and a GL's caches.
constexpr double flatMegabytes = 8.0;

/// Runs `step` this many times, prints the memory ten times meanwhile and expects it to stay at the
/// level of the first two tenths.
template <class Step>
void expectFlat(const char* what, int times, Step step) {
    std::size_t early = 0, most = 0;
    for (int i = 0; i < times; ++i) {
        step(i);
        if ((i + 1) % (times / 10) != 0) continue;
        const std::size_t now = residentBytes();
        if ((i + 1) / (times / 10) <= 2) early = std::max(early, now);
        most = std::max(most, now);
        std::cout << "[ soak ] " << what << " " << i + 1 << ": " << megabytes(now) << " MB"
                  << std::endl;
    }
    EXPECT_LT(megabytes(most) - megabytes(early), flatMegabytes) << what;
}

/// A flight through a yard with a moving lamp and a resting sun, alternately with volumes and maps.
TEST(Soak, TwentyThousandFrames) {
    const gl::HeadlessContext context(testPicture(width, height));
    const Scene scene = yard().scene();
    const LoadedScene loaded{{}, scene, {}, buildPlanePairs(scene, false), {}, {}};
    const Box bounds = worldBounds(scene);
    const bench::Flythrough flight(bounds, 50.0, double(width) / height);
    const std::vector<Light> lights = {pointLight({2, 4, 1}), sun({0.4, 1, 0.3})};

    std::array<RenderSettings, 3> ways;
    for (RenderSettings& way : ways)
        way.layout = bestLayout(context.capabilities());
    ways[1].maskScale = 2;
    ways[2].shadows = ShadowMethod::map;
    ways[2].map.size = 64;
    std::vector<std::unique_ptr<Renderer>> renderers;
    for (const RenderSettings& way : ways)
        renderers.push_back(std::make_unique<Renderer>(way, context.capabilities()));
    GpuScene gpu = uploadScene(loaded, ways[0].records(), context.capabilities());

    expectFlat("frames", 20'000, [&](int frame) {
        const double share = frame / 1000.0;
        FrameRequest request{frustumOf(flight.cameraAt(share), static_cast<double>(width) / height),
                             width,
                             height,
                             {},
                             {}};
        request.lights = bench::movedLights(lights, bounds, bench::usualCircle, share);
        const FrameView view = makeFrameView(loaded.scene, request, bounds);
        const auto way = static_cast<std::size_t>(frame % 8 < 6 ? 0 : frame % 8 - 5);
        renderers[way]->draw(gpu, view);
        if (frame % 100 == 0) context.readPixels();
        gl::requireNoError("soaking");
    });
}

TEST(Soak, AThousandScenes) {
    const gl::HeadlessContext context(testPicture(width, height));
    viewer::Viewer viewer(context.capabilities());
    viewer.resize(width, height, 1.0);
    const std::string pavilion = std::string(EDGESHADE_ASSETS) + "/pavilion.glb";
    expectFlat("loads", 1000, [&](int load) {
        viewer.show(loadScene(pavilion, std::nullopt));
        viewer.frame(load);
        gl::requireNoError("soaking");
    });
}

/// Hills of 2 (side - 1)^2 triangles.
Shape hills(std::uint32_t side) {
    Shape shape;
    const auto up = [](float x, float z) {
        return 0.3f * std::sin(3.0f * x) * std::cos(4.0f * z) + 0.01f * std::sin(70.0f * x);
    };
    const float step = 10.0f / static_cast<float>(side);
    for (std::uint32_t z = 0; z < side; ++z)
        for (std::uint32_t x = 0; x < side; ++x) {
            const float u = step * static_cast<float>(x) - 5.0f;
            const float v = step * static_cast<float>(z) - 5.0f;
            shape.positions.emplace_back(u, up(u, v), v);
        }
    for (std::uint32_t z = 0; z + 1 < side; ++z)
        for (std::uint32_t x = 0; x + 1 < side; ++x) {
            const std::uint32_t p = z * side + x;
            shape.indices.insert(shape.indices.end(), {p, p + side, p + 1});
            shape.indices.insert(shape.indices.end(), {p + 1, p + side, p + side + 1});
        }
    return shape;
}

/// Runs the program itself, so that the memory is its own.
TEST(Soak, FiveMillionTrianglesUnderFourGigabytes) {
    constexpr std::size_t most = std::size_t{4} << 30;
    const TempFolder folder;
    std::string input;
    {
        GltfBuilder gltf;
        gltf.addShapeNode(hills(1583));
        input = folder.write("hills.glb", gltf.glb());
    }
    const auto run = [&](const std::vector<std::string>& arguments) {
        const ProcessResult result = ChildProcess(EDGESHADE_PROGRAM, arguments).wait(1800.0);
        EXPECT_EQ(result.status, 0) << result.err;
        EXPECT_LT(result.peakBytes, most);
        std::cout << "[ soak ] " << arguments[0] << ": " << megabytes(result.peakBytes) << " MB, "
                  << result.seconds << " s\n"
                  << result.out << std::endl;
    };
    const std::string packed = folder / "packed.glb";
    run({"pack", input, packed});
    run({"render", packed, folder / "out.png", "--size", "320x180", "--sun", "0.8,0.5,0.3"});
    run({"pack", input, packed, "--encoding", "expanded"});
    run({"info", packed});
}

} // namespace
} // namespace edgeshade::test
