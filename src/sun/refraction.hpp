#pragma once

namespace edgeshade::sun {

/// Air at the observer, which bends light.
struct Atmosphere {
    double pressure = 1010.0;  ///< hPa; 0: no air
    double temperature = 10.0; ///< degrees Celsius
};

/// How much higher than without air a body is seen, in degrees. `altitude`: the one without air, in
/// degrees. Sæmundsson's formula (Sky and Telescope 72, 1986; Meeus, Astronomical Algorithms,
/// chapter 16), which is right to about 0.001 degrees high up and 0.07 of the standard
/// atmosphere's near the horizon; real air near the horizon differs by more from day to day. From 1
/// degree below the horizon, where nothing is seen, it falls to none at 5, so that altitudes have
/// no jump.
double refraction(double altitude, const Atmosphere& air);

} // namespace edgeshade::sun
