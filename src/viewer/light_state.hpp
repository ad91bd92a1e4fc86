#pragma once

#include "src/shadow/lights/light.hpp"
#include "src/viewer/state_field.hpp"

namespace edgeshade::viewer {

/// A light of a view's state: either [x, y, z, w], for a point light perhaps with a range as a
/// fifth number, or with names:
/// {"position": [x,y,z] of a point light, or "direction": [x,y,z] towards a directional light,
///  "color": [r,g,b] linear, "intensity": candela or lux, "range": of a point light,
///  "cone": {"axis": [x,y,z] along which a spot shines, "inner": deg, "outer": deg},
///  and its extent: "radius" of a sphere or "size": [width, height] and "facing": [x,y,z] of a
///  rectangle, for a point light; "angle": deg, at most 90, of the disc of a directional light}
/// Only the place is required. A point light with an intensity falls off with the square of the
/// distance. Throws Error(usage) that names the field and its value.
Light lightFrom(const Field& field);

/// As an array if an array can express the light, else by names.
nlohmann::ordered_json toJson(const Light& light);

/// By names.
nlohmann::ordered_json namedJson(const Light& light);

} // namespace edgeshade::viewer
