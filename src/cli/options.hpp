#pragma once

#include "src/cli/light_options.hpp"
#include "src/render/frame/frame.hpp"
#include "src/scene/ground_text.hpp"
#include "src/scene/load.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeshade::cli {

/// `--size`, camera and lights, as typed; resolved against a scene's bounds by viewFor().
struct ViewOptions {
    int width{}, height{};
    std::optional<glm::dvec3> from;
    std::optional<glm::dvec3> to;
    std::optional<glm::dmat4> cameraMatrix; ///< a rigid view matrix, in place of the two
    std::optional<std::string> camera;      ///< one of the file's, by name or index
    double fovDegrees{};
    std::optional<double> orthoHeight; ///< of an orthographic picture, in scene units
    DepthChoice depth;
    LightOptions lights;

    double aspect() const { return static_cast<double>(width) / height; }
    bool hasCamera() const { return from || to || cameraMatrix || camera; }
};

/// `--weld-tolerance`, `--flat-tolerance`, `--caster-error` and `--instances`, where they were
/// typed.
struct CasterChanges {
    std::optional<double> weldTolerance, flatTolerance, casterError;
    bool autoWeld = false; ///< the weld tolerance is 'auto'
    std::optional<InstanceChoice> instances;

    bool any() const {
        return weldTolerance || autoWeld || flatTolerance || casterError || instances;
    }
    CasterSettings on(CasterSettings settings) const;
};

/// These and `--cast-masked`.
struct CasterOptions {
    CasterChanges changes;
    bool castMasked = false;

    CasterSettings settings() const { return changes.on({0.0, castMasked}); }
    /// Nothing if none of them was typed.
    std::optional<CasterSettings> wanted() const {
        return changes.any() || castMasked ? std::optional(settings()) : std::nullopt;
    }
};

/// Options of a scene, for every verb that draws one. Each verb adds `FILE` itself.
struct SceneOptions {
    std::string input;
    ViewOptions view;
    CasterOptions casters;
    ReadingLimits limits;
    gl::Limits glLimits = gl::Limits::device;
    std::string variant;                ///< of its materials; empty: the file's own
    bool cutoutsCast = false;           ///< MASK surfaces cast by lookups
    std::optional<bool> culls;          ///< Scene's, as typed; nothing: cullsByDefault
    std::optional<double> time;         ///< of the animation, seconds; nothing: at rest
    std::string animation;              ///< its name or index; empty: the first
    std::optional<GroundChoice> ground; ///< as typed; nothing: what suits the verb

    GroundChoice typedGround() const { return ground.value_or(std::nullopt); }
    /// {"ground", "cast-cutouts", "cull", "time", "sun"}, the last two if they were typed: what
    /// reports say besides of the settings. `scene`: as it was loaded.
    nlohmann::ordered_json sceneJson(const Scene& scene) const;
    /// At the time and with the ground that were typed; warns where there is no animation, and
    /// where `shadows` leave out what was asked to cast. `oppositeVertices`: some of its volumes
    /// are drawn from such records. Throws Error(usage) where these were typed with '--cull auto';
    /// InputError.
    LoadedScene load(Shading shading, ShadowMethod shadows, bool oppositeVertices) const;
};

/// "WxH", both 1 to 65536. Throws CLI::ValidationError that names the option.
std::pair<int, int> sizeFrom(const std::string& text, const std::string& option);

/// Adds the options to a verb; `options` must outlive parsing.
void addCasterOptions(CLI::App& verb, CasterOptions& options);
void addCasterChanges(CLI::App& verb, CasterChanges& changes);
void addLimitOptions(CLI::App& verb, ReadingLimits& limits);
void addSceneOptions(CLI::App& verb, SceneOptions& options);
/// All but lights.
void addUnlitSceneOptions(CLI::App& verb, SceneOptions& options);

/// The word that the option has for them.
std::string glLimitsName(gl::Limits limits);

/// The camera of --camera-from and --camera-to, which frames the scene where they were not typed.
/// Throws Error(usage) for one without a direction.
Camera cameraFor(const ViewOptions& options, const Scene& scene);

/// The file's camera that was typed; null if none was. Throws Error(usage) that lists those there
/// are for an unknown one.
const SceneCamera* fileCameraFor(const ViewOptions& options, const Scene& scene);

/// The lights that were typed, the file's, or the default light.
std::vector<Light> lightsFor(const LightOptions& options, const Scene& scene);

/// The request, with that camera, the file's or the matrix that was typed, and at least one light.
/// Throws Error(usage) for what does not go together.
FrameRequest requestFor(const ViewOptions& options, const Scene& scene);

} // namespace edgeshade::cli
