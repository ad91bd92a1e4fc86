#include "src/viewer/sun_state.hpp"

#include "src/sun/direction.hpp"

#include <algorithm>

namespace edgeshade::viewer {
namespace {

using namespace std::chrono;

constexpr double wholeTurn = 360.0;

/// Applies `read` to a value; reports its error as an error of the field.
template <class Read>
auto readAs(const char* field, Read read) {
    try {
        return read();
    } catch (const Error& error) {
        throw Error(ExitStatus::usage, std::string(field) + ": " + error.what() + ".");
    }
}

} // namespace

glm::dvec3 SunState::direction() const {
    return sun::towardsSun(position(), north);
}

std::optional<SunState> sunFrom(const Field& field, const std::optional<SunState>& base) {
    if (field.isNull()) return std::nullopt;
    SunState sun = base.value_or(SunState());
    bool placed = base.has_value(), timed = placed;
    field.forEachMember([&](const std::string& key, const Field& value) {
        if (key == "place") {
            const auto at = value.place<2>();
            sun.place = readAs("sun.place", [&] { return sun::placeAt(at.x, at.y); });
            placed = true;
        } else if (key == "time") {
            const std::string text = value.word();
            sun.time = readAs("sun.time", [&] { return sun::localTimeFromText(text); });
            timed = true;
        } else if (key == "north") {
            sun.north = value.number(-wholeTurn, wholeTurn);
        } else {
            return false;
        }
        return true;
    });
    if (!placed || !timed) field.fail("a sun with a 'place' and a 'time'");
    return sun;
}

nlohmann::ordered_json toJson(const std::optional<SunState>& sun) {
    if (!sun) return nullptr;
    return {{"place", {sun->place.latitude, sun->place.longitude}},
            {"time", sun::textOf(sun->time)},
            {"north", sun->north}};
}

SunState movedBy(const SunState& sun, seconds by) {
    const auto first = sys_days(year(sun::firstYear) / January / 1) - sun.time.offset;
    const auto last =
        sys_days(year(sun::lastYear) / December / 31) + days(1) - seconds(1) - sun.time.offset;
    SunState moved = sun;
    moved.time.instant = std::clamp<sun::Instant>(sun.time.instant + by, first, last);
    return moved;
}

SunState movedWithinDay(const SunState& sun, seconds by) {
    const sun::Instant start = sun::startOfDay(sun.time);
    const seconds day = days(1);
    SunState moved = sun;
    moved.time.instant = start + ((sun.time.instant - start + by) % day + day) % day;
    return moved;
}

} // namespace edgeshade::viewer
