#pragma once

#include "src/rays/lit_bits.hpp"

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>

namespace edgeshade::hours {

/// A point whose light is measured, with the side that it faces.
struct Sensor {
    /// Value of `batch` for a sensor off all surfaces.
    static constexpr std::uint32_t none = 0xFFFFFFFF;

    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0};       ///< of length 1
    std::uint32_t batch = none;   ///< of the triangle that the sensor is on
    std::uint32_t firstIndex = 0; ///< of that triangle's corners, in Geometry::indices
};

/// Light by sensor and direction: a sensor is lit if it faces the direction and no caster is in the
/// way. Directions point towards the light, have length 1, and are in the world.
using SensorLight = std::function<rays::LitBits(std::span<const Sensor> sensors,
                                                std::span<const glm::dvec3> directions)>;

} // namespace edgeshade::hours
