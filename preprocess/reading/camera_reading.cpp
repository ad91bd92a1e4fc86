#include "preprocess/reading/camera_reading.hpp"

#include "preprocess/gltf/optional_items.hpp"
#include "preprocess/reading/node_parts.hpp"
#include "preprocess/scene/extremes.hpp"

#include <cmath>
#include <numbers>

namespace edgeshade {
namespace {

/// Reads everything but the position.
SceneCamera lensOf(const JsonField& camera) {
    SceneCamera read;
    read.name = nameOf(camera);
    const std::string type = camera.member("type").oneOf({"perspective", "orthographic"});
    const JsonField lens = camera.member(type.c_str());
    read.orthographic = type == "orthographic";
    if (read.orthographic) {
        lens.member("xmag").notZero();
        const JsonField ymag = lens.member("ymag");
        const double half = std::abs(ymag.notZero());
        if (half < smallestLength || half > farthestPlace)
            ymag.fail(" is " + ymag.value().dump() +
                      ", but must have a magnitude from 1e-12 to 1e12");
        read.height = 2.0 * half;
        lens.member("znear").notNegative();
        lens.member("zfar").positive();
    } else {
        const JsonField yfov = lens.member("yfov");
        read.height = yfov.positive();
        if (read.height < narrowestAngle || read.height >= std::numbers::pi)
            yfov.fail(" is " + yfov.value().dump() + ", but must be at least 1e-6 and below pi");
        lens.member("znear").positive();
        lens.ifPresent("zfar", [](const JsonField& far) { far.positive(); });
        lens.ifPresent("aspectRatio", [](const JsonField& aspect) { aspect.positive(); });
    }
    return read;
}

} // namespace

std::vector<SceneCamera> readCameras(const GltfDocument& document, const NodeWalk& walk,
                                     Warnings& warnings) {
    const JsonField root(document.path, document.json);
    const auto lenses = soundItems(root, "cameras", "camera", warnings, lensOf);
    std::vector<SceneCamera> cameras;
    forEachNode(document, walk, "camera", warnings, [&](const JsonField& node, const auto* placed) {
        node.ifPresent("camera", [&](const JsonField& reference) {
            const int index = reference.indexInto(lenses.size(), "cameras");
            const auto& lens = lenses[static_cast<std::size_t>(index)];
            if (!placed || !lens) return;
            SceneCamera camera = *lens;
            camera.nodeName = nameOf(node);
            camera.place = placed->place;
            camera.worldFromCamera = rigidPlaceOf(reference, walk.worldFromNode[placed->node],
                                                  walk.unflattened[placed->node]);
            cameras.push_back(camera);
        });
    });
    return cameras;
}

} // namespace edgeshade
