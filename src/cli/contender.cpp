#include "src/cli/contender.hpp"

#include "src/shadow/lights/scene_lights.hpp"

namespace edgeshade::cli {

lab::Contender contenderOf(const std::string& name, const DrawSettings& settings,
                           std::shared_ptr<const LoadedScene> scene) {
    lab::Contender contender;
    contender.name = name;
    contender.scene = std::move(scene);
    contender.settings = settings.render;
    contender.depthSlices = settings.depthSlices;
    contender.tuneMapBias =
        settings.render.shadows == ShadowMethod::map && !settings.has("--map-bias");
    if (settings.instancing != InstancingChoice::automatic)
        contender.layout = layoutFor(settings.instancing, {});
    return contender;
}

void lookAt(lab::CompareTask& task, const ViewOptions& view, const Scene& scene, int views,
            bool viewsTyped) {
    task.width = view.width;
    task.height = view.height;
    task.near = view.depth.near;
    task.lights = view.lights.all();
    if (view.lights.choice == LightChoice::file) task.lights = lightsOf(scene);
    if (view.lights.choice == LightChoice::fallback) task.lights = {defaultLight()};
    if (!task.lights.empty()) view.lights.extents.giveTo(task.lights);
    if ((view.cameraMatrix || view.camera) && viewsTyped)
        throw Error(ExitStatus::usage, std::string(view.camera ? "--camera" : "--camera-matrix") +
                                           " is one view, so --views does not go with it.");
    if (view.hasCamera() && !viewsTyped) {
        const FrameRequest request = requestFor(view, scene);
        task.views = {{"as requested", request.frustum, request.lights.front()}};
        task.lights = request.lights;
    } else {
        task.views = lab::labViews(scene, static_cast<std::size_t>(views), view.fovDegrees,
                                   view.aspect(), view.orthoHeight);
    }
}

} // namespace edgeshade::cli
