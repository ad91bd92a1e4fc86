#pragma once

#include "src/sun/day.hpp"
#include "src/viewer/sun_state.hpp"

#include <optional>
#include <vector>

namespace edgeshade::viewer {

/// A point of the sun's path over the day.
struct ArcPoint {
    glm::dvec3 direction{}; ///< towards the sun, in the scene
    bool fullHour = false;  ///< at a full hour of the clock
};

/// The course of one day for a sun by place and time.
struct SunDay {
    std::vector<std::vector<ArcPoint>> arcs; ///< sun::sunPaths()
    std::optional<sun::LocalTime> rise,
        set; ///< the first rise and the last set, if there are any
};

/// Computes the day once, and again only when place, date, offset or north have changed.
class SunDays {
  public:
    const SunDay& of(const SunState& sun);

  private:
    std::optional<SunState> known_; ///< at the start of its day
    SunDay day_;
};

/// {"azimuth", "altitude", "airless_altitude", degrees; "up"; "rise", "set": a time, or null}.
nlohmann::ordered_json toJson(const sun::SunPosition& position, const SunDay& day);

} // namespace edgeshade::viewer
