#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

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

/// A bit for each sensor and each direction, in rows of whole words, one row a sensor.
class LitBits {
  public:
    LitBits(std::size_t sensors, std::size_t directions)
        : wordsOfRow_((directions + 63) / 64), words_(sensors * wordsOfRow_, 0) {}

    void set(std::size_t sensor, std::size_t direction) {
        words_[sensor * wordsOfRow_ + direction / 64] |= std::uint64_t{1} << direction % 64;
    }
    /// Direction 64 w + b is bit b, from the lowest on, of word w. Bits beyond the last direction
    /// are 0.
    std::span<std::uint64_t> row(std::size_t sensor) {
        return std::span(words_).subspan(sensor * wordsOfRow_, wordsOfRow_);
    }
    std::span<const std::uint64_t> row(std::size_t sensor) const {
        return std::span(words_).subspan(sensor * wordsOfRow_, wordsOfRow_);
    }

  private:
    std::size_t wordsOfRow_;
    std::vector<std::uint64_t> words_;
};

/// Which directions light which sensors: the sensor faces the direction, and no caster is in the
/// way. Directions point towards the light, have length 1, and are in the world.
using SensorLight =
    std::function<LitBits(std::span<const Sensor> sensors, std::span<const glm::dvec3> directions)>;

} // namespace edgeshade::hours
