#include "src/hours/preset.hpp"

#include <algorithm>
#include <array>

namespace edgeshade::hours {
namespace {

using namespace std::chrono;

constexpr month_day february = February / 1, equinox = March / 21, winter = January / 17;

/// DIN 5034-1: lower sun does not count as sunlight in a room.
constexpr double dinAltitude = 6.0;

/// EN 17037: where the reference point is at least.
constexpr double enOverSill = 0.3, enOverFloor = 1.2;

constexpr std::array<Preset, 6> presetTable = {{
    {"en17037-minimum", "EN 17037, minimum", 1.5, false, february, equinox, 0.0, enOverSill,
     enOverFloor},
    {"en17037-medium", "EN 17037, medium", 3.0, false, february, equinox, 0.0, enOverSill,
     enOverFloor},
    {"en17037-high", "EN 17037, high", 4.0, false, february, equinox, 0.0, enOverSill, enOverFloor},
    {"bre-garden", "BRE 209, gardens and open spaces", 2.0, true, equinox, equinox},
    {"din5034-winter", "DIN 5034-1, winter", 1.0, false, winter, winter, dinAltitude},
    {"din5034-equinox", "DIN 5034-1, equinox", 4.0, false, March / 20, equinox, dinAltitude},
}};

} // namespace

std::optional<double> Preset::riseInWindow(const std::optional<double>& sill) const {
    if (overSill == 0.0) return std::nullopt;
    return sill ? std::max(overSill, overFloor - *sill) : overSill;
}

std::span<const Preset> presets() {
    return presetTable;
}

const Preset* findPreset(std::string_view name) {
    const auto found = std::ranges::find(presetTable, name, &Preset::name);
    return found == presetTable.end() ? nullptr : &*found;
}

} // namespace edgeshade::hours
