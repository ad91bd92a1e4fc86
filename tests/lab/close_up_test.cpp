// Close-ups of what models there are: what is looked up and what is counted, held against rays,
// from a hundredth and a thousandth of the scene's size away, where it is and far from the origin.
#include "src/lab/compare.hpp"
#include "src/lab/draw.hpp"

#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace edgeshade {
namespace {

constexpr int width = 480, height = 270;
constexpr int places = 3; // of each scene

std::vector<lab::LabView> closeUps(const Scene& scene) {
    const Box box = worldBounds(scene);
    const double size = box.diagonal();
    lab::Draw draw;
    const auto direction = [&] { return draw.direction(-1.0, 1.0); };
    std::vector<lab::LabView> views;
    for (int place = 0; place < places; ++place)
        for (const double share : {0.01, 0.001}) {
            const lab::SurfacePoint at = lab::surfacePoint(scene, draw);
            const double away = share * size;
            const glm::dvec3 from = at.point + away * glm::normalize(at.normal + 0.7 * direction());
            const Camera camera{from, at.point + 0.3 * away * direction(), 60.0};
            const Light sun{glm::dvec4(glm::normalize(at.normal + 0.9 * direction()), 0.0)};
            const Light lamp{glm::dvec4(box.center() + 0.9 * size * direction(), 1.0)};
            for (const Light& light : {sun, lamp})
                views.push_back({std::to_string(place) + " from " + std::to_string(share),
                                 frustumOf(camera, static_cast<double>(width) / height), light});
        }
    return views;
}

void expectRight(const LoadedScene& loaded) {
    lab::CompareTask task;
    task.views = closeUps(loaded.scene);
    task.width = width;
    task.height = height;
    for (const ShadowMethod shadows : {ShadowMethod::volumes, ShadowMethod::primitiveMap}) {
        lab::Contender contender;
        contender.name = shadows == ShadowMethod::volumes ? "volumes" : "primitive map";
        contender.settings.shadows = shadows;
        contender.settings.shading = Shading::base;
        task.contenders.push_back(contender);
    }
    for (const lab::CompareResult& result :
         lab::compareAll(loaded, task, [](double, const std::string&) {})) {
        std::cout << "[ close-up ] " << result.name << ": "
                  << lab::percent(result.counts.wrongMaskPixels, result.counts.visiblePixels)
                  << " % of masks wrong, "
                  << lab::percent(result.counts.wrongImagePixels, result.counts.visiblePixels)
                  << " % of images, not tied " << result.counts.beyond1pxNotTied << "\n";
        EXPECT_EQ(result.counts.beyond1pxNotTied, 0u) << result.name;
        EXPECT_GT(result.counts.visiblePixels, 0u);
        EXPECT_LT(result.counts.wrongMaskPixels, result.counts.visiblePixels / 1000) << result.name;
    }
}

class CloseUps : public testing::TestWithParam<std::string> {};

TEST_P(CloseUps, AreRight) {
    LoadedScene loaded = loadScene(
        std::filesystem::path(EDGESHADE_SHARED_SCENES) / (GetParam() + ".glb"), std::nullopt);
    expectRight(loaded);
    const glm::dvec3 far = 1e5 * worldBounds(loaded.scene).diagonal() * glm::dvec3(1.0, 0.1, -1.3);
    for (Batch& batch : loaded.scene.batches)
        batch.worldFromBatch = glm::translate(glm::dmat4(1.0), far) * batch.worldFromBatch;
    expectRight(loaded);
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

TEST(CloseUp, ModelsAreThere) {
    if (models().empty())
        GTEST_SKIP() << EDGESHADE_SHARED_SCENES << " is not there, so no close-ups of its models";
}

} // namespace
} // namespace edgeshade
