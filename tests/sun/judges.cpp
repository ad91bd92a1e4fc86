#include "tests/sun/judges.hpp"

#include <algorithm>
#include <cmath>
#include <erfa.h>
#include <erfam.h>
#include <glm/glm.hpp>
#include <libnova/dynamical_time.h>
#include <libnova/earth.h>
#include <libnova/julian_day.h>
#include <libnova/ln_types.h>
#include <libnova/precession.h>
#include <libnova/sidereal_time.h>
#include <libnova/transform.h>

namespace edgeshade::test {
namespace {

constexpr double unixEpoch = 2440587.5;

double unixDays(sun::Instant time) {
    return static_cast<double>(time.time_since_epoch().count()) / 86400.0;
}

glm::dvec3 towards(double azimuth, double altitude) {
    const double az = glm::radians(azimuth), alt = glm::radians(altitude);
    return {std::cos(alt) * std::sin(az), std::cos(alt) * std::cos(az), std::sin(alt)};
}

} // namespace

Judgement fullModel(const sun::Place& place, sun::Instant time) {
    const double ut = unixDays(time);
    const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(time));
    double leap = 0.0;
    eraDat(int(date.year()), int(unsigned(date.month())), int(unsigned(date.day())), 0.0, &leap);
    const double tt = ut + (32.184 + leap) / 86400.0;

    double earth[2][3], barycentric[2][3];
    eraEpv00(unixEpoch, tt, earth, barycentric);
    const double lightTime = eraPm(earth[0]) * 499.004784 / 86400.0;
    eraEpv00(unixEpoch, tt - lightTime, earth, barycentric);
    double sun[3], ofDate[3][3], gast = eraGst06a(unixEpoch, ut, unixEpoch, tt);
    eraSxp(-1.0, earth[0], sun);
    eraPnm06a(unixEpoch, tt, ofDate);
    eraRz(gast, ofDate);
    eraRxp(ofDate, sun, sun);
    double observer[3];
    eraGd2gc(ERFA_WGS84, glm::radians(place.longitude), glm::radians(place.latitude), 0.0,
             observer);
    eraSxp(1.0 / ERFA_DAU, observer, observer);
    eraPmp(sun, observer, sun);

    double longitude, latitude, azimuth, altitude;
    eraC2s(sun, &longitude, &latitude);
    eraHd2ae(glm::radians(place.longitude) - longitude, latitude, glm::radians(place.latitude),
             &azimuth, &altitude);
    return {glm::degrees(azimuth), glm::degrees(altitude)};
}

Judgement libnova(const sun::Place& place, sun::Instant time) {
    const double day = unixEpoch + unixDays(time);
    ln_helio_posn earth; // ecliptic and equinox of J2000
    ln_get_earth_helio_coords(ln_get_jde(day), &earth);
    ln_lnlat_posn sun{earth.L + 180.0 - 20.4898 / 3600.0 / earth.R, -earth.B};
    ln_equ_posn of2000, ofDate;
    ln_get_equ_from_ecl(&sun, JD2000, &of2000);
    ln_get_equ_prec(&of2000, day, &ofDate);
    ln_lnlat_posn observer{place.longitude, place.latitude};
    ln_hrz_posn horizontal;
    ln_get_hrz_from_equ_sidereal_time(&ofDate, &observer, ln_get_mean_sidereal_time(day),
                                      &horizontal);
    const double parallax = 8.794 / 3600.0 * std::cos(glm::radians(horizontal.alt));
    // libnova counts from the south.
    return {std::fmod(horizontal.az + 180.0, 360.0), horizontal.alt - parallax};
}

double apart(const Judgement& a, const sun::SunPosition& b) {
    const glm::dvec3 difference =
        towards(a.azimuth, a.altitude) - towards(b.azimuth, b.airlessAltitude);
    return glm::degrees(2.0 * std::asin(std::min(glm::length(difference) / 2.0, 1.0)));
}

} // namespace edgeshade::test
