#include "src/viewer/sun_day.hpp"

#include "src/sun/direction.hpp"

namespace edgeshade::viewer {
namespace {

using namespace std::chrono;

SunDay dayFrom(const SunState& start) {
    SunDay day;
    const sun::Instant from = start.time.instant, to = from + hours(24);
    for (const auto& path : sun::sunPaths(start.place, from, to, minutes(10))) {
        auto& arc = day.arcs.emplace_back();
        for (const sun::TimedPosition& on : path)
            arc.push_back({sun::towardsSun(on.position, start.north),
                           (on.time - from) % hours(1) == seconds(0)});
        const auto local = [&](sun::Instant time) {
            return sun::LocalTime{time, start.time.offset};
        };
        if (!day.rise && path.front().time > from) day.rise = local(path.front().time);
        if (path.back().time < to) day.set = local(path.back().time);
    }
    return day;
}

nlohmann::ordered_json textOrNull(const std::optional<sun::LocalTime>& time) {
    if (!time) return nullptr;
    return sun::textOf(*time);
}

} // namespace

const SunDay& SunDays::of(const SunState& sun) {
    SunState start = sun;
    start.time.instant = sun::startOfDay(sun.time);
    if (known_ != start) {
        day_ = dayFrom(start);
        known_ = start;
    }
    return day_;
}

nlohmann::ordered_json toJson(const sun::SunPosition& position, const SunDay& day) {
    return {{"azimuth", position.azimuth},
            {"altitude", position.altitude},
            {"airless_altitude", position.airlessAltitude},
            {"up", position.isUp()},
            {"rise", textOrNull(day.rise)},
            {"set", textOrNull(day.set)}};
}

} // namespace edgeshade::viewer
