#include "src/lab/views.hpp"

#include "src/lab/draw.hpp"

#include <array>

namespace edgeshade::lab {
namespace {

struct CloseUp {
    std::string kind;
    glm::dvec3 from{0.0}, to{0.0};
    Light light;
};

/// A view from a hundredth, a thousandth or a ten-thousandth of the scene's size from a surface, in
/// turn, with a lamp between eye and surface or a sun, in turn.
CloseUp closeUpOf(const Scene& scene, std::size_t number, Draw& draw) {
    constexpr std::array<double, 3> shares = {1e-2, 1e-3, 1e-4};
    constexpr std::array<const char*, 3> names = {"1e-2", "1e-3", "1e-4"};
    const std::size_t which = number % shares.size();
    const SurfacePoint at = surfacePoint(scene, draw);
    const double away = shares[which] * worldBounds(scene).diagonal();
    const auto aside = [&](double share) {
        return glm::normalize(at.normal + share * draw.direction(-1.0, 1.0));
    };
    CloseUp view;
    view.from = at.point + away * aside(0.7);
    view.to = at.point + 0.3 * away * draw.direction(-1.0, 1.0);
    const bool lamp = number % 2 == 0;
    view.light.position =
        lamp ? glm::dvec4(at.point + 0.5 * away * aside(0.9), 1.0) : glm::dvec4(aside(0.9), 0.0);
    view.kind = std::string(names[which]) + " of the scene from a surface, " +
                (lamp ? "lamp between" : "sun");
    return view;
}

} // namespace

std::vector<LabView> labViews(const Scene& scene, std::size_t count, double fovDegrees,
                              double aspect, std::optional<double> height) {
    const Box box = worldBounds(scene);
    const glm::dvec3 center = box.center();
    const double size = std::max(box.diagonal(), 1e-9);
    const double framing = glm::distance(framingCamera(box, fovDegrees, aspect).from, center);
    Draw draw;
    const auto inBox = [&] {
        if (box.empty()) return center;
        const glm::dvec3 share(draw.between(0.2, 0.8), draw.between(0.2, 0.8),
                               draw.between(0.2, 0.8));
        return box.low + share * (box.high - box.low);
    };
    const auto outside = [&](double distance) {
        return center + distance * framing * draw.direction(0.1, 0.8);
    };
    const auto point = [](const glm::dvec3& p) { return Light{glm::dvec4(p, 1.0)}; };
    const auto sun = [](const glm::dvec3& d) { return Light{glm::dvec4(d, 0.0)}; };

    std::vector<LabView> views;
    for (std::size_t i = 0; i < count; ++i) {
        LabView view;
        Camera camera{outside(draw.between(0.6, 1.1)), center, fovDegrees};
        std::string kind;
        switch (i % 8) {
        case 0:
            kind = "outside, point light above";
            view.light = point(center + size * draw.between(0.5, 1.5) * draw.direction(0.5, 0.95));
            break;
        case 1:
            kind = "inside, point light inside";
            camera.from = inBox();
            camera.to = inBox();
            view.light = point(inBox());
            break;
        case 2:
            kind = "outside, grazing directional light";
            view.light = sun(draw.direction(0.02, 0.15));
            break;
        case 3: {
            kind = "outside, point light close to a surface";
            const SurfacePoint surface = surfacePoint(scene, draw);
            view.light = point(surface.point + 0.01 * size * surface.normal);
            break;
        }
        case 4:
            kind = "inside, sun";
            camera.from = inBox();
            camera.to = inBox();
            view.light = sun(draw.direction(0.3, 0.9));
            break;
        case 5: {
            kind = "close to a surface, point light outside";
            const SurfacePoint surface = surfacePoint(scene, draw);
            camera.from = surface.point + 0.05 * size * surface.normal;
            camera.to = surface.point + 0.02 * size * draw.direction(-1.0, 1.0);
            view.light = point(center + size * draw.between(0.5, 1.5) * draw.direction(0.2, 0.9));
            break;
        }
        default: {
            const CloseUp closeUp = closeUpOf(scene, i / 8 * 2 + i % 8 - 6, draw);
            kind = closeUp.kind;
            camera.from = closeUp.from;
            camera.to = closeUp.to;
            view.light = closeUp.light;
        }
        }
        view.name = std::to_string(i) + ": " + kind;
        view.frustum = frustumOf(camera, aspect, height);
        views.push_back(view);
    }
    return views;
}

} // namespace edgeshade::lab
