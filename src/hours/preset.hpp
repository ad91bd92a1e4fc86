#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgeshade::hours {

/// A recommendation of sunlight, by its name in --preset.
struct Preset {
    std::string_view name;
    std::string_view source;                ///< of the recommendation
    double threshold = 0.0;                 ///< hours per day
    bool ofHalfTheArea = false;             ///< half of the area must reach the threshold
    std::chrono::month_day first{}, last{}; ///< days of the year it applies to; the last is the
                                            ///< default
    double minAltitude = 0.0;               ///< degrees; the sun counts above it by default
    /// Least heights in metres of a window's point over its sill and over the floor; 0: the point
    /// is in the window's middle.
    double overSill = 0.0, overFloor = 0.0;

    /// Metres of a window's point over the pane's lower edge. `sill`: of that edge over the floor;
    /// null: unknown, so that the floor decides nothing. Null: in the window's middle.
    std::optional<double> riseInWindow(const std::optional<double>& sill) const;
};

/// The year of a preset's default day. It is fixed, so that the same command gives the same picture
/// in any year. From year to year the sun then differs by less than half a degree.
inline constexpr std::chrono::year presetYear{2026};

std::span<const Preset> presets();

/// Null if there is none of that name.
const Preset* findPreset(std::string_view name);

} // namespace edgeshade::hours
