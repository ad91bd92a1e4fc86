#include "src/cli/caster_variants.hpp"

#include "preprocess/gltf/gltf_document.hpp"
#include "preprocess/packing/weld_choice.hpp"
#include "src/scene/cut_loaded.hpp"
#include "src/scene/pose.hpp"

#include <algorithm>

namespace edgeshade::cli {

std::shared_ptr<const LoadedScene> CasterVariants::with(const CasterChanges& changes) {
    const CasterSettings wanted = settingsWith(changes);
    if (wanted == own_.settings) return nullptr;
    const auto found = std::find_if(others_.begin(), others_.end(),
                                    [&](const auto& other) { return other->settings == wanted; });
    if (found != others_.end()) return *found;
    LoadedScene other = loadScene(path_, wanted, own_.document->memory.limits(), {}, own_.looks);
    other.images = own_.images; // the same pixels, kept once
    other.cutoutsCast = own_.cutoutsCast;
    other.scene.culls = own_.scene.culls;
    if (own_.time) poseScene(other, *own_.time, own_.animation);
    leaveOutHidden(other);
    if (own_.ground) addGround(other, *own_.ground);
    if (own_.scene.cutFrom) cutScene(other, own_.scene.cutFrom->section);
    return others_.emplace_back(std::make_shared<const LoadedScene>(std::move(other)));
}

CasterSettings CasterVariants::settingsWith(const CasterChanges& changes) {
    CasterSettings wanted = changes.on(own_.settings);
    if (!wanted.autoWeld) return wanted;
    if (const auto known = std::find_if(chosen_.begin(), chosen_.end(),
                                        [&](const auto& one) { return one.first == wanted; });
        known != chosen_.end())
        return known->second;
    return chosen_.emplace_back(wanted, settingsFor(*own_.document, wanted)).second;
}

nlohmann::ordered_json casterJson(const CasterSettings& settings) {
    return {{"weld-tolerance", settings.weldTolerance},
            {"flat-tolerance", settings.flatTolerance},
            {"caster-error", settings.casterError},
            {"cast-masked", settings.castMasked},
            {"instances", nameOf(settings.instances)}};
}

} // namespace edgeshade::cli
