#include "src/sun/ephemeris.hpp"

#include <cmath>
#include <erfa.h>
#include <glm/glm.hpp>

namespace edgeshade::sun {
namespace {

constexpr double unixEpoch = 2440587.5; ///< as a Julian date
constexpr double secondsADay = 86400.0;
constexpr double metresOfAu = 149597870700.0;
constexpr double lightDaysOfAu = 499.0047838 / secondsADay;
constexpr double earthOfMoonMass = 81.30057;

/// A Julian date in two parts, as ERFA takes it, which together are precise to the second and
/// better.
struct JulianDate {
    double day, fraction;
};

JulianDate julianDate(double unixSeconds) {
    return {unixEpoch, unixSeconds / secondsADay};
}

/// Seconds from UTC to terrestrial time. Before 1960 there was no UTC, and after 2100 it is
/// unknown: the nearest known value is close enough, since the sun moves by 0.04 arc seconds in a
/// second.
double terrestrialSeconds(Instant time) {
    const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(time));
    double leapSeconds = 0.0;
    eraDat(static_cast<int>(date.year()), static_cast<int>(static_cast<unsigned>(date.month())),
           static_cast<int>(static_cast<unsigned>(date.day())), 0.0, &leapSeconds);
    return 32.184 + leapSeconds;
}

glm::dvec3 vectorOf(const double (&v)[3]) {
    return {v[0], v[1], v[2]};
}

/// Vector from Earth's centre to the apparent sun, in au, equator and equinox of J2000. Both bodies
/// are taken at the time when the light left the sun.
glm::dvec3 apparentSun(const JulianDate& tt) {
    double barycentre[2][3], moon[2][3];
    eraPlan94(tt.day, tt.fraction, 3, barycentre);
    eraMoon98(tt.day, tt.fraction, moon);
    const glm::dvec3 earth = vectorOf(barycentre[0]) - vectorOf(moon[0]) / (1.0 + earthOfMoonMass);
    const double lightDays = glm::length(earth) * lightDaysOfAu;
    return -(earth - vectorOf(barycentre[1]) * lightDays);
}

/// Vector from Earth's centre to the place, in au.
glm::dvec3 geocentric(double longitude, double latitude) {
    double metres[3];
    eraGd2gc(1, longitude, latitude, 0.0, metres); // 1: WGS 84
    return vectorOf(metres) / metresOfAu;
}

/// Rotates with Earth: from the true equator and equinox of date to Greenwich's meridian.
glm::dvec3 terrestrial(const glm::dvec3& v, const JulianDate& ut, const JulianDate& tt) {
    double ofDate[3][3];
    eraPnm00b(tt.day, tt.fraction, ofDate);
    const glm::dvec3 turned(glm::dot(vectorOf(ofDate[0]), v), glm::dot(vectorOf(ofDate[1]), v),
                            glm::dot(vectorOf(ofDate[2]), v));
    const double angle = eraGst00b(ut.day, ut.fraction);
    const double c = std::cos(angle), s = std::sin(angle);
    return {c * turned.x + s * turned.y, c * turned.y - s * turned.x, turned.z};
}

} // namespace

SunPosition sunPosition(const Place& place, Instant time, const Atmosphere& air) {
    const auto seconds = static_cast<double>(time.time_since_epoch().count());
    const JulianDate ut = julianDate(seconds);
    const JulianDate tt = julianDate(seconds + terrestrialSeconds(time));
    const double longitude = glm::radians(place.longitude);
    const double latitude = glm::radians(place.latitude);
    const glm::dvec3 sun = terrestrial(apparentSun(tt), ut, tt) - geocentric(longitude, latitude);

    // East, north and up at the place, in axes fixed to Earth.
    const double cosLon = std::cos(longitude), sinLon = std::sin(longitude);
    const double cosLat = std::cos(latitude), sinLat = std::sin(latitude);
    const double east = glm::dot(glm::dvec3(-sinLon, cosLon, 0.0), sun);
    const double north = glm::dot(glm::dvec3(-sinLat * cosLon, -sinLat * sinLon, cosLat), sun);
    const double up = glm::dot(glm::dvec3(cosLat * cosLon, cosLat * sinLon, sinLat), sun);

    SunPosition position;
    position.azimuth = glm::degrees(std::atan2(east, north));
    if (position.azimuth < 0.0) position.azimuth += 360.0;
    if (position.azimuth >= 360.0) position.azimuth = 0.0; // rounded from just below 0
    position.airlessAltitude = glm::degrees(std::atan2(up, std::hypot(east, north)));
    position.altitude = position.airlessAltitude + refraction(position.airlessAltitude, air);
    return position;
}

} // namespace edgeshade::sun
