#pragma once

#include "src/render/frame/frame.hpp"
#include "src/scene/load.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace edgeshade::cli {

/// `--size`, camera and lights, as typed; resolved against a scene's bounds by viewFor().
struct ViewOptions {
    int width = 1920;
    int height = 1080;
    std::optional<glm::dvec3> from;
    std::optional<glm::dvec3> to;
    std::optional<glm::dmat4> cameraMatrix; ///< a rigid view matrix, in place of the two
    double fovDegrees = 45.0;
    std::optional<double> orthoHeight; ///< of an orthographic picture, in scene units
    DepthChoice depth;
    std::vector<Light> lights; ///< in the order in which they were typed

    double aspect() const { return static_cast<double>(width) / height; }
    bool hasCamera() const { return from || to || cameraMatrix; }
};

/// `--weld-tolerance`, `--flat-tolerance` and `--caster-error`, where they were typed.
struct CasterChanges {
    std::optional<double> weldTolerance, flatTolerance, casterError;

    bool any() const { return weldTolerance || flatTolerance || casterError; }
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

/// What every verb that draws a scene is told of it. `FILE` itself each adds in its own words.
struct SceneOptions {
    std::string input;
    ViewOptions view;
    CasterOptions casters;
    ReadingLimits limits;
    gl::Limits glLimits = gl::Limits::device;
    std::string variant; ///< of its materials; empty: the file's own

    LoadedScene load(Shading shading) const {
        return loadScene(input, casters.wanted(), limits, {}, {variant, shading});
    }
};

/// The words that an option takes, in the order in which help and messages list them.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

/// The choices' words with `separator` between them.
template <class Value>
std::string wordsOf(const Choices<Value>& choices, const std::string& separator) {
    std::string words;
    for (const auto& choice : choices)
        words += (words.empty() ? "" : separator) + choice.first;
    return words;
}

/// Adds an option whose value is one of a few words, and nothing else: CLI11's own transformer
/// takes the numbers behind them too. `value`, a Value or an optional one, must outlive parsing.
template <class Target, class Value = Target>
void addChoice(CLI::App& verb, const std::string& option, Target& value,
               const std::vector<std::pair<std::string, Value>>& choices, const std::string& help) {
    const auto use = [option, &value, choices](const std::string& text) {
        for (const auto& [word, meaning] : choices)
            if (word == text) {
                value = meaning;
                return;
            }
        throw CLI::ValidationError(option, "'" + text + "' is none of " + wordsOf(choices, ", "));
    };
    verb.add_option_function<std::string>(option, use, help)->type_name(wordsOf(choices, "|"));
}

/// "WxH", both 1 to 65536. Throws CLI::ValidationError that names the option.
std::pair<int, int> sizeFrom(const std::string& text, const std::string& option);

/// Refuses NaN and infinity, which CLI::Range lets through.
CLI::Validator finite();

/// Adds the options to a verb; `options` must outlive parsing.
void addCasterOptions(CLI::App& verb, CasterOptions& options);
void addCasterChanges(CLI::App& verb, CasterChanges& changes);
void addReportOption(CLI::App& verb, std::string& path);
void addSamplesOption(CLI::App& verb, int& samples);
void addSceneOptions(CLI::App& verb, SceneOptions& options);

/// The word that the option has for them.
std::string glLimitsName(gl::Limits limits);

/// The camera, which frames the scene where it was not typed. Throws Error(usage) for one without a
/// direction.
Camera cameraFor(const ViewOptions& options, const Scene& scene);

/// The request, with that camera or the matrix that was typed, and at least one light. Throws
/// Error(usage) for what does not go together.
FrameRequest requestFor(const ViewOptions& options, const Scene& scene);

} // namespace edgeshade::cli
