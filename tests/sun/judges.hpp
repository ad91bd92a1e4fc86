#pragma once

#include "src/sun/ephemeris.hpp"

namespace edgeshade::test {

/// The airless altitude and the azimuth from another source, in degrees.
struct Judgement {
    double azimuth, altitude;
};

/// By ERFA's full models: Earth from an ephemeris fitted to JPL's DE405, IAU 2006/2000A precession
/// and nutation, accurate to a few thousandths of an arc second from 1900 to 2100.
Judgement fullModel(const sun::Place& place, sun::Instant time);

/// By parts of libnova: Earth by VSOP87, precession, mean sidereal time and horizontal coordinates.
/// Aberration and parallax are added. Nutation moves the stars and the equinox together, and its
/// remainder, 0.003 degrees, is left out. (libnova 0.16's own ln_get_solar_equ_coords omits the
/// precession since 2000.)
Judgement libnova(const sun::Place& place, sun::Instant time);

/// The angle between the two in the sky, in degrees.
double apart(const Judgement& a, const sun::SunPosition& b);

} // namespace edgeshade::test
