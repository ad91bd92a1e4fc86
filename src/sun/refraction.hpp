#pragma once

namespace edgeshade::sun {

/// Air at the observer, which refracts light.
struct Atmosphere {
    double pressure = 1010.0;  ///< hPa; 0: no air
    double temperature = 10.0; ///< degrees Celsius
};

/// How much refraction raises a body, in degrees. `altitude`: without refraction, in degrees.
/// Sæmundsson's formula (Sky and Telescope 72, 1986; Meeus, Astronomical Algorithms, chapter 16),
/// accurate to about 0.001 degrees high up and 0.07 near the horizon, for the standard atmosphere.
/// Real air near the horizon differs by more from day to day. From 1 degree below the horizon,
/// where nothing is visible, it falls to 0 at 5, so that altitudes have no jump.
double refraction(double altitude, const Atmosphere& air);

} // namespace edgeshade::sun
