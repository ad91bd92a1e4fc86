#pragma once

#include "src/cli/sun_options.hpp"
#include "src/shadow/lights/light.hpp"

#include <CLI/CLI.hpp>
#include <optional>
#include <vector>

namespace edgeshade::cli {

/// The lights of a picture for which none were typed.
enum class LightChoice {
    file,     ///< the file's; if it has none, as `fallback`
    fallback, ///< defaultLight()
};

/// `--light-radius` or `--light-size` for point lights, and `--sun-angle` for directional lights.
struct ExtentOptions {
    std::optional<LightExtent> ofPoints, ofSuns;

    bool typed() const { return ofPoints || ofSuns; }
    /// Throws Error(usage) if no light can have the extent.
    void giveTo(std::vector<Light>& lights) const;
};

/// `--light`, `--sun`, `--light-range`, `--lights`, extents, and the sun by place and time.
struct LightOptions {
    std::vector<Light> typed; ///< in the order in which they were typed
    ExtentOptions extents;
    SunOptions sun;
    std::optional<LightChoice> choice;
    std::optional<double> range; ///< of the point lights that were typed, scene units

    /// The typed lights, preceded by the sun by place and time. Throws Error(usage) for too many.
    std::vector<Light> all() const;
};

/// Adds the options to a verb; `options` must outlive parsing.
void addLightOptions(CLI::App& verb, LightOptions& options);

/// Parses "X,Y,Z[:COLOR[:INTENSITY]]". `w`: 1 for a point light, 0 for a directional light. Throws
/// CLI::ValidationError that names the option.
Light lightFrom(const std::string& text, const std::string& option, double w);

} // namespace edgeshade::cli
