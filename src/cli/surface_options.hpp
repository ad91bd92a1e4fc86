#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// The quantity that surfaces are measured by, beside hours.
enum class Quantity {
    hours,
    directKwh, ///< energy of the direct beam, by the weather file
};

/// The options of `sunhours` that go with --surfaces, as typed.
struct SurfaceOptions {
    bool surfaces = false;
    double grid{};                             ///< metres, above 0
    double offset{};                           ///< metres, 0 or more
    double unit{};                             ///< metres that a scene unit is, above 0
    std::vector<std::string> nodes, materials; ///< names; empty: all
    std::vector<std::string> windows; ///< names of their nodes or materials; empty: cells of a grid
    std::optional<double> sill;       ///< metres from the floor to windows; null: unknown
    bool when = false;
    Quantity quantity = Quantity::hours;

    /// {"grid", "offset", "unit", "nodes", "materials", "windows", "sill",
    /// "quantity"}, as in reports.
    nlohmann::ordered_json json() const;
};

/// Adds the options to `sunhours`, which has all others already; `options` must outlive parsing.
void addSurfaceOptions(CLI::App& verb, SurfaceOptions& options);

} // namespace edgeshade::cli
