#pragma once

#include <chrono>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace edgeshade::hours {

/// A recommendation of sunlight, by the name that --preset has for it.
struct Preset {
    std::string_view name;
    std::string_view source;                ///< what recommends it
    double threshold = 0.0;                 ///< hours on the day
    bool ofHalfTheArea = false;             ///< half of the area must have as much
    std::chrono::month_day first{}, last{}; ///< days of the year that it is for; the last is taken
                                            ///< where nobody says when
};

/// The year of a preset's day where no date was typed: a fixed one, so that the same words give
/// the same picture in any year. From year to year the sun there
/// differs by less than half a degree.
inline constexpr std::chrono::year presetYear{2026};

std::span<const Preset> presets();

/// Null where there is none of that name.
const Preset* findPreset(std::string_view name);

} // namespace edgeshade::hours
