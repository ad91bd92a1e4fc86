#pragma once

#include "src/sun/day.hpp"
#include "src/viewer/sun_state.hpp"

#include <optional>
#include <vector>

namespace edgeshade::viewer {

/// A point of the sun's way through the day.
struct ArcPoint {
    glm::dvec3 direction{}; ///< towards it, in the scene
    bool fullHour = false;  ///< of the clock
};

/// What the day of a sun by place and time is like.
struct SunDay {
    std::vector<std::vector<ArcPoint>> arcs; ///< sun::sunPaths()
    std::optional<sun::LocalTime> rise,
        set; ///< the first rise and the last set, where there are any
};

/// Works out the day once, and again when place, date, offset or north are others.
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
