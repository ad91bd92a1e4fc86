// Frames of a moving light are planned in the memory of earlier frames: this program counts heap
// allocations.
#include "src/bench/flythrough.hpp"
#include "src/shadow/plan/frame_plan.hpp"
#include "src/shadow/view/kept_layers.hpp"
#include "tests/support/generated_meshes.hpp"
#include "tests/support/placed_shadows.hpp"
#include "tests/support/scene_builder.hpp"

#include <atomic>
#include <cstdlib>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <new>

namespace {

std::atomic<std::size_t> allocations = 0;

} // namespace

// Replaces the heap's functions for the whole program. Not inlined: GCC would warn that free() is
// called on memory from operator new.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++allocations;
    return std::malloc(size > 0 ? size : 1);
}
[[gnu::noinline]] void* operator new(std::size_t size) {
    if (void* const memory = operator new(size, std::nothrow)) return memory;
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
    std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace edgeshade {
namespace {

using test::SceneBuilder;

/// Hills with boxes, a sheet and a triangle on them.
Scene hills(std::size_t triangles) {
    const test::Soup soup = test::hillyGrid(triangles);
    SceneBuilder builder = test::yard();
    const auto corner = [&](std::size_t i) {
        return 0.2f * (soup.positions[soup.indices[i]] - glm::vec3(20, 5, 20));
    };
    for (std::size_t i = 0; i + 2 < soup.indices.size(); i += 3)
        builder.triangle(corner(i), corner(i + 1), corner(i + 2));
    return builder.scene();
}

/// A mesh at many places.
Scene grove() {
    Scene scene = SceneBuilder().floor(30.0f, -1.0f).scene();
    const Scene tree = SceneBuilder().box({-0.2f, -1, -0.2f}, {0.2f, 1, 0.2f}).scene();
    for (int i = 0; i < 60; ++i) {
        Batch& batch = scene.batches.emplace_back(tree.batches.front());
        batch.worldFromBatch =
            glm::translate(glm::dmat4(1.0), glm::dvec3(3 * (i % 8) - 12, 0.0, 3 * (i / 8) - 12));
        if (i > 0) batch.geometry = scene.batches[1].geometry;
    }
    scene.culls = true;
    return scene;
}

Light spot(const glm::dvec3& at, double range) {
    Light light{glm::dvec4(at, 1.0)};
    light.range = range;
    light.cone = Cone{glm::normalize(-at), 0.3, 0.6};
    return light;
}

/// Plans frames as the renderer of plane-pair records does, in kept memory.
class Planner {
  public:
    explicit Planner(const Scene& scene)
        : scene_(scene), bounds_(worldBounds(scene)), tree_(scene),
          casters_(test::placedShadows(scene)) {
        settings_ = {.silhouettes = &silhouettes_, .solids = &solids_, .memory = &memory_};
    }

    /// The number of allocations of a frame.
    std::size_t plan(const FrameRequest& request) {
        const auto groupCount = [](std::size_t) { return std::size_t{1}; };
        const auto count = [&](const DepthSlice& slice, std::size_t light, std::size_t,
                               CountPlan& plan) {
            planCount(casters_, scene_.materials, view_, slice, light, settings_, plan);
        };
        const std::size_t before = allocations;
        makeFrameView(scene_, request, bounds_, tree_, view_);
        silhouettes_.beginFrame(identity_);
        planFrame({.view = view_,
                   .open = {0, 0, request.width, request.height},
                   .groupCount = groupCount,
                   .planCount = count},
                  plan_);
        return allocations - before;
    }

    const FramePlan& plan() const { return plan_; }
    const FrameView& view() const { return view_; }
    const std::vector<PlacedShadow>& casters() const { return casters_; }

  private:
    const Scene& scene_;
    Box bounds_;
    SceneTree tree_;
    std::vector<PlacedShadow> casters_;
    PotentialSilhouettes silhouettes_{23};
    KeptSolids solids_;
    PlanMemory memory_;
    PlanSettings settings_;
    std::shared_ptr<const int> identity_ = std::make_shared<const int>(0);
    FrameView view_;
    FramePlan plan_;
};

std::size_t drawsOf(const FramePlan& plan) {
    std::size_t draws = 0;
    for (const SlicePlan& slice : plan.slices)
        for (const LightPlan& light : slice.lights)
            for (const CountPlan& count : light.counts)
                draws += count.draws.once.size() + count.draws.twice.size();
    return draws;
}

FrameRequest requestOf(const Scene& scene, bool orthographic) {
    const Box bounds = worldBounds(scene);
    FrameRequest request;
    const Camera camera = framingCamera(bounds, 50.0, 1.6);
    request.frustum =
        frustumOf(camera, 1.6, orthographic ? std::optional(bounds.diagonal()) : std::nullopt);
    request.width = 320;
    request.height = 200;
    return request;
}

TEST(PlanMemory, FramesOfAMovingLightTakeNothingFromTheHeapAfterTheThird) {
    for (const Scene& scene : {hills(4000), grove()}) {
        const Box bounds = worldBounds(scene);
        const glm::dvec3 above =
            bounds.center() + 0.8 * bounds.diagonal() * glm::dvec3(0.3, 1, 0.2);
        Light round{glm::dvec4(above, 1.0)};
        round.extent = LightExtent{LightExtent::Shape::sphere, 0.05};
        const std::vector<std::vector<Light>> sets = {
            {{{0.9, 0.3, 0.3, 0.0}}},
            {{glm::dvec4(above, 1.0)}},
            {spot(above, 1.5 * bounds.diagonal())},
            {{{-0.9, 0.4, 0.3, 0.0}}, {glm::dvec4(above, 1.0)}, spot(above, bounds.diagonal())},
            {round}};
        for (std::size_t set = 0; set < sets.size(); ++set)
            for (const bool orthographic : {false, true}) {
                if (orthographic && set > 0) continue; // lamps stand among the casters' depths
                Planner planner(scene);
                FrameRequest request = requestOf(scene, orthographic);
                request.lightSamples = 8;
                std::vector<std::vector<Light>> frames;
                for (int frame = 0; frame < 64; ++frame)
                    frames.push_back(bench::movedLights(sets[set], bounds, 3.0, frame / 64.0));
                for (int frame = 0; frame < 64; ++frame) {
                    request.lights = frames[static_cast<std::size_t>(frame)];
                    const std::size_t taken = planner.plan(request);
                    EXPECT_GT(drawsOf(planner.plan()), 0u);
                    if (frame == 0) {
                        EXPECT_GT(taken, 20u) << "they are counted";
                    }
                    if (frame >= 3) {
                        EXPECT_EQ(taken, 0u) << "lights " << set << ", frame " << frame;
                    }
                }
            }
    }
}

/// The number of allocations of bounds of layers, lights one after the other.
std::size_t allocationsOfBounds(LayerSearch& search, const LayerCasters& casters,
                                const std::vector<Light>& lights, std::size_t limit,
                                const Box& receivers) {
    const std::size_t before = allocations;
    for (const Light& light : lights)
        search.bySilhouettes(casters, light, limit, receivers);
    return allocations - before;
}

TEST(PlanMemory, BoundsOfLayersOnAKnownWayTakeNothingFromTheHeap) {
    for (const Scene& scene : {hills(4000), grove()}) {
        const Box bounds = worldBounds(scene);
        const auto records = buildPlanePairs(scene, false);
        const glm::dvec3 above =
            bounds.center() + 0.8 * bounds.diagonal() * glm::dvec3(0.3, 1, 0.2);
        for (const Light& first : {Light{{0.9, 0.3, 0.3, 0.0}}, Light{glm::dvec4(above, 1.0)},
                                   Light{glm::dvec4(bounds.center(), 1.0)}})
            for (const std::size_t limit : {255, 4}) { // the lower one needs finer grids
                std::vector<Light> way;
                for (int place = 0; place < 32; ++place)
                    way.push_back(bench::movedLights({first}, bounds, 3.0, place / 32.0).front());
                LayerSearch search;
                const LayerCasters casters{scene, records};
                EXPECT_GT(allocationsOfBounds(search, casters, way, limit, bounds), 0u);
                EXPECT_EQ(allocationsOfBounds(search, casters, way, limit, bounds), 0u) << limit;
            }
    }
}

TEST(PlanMemory, KeptBoundsOfAMovingSunTakeNothingFromTheHeap) {
    const Scene scene = hills(4000);
    const Box bounds = worldBounds(scene);
    const auto records = buildPlanePairs(scene, false);
    KeptLayers layers;
    std::vector<FrameLight> lights(1);
    const auto lap = [&] {
        std::size_t taken = 0;
        for (int place = 0; place < 32; ++place) {
            const double turn = 0.01 * place;
            lights[0].light = Light{{std::cos(turn), 0.4, std::sin(turn), 0.0}};
            const std::size_t before = allocations;
            layers.fill({scene, records}, lights, bounds);
            taken += allocations - before;
        }
        return taken;
    };
    EXPECT_GT(lap(), 0u);
    EXPECT_EQ(lap(), 0u);
}

} // namespace
} // namespace edgeshade
