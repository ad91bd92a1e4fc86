#pragma once

#include "src/render/frame.hpp"
#include "src/scene/load.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// `--size`, camera and lights, as typed; resolved against a scene's bounds by viewFor().
struct ViewOptions {
    int width = 1920;
    int height = 1080;
    std::optional<glm::dvec3> from;
    std::optional<glm::dvec3> to;
    double fovDegrees = 45.0;
    DepthChoice depth;
    std::vector<Light> lights; ///< in the order in which they were typed
};

/// `--weld-tolerance` and `--cast-masked`; `given` if any was typed.
struct CasterOptions {
    CasterSettings settings;
    bool given = false;

    std::optional<CasterSettings> wanted() const {
        return given ? std::optional(settings) : std::nullopt;
    }
};

/// Adds the options to a verb; `options` must outlive parsing.
void addViewOptions(CLI::App& verb, ViewOptions& options);
void addCasterOptions(CLI::App& verb, CasterOptions& options);
void addReportOption(CLI::App& verb, std::string& path);

/// The request: the camera frames the scene where it was not typed, and there is at least one
/// light. Throws Error(usage) for a camera without a direction.
FrameRequest requestFor(const ViewOptions& options, const Scene& scene);

} // namespace edgeshade::cli
