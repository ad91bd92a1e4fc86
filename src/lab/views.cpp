#include "src/lab/views.hpp"

#include "src/lab/draw.hpp"

namespace edgeshade::lab {
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
        switch (i % 6) {
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
        default: {
            kind = "close to a surface, point light outside";
            const SurfacePoint surface = surfacePoint(scene, draw);
            camera.from = surface.point + 0.05 * size * surface.normal;
            camera.to = surface.point + 0.02 * size * draw.direction(-1.0, 1.0);
            view.light = point(center + size * draw.between(0.5, 1.5) * draw.direction(0.2, 0.9));
            break;
        }
        }
        view.name = std::to_string(i) + ": " + kind;
        view.frustum = frustumOf(camera, aspect, height);
        views.push_back(view);
    }
    return views;
}

} // namespace edgeshade::lab
