#pragma once

#include "preprocess/scene/animation.hpp"
#include "preprocess/scene/section.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/ground_text.hpp"
#include "src/scene/load.hpp"
#include "src/settings/choices.hpp"
#include "src/viewer/sun_state.hpp"

#include <nlohmann/json.hpp>
#include <string>

namespace edgeshade::viewer {

enum class DebugView {
    none,
    volumes, ///< the chosen light's shadow volumes, tinted
};

inline constexpr int mostAnimations = 1'000'000;

// Range of the animation's speed.
inline constexpr double slowest = 0.1;
inline constexpr double fastest = 10.0;

/// Everything that a viewer shows and a user can change. The address bar keeps it.
struct ViewState {
    Camera camera;
    std::vector<Light> lights; ///< at least one once a scene is shown
    std::size_t chosenLight = 0;
    std::size_t lightSamples = 64; ///< points of lights with an extent, when nothing moves
    std::size_t smooth = 1;        ///< number of pictures averaged when nothing moves
    std::optional<SunState> sun;   ///< by place and time; it is the first light, see withSun()
    bool dayPlays = false;         ///< the sun's day is playing
    bool sunHours = false;         ///< show the hours of sunlight of its day when nothing moves
    int sunHoursStep = 10;         ///< minutes per sun position; divides a day
    Shading shading = Shading::full;
    float ambient = 0.45f;                              ///< see RenderSettings
    float exposure = 0.0f;                              ///< EV, see settings::exposure
    glm::vec3 background = RenderSettings().background; ///< behind the scene, sRGB 0..1
    GroundChoice ground;                                ///< beneath the scene
    std::optional<Section> section;                     ///< cuts the scene open; not without planes
    bool castCutouts = false;                           ///< LoadedScene::cutoutsCast
    bool culls = cullsByDefault; ///< copied to Scene, unless a side is drawn from opposite-vertex
                                 ///< records
    SideSettings left;           ///< of the whole picture if there is no split
    SideSettings right{ShadowMethod::map};
    bool split = false;
    double splitAt = 0.5; ///< share of the width, 0..1
    DebugView debug = DebugView::none;
    bool showLights = true;    ///< show the handles that move lights
    std::size_t animation = 0; ///< index of the scene's animation that is shown
    bool playing = false;
    double speed = 1.0; ///< of the animation, slowest..fastest
    double time = 0.0;  ///< of the animation, seconds
};

/// {"camera": {"from": [x,y,z], "to": [x,y,z], "fov": deg}, "lights": [light, …], …, "left":
/// {"shadows": "auto", …}, …}: each member by a key that forEachMember() in view_state.cpp lists,
/// with the values that src/settings/settings.hpp has for it. "sun" is null or {"place": [latitude,
/// longitude], "time": "2026-06-21T14:30+02:00", "north": deg}, "ground" off, catcher or #rrggbb;
/// section_state.hpp describes a section, light_state.hpp describes a light.
nlohmann::ordered_json toJson(const ViewState& state);

/// The state's "camera".
nlohmann::ordered_json toJson(const Camera& camera);

/// `base` with the keys that `changes` has. Throws Error(usage) that names the key and the value if
/// one is unknown, not finite or out of range; nothing has changed then.
ViewState changed(const ViewState& base, const nlohmann::ordered_json& changes);

} // namespace edgeshade::viewer
