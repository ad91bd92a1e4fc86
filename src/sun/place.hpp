#pragma once

namespace edgeshade::sun {

/// A place on the ground, on the WGS 84 ellipsoid.
struct Place {
    double latitude = 0.0;  ///< degrees, positive north, -90 to 90
    double longitude = 0.0; ///< degrees, positive east, -180 to 180; both are the date line

    bool operator==(const Place&) const = default;
};

/// The place at these coordinates. Throws Error(usage) naming the value that is no valid latitude
/// or longitude; NaN is invalid.
Place placeAt(double latitude, double longitude);

} // namespace edgeshade::sun
