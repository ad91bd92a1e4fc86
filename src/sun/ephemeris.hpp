#pragma once

#include "src/sun/local_time.hpp"
#include "src/sun/place.hpp"
#include "src/sun/refraction.hpp"

namespace edgeshade::sun {

/// Where the middle of the sun's disc is seen from a place.
struct SunPosition {
    double azimuth = 0.0;  ///< degrees clockwise from true north, 0 <= azimuth < 360
    double altitude = 0.0; ///< degrees above the horizon, as refracted: where light comes from
    double airlessAltitude = 0.0; ///< the same without air: the true, topocentric altitude

    /// Whether it lights level ground. A plane through the sun's centre would be lit on neither
    /// side.
    bool isUp() const { return altitude > 0.0; }
};

/// The sun's position by ERFA, the IAU's standards of fundamental astronomy: Earth by Simon et al.
/// 1994 and Moon by Meeus 1998 with aberration, precession and nutation IAU 2000B, parallax from
/// the WGS 84 ellipsoid at height 0, then refraction. UTC is taken for UT1, from which it differs
/// by 0.9 s at the most: 0.004 degrees. `time`: firstYear to lastYear, where
/// docs/measured/sun-positions.md has how far off it is; works for other years too, with less
/// accuracy.
SunPosition sunPosition(const Place& place, Instant time, const Atmosphere& air = {});

} // namespace edgeshade::sun
