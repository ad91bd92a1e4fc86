#pragma once

#include "src/cli/light_options.hpp"
#include "src/cli/section_options.hpp"
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

/// `--size`, camera and lights, as typed; viewFor() resolves them against a scene's bounds.
struct ViewOptions {
    int width{}, height{};
    std::optional<glm::dvec3> from;
    std::optional<glm::dvec3> to;
    std::optional<glm::dmat4> cameraMatrix; ///< a rigid view matrix, in place of `from` and `to`
    std::optional<std::string> camera;      ///< one of the file's, by name or index
    double fovDegrees{};
    std::optional<double> orthoHeight; ///< of an orthographic picture, in scene units
    DepthChoice depth;
    LightOptions lights;

    double aspect() const { return static_cast<double>(width) / height; }
    bool hasCamera() const { return from || to || cameraMatrix || camera; }
};

/// `--weld-tolerance`, `--flat-tolerance`, `--caster-error` and `--instances`, if typed.
struct CasterChanges {
    std::optional<double> weldTolerance, flatTolerance, casterError;
    bool autoWeld = false; ///< the weld tolerance is 'auto'
    std::optional<InstanceChoice> instances;

    bool any() const {
        return weldTolerance || autoWeld || flatTolerance || casterError || instances;
    }
    CasterSettings on(CasterSettings settings) const;
};

/// Caster changes and `--cast-masked`.
struct CasterOptions {
    CasterChanges changes;
    bool castMasked = false;

    CasterSettings settings() const { return changes.on({0.0, castMasked}); }
    /// Null if none of them was typed.
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
    std::string variant;                ///< variant of the materials; empty: the file's own
    bool cutoutsCast = false;           ///< MASK surfaces cast with their cutouts, if the technique
                                        ///< can
    std::optional<bool> culls;          ///< Scene::culls, as typed; null: cullsByDefault
    std::optional<double> time;         ///< time of the animation in seconds; null: at rest
    std::string animation;              ///< the animation's name or index; empty: the first
    std::optional<GroundChoice> ground; ///< as typed; null: the verb's default
    SectionOptions section;

    GroundChoice typedGround() const { return ground.value_or(std::nullopt); }
    /// {"ground", "cast-cutouts", "cull", "section", "time", "sun"}, the last three if typed:
    /// report keys in addition to the settings. `scene`: as loaded.
    nlohmann::ordered_json sceneJson(const Scene& scene) const;
    /// Loads the scene with the typed time, ground and section. Warns if there is no animation, or
    /// if `shadows` omit casters that the user requested. `oppositeVertices`: some volumes are
    /// drawn from opposite-vertex records or single triangles. Throws Error(usage) if these were
    /// typed with '--cull auto'; InputError.
    LoadedScene load(Shading shading, ShadowMethod shadows, bool oppositeVertices) const;
    /// The same for rays, which need no shadow data.
    LoadedScene loadForRays(Shading shading) const;

  private:
    bool isPosed() const { return time || !animation.empty(); }
    void prepare(LoadedScene& loaded, ShadowMethod shadows, bool oppositeVertices) const;
};

/// Parses "WxH", both 1 to 65536. Throws CLI::ValidationError that names the option.
std::pair<int, int> sizeFrom(const std::string& text, const std::string& option);

/// Adds the options to a verb; `options` must outlive parsing.
void addCasterOptions(CLI::App& verb, CasterOptions& options);
void addCasterChanges(CLI::App& verb, CasterChanges& changes);
void addLimitOptions(CLI::App& verb, ReadingLimits& limits);
CLI::Option* addSceneFile(CLI::App& verb, SceneOptions& options);
void addSceneOptions(CLI::App& verb, SceneOptions& options);
/// All except lights.
void addUnlitSceneOptions(CLI::App& verb, SceneOptions& options);

/// The word that the option has for them.
std::string glLimitsName(gl::Limits limits);

/// The camera of --camera-from and --camera-to, which frames the scene if they were not typed.
/// Throws Error(usage) if it has no direction.
Camera cameraFor(const ViewOptions& options, const Scene& scene);

/// The typed camera of the file; null if none was typed. For an unknown camera throws Error(usage)
/// that lists the file's cameras.
const SceneCamera* fileCameraFor(const ViewOptions& options, const Scene& scene);

/// The typed lights, the file's, or the default light.
std::vector<Light> lightsFor(const LightOptions& options, const Scene& scene);

/// The request, with the camera of cameraFor(), the file's or the typed matrix, and with at least
/// one light. Throws Error(usage) for options that don't go together.
FrameRequest requestFor(const ViewOptions& options, const Scene& scene);

} // namespace edgeshade::cli
