// Close-ups of the available models: primitive maps, volumes and point queries, compared with rays,
// at distances from a hundredth to a ten-thousandth of the scene's size, with fitted and swept near
// planes, in place and far from the origin.
#include "src/lab/compare.hpp"
#include "src/lab/draw.hpp"
#include "tests/support/headless.hpp"

#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int width = 480, height = 270;
constexpr int places = 3; // per scene

std::vector<lab::LabView> closeUps(const Scene& scene) {
    const Box box = worldBounds(scene);
    const double size = box.diagonal();
    lab::Draw draw;
    const auto direction = [&] { return draw.direction(-1.0, 1.0); };
    std::vector<lab::LabView> views;
    for (int place = 0; place < places; ++place)
        for (const double share : {1e-2, 1e-3, 1e-4}) {
            const lab::SurfacePoint at = lab::surfacePoint(scene, draw);
            const double away = share * size;
            const glm::dvec3 from = at.point + away * glm::normalize(at.normal + 0.7 * direction());
            const Camera camera{from, at.point + 0.3 * away * direction(), 60.0};
            const Light sun{glm::dvec4(glm::normalize(at.normal + 0.9 * direction()), 0.0)};
            const Light lamp{glm::dvec4(box.center() + 0.9 * size * direction(), 1.0)};
            const Light between{glm::dvec4(
                at.point + 0.5 * away * glm::normalize(at.normal + 0.9 * direction()), 1.0)};
            for (const Light& light : {sun, lamp, between})
                views.push_back({std::to_string(place) + " from " + std::to_string(share),
                                 frustumOf(camera, static_cast<double>(width) / height), light});
        }
    return views;
}

std::vector<lab::Contender> methods() {
    std::vector<lab::Contender> all;
    const auto add = [&](const char* name, ShadowMethod shadows) {
        lab::Contender& contender = all.emplace_back();
        contender.name = name;
        contender.settings.shadows = shadows;
        contender.settings.shading = Shading::base;
    };
    add("volumes", ShadowMethod::volumes);
    add("primitive map", ShadowMethod::primitiveMap);
    if (test::canAskPoints()) add("points", ShadowMethod::irregularZBuffer);
    return all;
}

LoadedScene model(const std::string& name) {
    return loadScene(std::filesystem::path(EDGESHADE_SHARED_SCENES) / (name + ".glb"),
                     std::nullopt);
}

/// The error that docs/measured/accuracy.md describes: pixels of one view of the temple.
constexpr std::size_t knownError = 22;

/// `lookedUp`: most pixels of lookups that may be wrong, beyond 1 px and not tied.
void expectRight(const LoadedScene& loaded, std::size_t lookedUp) {
    lab::CompareTask task;
    task.views = closeUps(loaded.scene);
    task.width = width;
    task.height = height;
    task.contenders = methods();
    for (const lab::CompareResult& result :
         lab::compareAll(loaded, task, [](double, const std::string&) {})) {
        std::cout << "[ close-up ] " << result.name << ": "
                  << lab::percent(result.counts.wrongMaskPixels, result.counts.visiblePixels)
                  << " % of masks wrong, "
                  << lab::percent(result.counts.wrongImagePixels, result.counts.visiblePixels)
                  << " % of images, not tied " << result.counts.beyond1pxNotTied << "\n";
        EXPECT_LE(result.counts.beyond1pxNotTied, result.name == "primitive map" ? lookedUp : 0u)
            << result.name;
        EXPECT_GT(result.counts.visiblePixels, 0u);
        EXPECT_LT(result.counts.wrongMaskPixels, result.counts.visiblePixels / 1000) << result.name;
    }
}

class CloseUps : public testing::TestWithParam<std::string> {};

TEST_P(CloseUps, AreRight) {
    LoadedScene loaded = model(GetParam());
    const std::size_t lookedUp = GetParam() == "temple" ? knownError : 0;
    expectRight(loaded, lookedUp);
    const glm::dvec3 far = 1e5 * worldBounds(loaded.scene).diagonal() * glm::dvec3(1.0, 0.1, -1.3);
    for (Batch& batch : loaded.scene.batches)
        batch.worldFromBatch = glm::translate(glm::dmat4(1.0), far) * batch.worldFromBatch;
    expectRight(loaded, lookedUp);
}

std::vector<std::string> models() {
    std::vector<std::string> names;
    if (!std::filesystem::is_directory(EDGESHADE_SHARED_SCENES)) return names;
    for (const auto& entry : std::filesystem::directory_iterator(EDGESHADE_SHARED_SCENES))
        if (entry.path().extension() == ".glb") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(CloseUps);
INSTANTIATE_TEST_SUITE_P(Long, CloseUps, testing::ValuesIn(models()), [](const auto& of) {
    std::string name = of.param;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(c); }, '_');
    return name;
});

/// Points don't depend on the near plane: a fault with one appears with all.
TEST_P(CloseUps, OfPointsAreRightWithAnyNearPlane) {
    if (!test::canAskPoints()) GTEST_SKIP() << "no processor draws";
    const LoadedScene loaded = model(GetParam());
    const double size = worldBounds(loaded.scene).diagonal();
    for (const double near : {1e-6, 1e-5, 1e-4, 1e-3}) {
        SCOPED_TRACE(near);
        lab::CompareTask task;
        task.views = closeUps(loaded.scene);
        task.views.resize(3); // starting at a hundredth of the size
        task.width = width;
        task.height = height;
        task.near = near * size;
        task.contenders = {methods().back()};
        for (const lab::CompareResult& result :
             lab::compareAll(loaded, task, [](double, const std::string&) {}))
            EXPECT_LT(result.counts.wrongMaskBeyond1px, result.counts.visiblePixels / 1000);
    }
}

/// Views with known faults: 4,722 pixels by points, 8 by maps.
TEST(CloseUp, ViewsThatWereWrongAreRight) {
    struct View {
        const char* model;
        glm::dvec3 from, to, light;
    };
    const View views[] = {{"hospital-electrical",
                           {43.379709488437804, 188.795183128219, -95.15865215547575},
                           {43.15084861350337, 189.13659906387338, -95.08980833169733},
                           {43.21623743491321, 188.94882029926347, -95.10947799563402}},
                          {"temple",
                           {-1.127214943715527, 18.69657659194086, 1.6419930531204592},
                           {-0.911038339138031, 18.64947509765625, 1.8297340869903564},
                           {-0.9892228468199497, 18.662932604406016, 1.7154527766333203}}};
    if (!std::filesystem::is_directory(EDGESHADE_SHARED_SCENES))
        GTEST_SKIP() << EDGESHADE_SHARED_SCENES << " is not there";
    for (const View& view : views) {
        SCOPED_TRACE(view.model);
        LoadedScene loaded = model(view.model);
        loaded.scene.culls = false;
        lab::CompareTask task;
        task.width = 320;
        task.height = 180;
        task.views = {{view.model, frustumOf({view.from, view.to, 60.0}, 320.0 / 180.0),
                       Light{glm::dvec4(view.light, 1.0)}}};
        task.contenders = methods();
        for (const lab::CompareResult& result :
             lab::compareAll(loaded, task, [](double, const std::string&) {})) {
            EXPECT_EQ(result.counts.beyond1pxNotTied, 0u) << result.name;
            EXPECT_GT(result.counts.visiblePixels, 10'000u);
        }
    }
}

TEST(CloseUp, ModelsAreThere) {
    if (models().empty())
        GTEST_SKIP() << EDGESHADE_SHARED_SCENES << " is not there, so no close-ups of its models";
}

} // namespace
} // namespace edgeshade
