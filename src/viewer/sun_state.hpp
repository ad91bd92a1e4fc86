#pragma once

#include "src/sun/ephemeris.hpp"
#include "src/viewer/state_field.hpp"

#include <chrono>
#include <optional>

namespace edgeshade::viewer {

/// A sun at its position for a place and a time.
struct SunState {
    sun::Place place;
    sun::LocalTime time;
    double north = 0.0; ///< degrees, see sun::towardsSun()

    bool operator==(const SunState&) const = default;

    sun::SunPosition position() const { return sun::sunPosition(place, time.instant); }
    glm::dvec3 direction() const; ///< towards the sun, in the scene
};

/// {"place": [latitude, longitude], "time": "2026-06-21T14:30+02:00", "north": degrees, -360 to
/// 360}; missing members are taken from `base`, without which place and time are required. null: no
/// sun. Throws Error(usage) that names the field and its value.
std::optional<SunState> sunFrom(const Field& field, const std::optional<SunState>& base);

nlohmann::ordered_json toJson(const std::optional<SunState>& sun);

/// The sun at another time on the same clock, within the years that sun::localTimeFromText() takes.
SunState movedBy(const SunState& sun, std::chrono::seconds seconds);

/// The same, within the same day: after 24 h comes 0 h.
SunState movedWithinDay(const SunState& sun, std::chrono::seconds seconds);

} // namespace edgeshade::viewer
