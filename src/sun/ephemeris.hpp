#pragma once

#include "src/sun/local_time.hpp"
#include "src/sun/place.hpp"
#include "src/sun/refraction.hpp"

namespace edgeshade::sun {

/// Direction of the centre of the sun's disc as seen from a place.
struct SunPosition {
    double azimuth = 0.0;  ///< degrees clockwise from true north, 0 <= azimuth < 360
    double altitude = 0.0; ///< degrees above the horizon, with refraction: the direction of the
                           ///< light
    double airlessAltitude = 0.0; ///< degrees without refraction: the true, topocentric altitude

    /// Whether the sun lights level ground. At altitude 0 the ground's plane passes through its
    /// centre, and neither side is lit.
    bool isUp() const { return altitude > 0.0; }
};

/// The sun's position by ERFA, the IAU's standards of fundamental astronomy. Earth by Simon et al.
/// 1994 and Moon by Meeus 1998, with aberration, precession and nutation IAU 2000B, parallax from
/// the WGS 84 ellipsoid at height 0, then refraction. UTC is taken for UT1, from which it differs
/// by at most 0.9 s: 0.004 degrees. `time`: firstYear to lastYear; docs/measured/sun-positions.md
/// gives the error. Other years work too, with less accuracy.
SunPosition sunPosition(const Place& place, Instant time, const Atmosphere& air = {});

} // namespace edgeshade::sun
