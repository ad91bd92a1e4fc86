#pragma once

namespace edgeshade::sun {

/// A place on the ground, on the WGS 84 ellipsoid.
struct Place {
    double latitude = 0.0;  ///< degrees, north is positive, -90 to 90
    double longitude = 0.0; ///< degrees, east is positive, -180 to 180; both are the date line

    bool operator==(const Place&) const = default;
};

/// The place. Throws Error(usage) that names the value which is no latitude or no longitude; NaN is
/// neither.
Place placeAt(double latitude, double longitude);

} // namespace edgeshade::sun
