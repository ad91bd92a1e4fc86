#pragma once

#include "src/hours/exposure.hpp"
#include "src/hours/schedule.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace edgeshade::hours {

/// A point in the world whose sunlight is measured.
struct ProbePoint {
    glm::dvec3 point{0.0};
    std::optional<glm::dvec3> normal; ///< not 0; null: the point has no facing
};

/// A point and its result.
struct Probe : ProbePoint {
    std::vector<bool> lit; ///< one per position of its part
};

/// Results for some of a run's sun positions; a whole run is part 1 of 1. It holds everything that
/// pictures and reports are made from. They are therefore the same from a whole run and from merged
/// parts.
struct Part {
    std::size_t number = 1, of = 1; ///< 1 <= number <= of
    /// The settings requested, as in reports. Includes those that HoursSettings reads.
    nlohmann::ordered_json settings;
    nlohmann::ordered_json camera; ///< the camera requested, as in reports
    std::string scene;             ///< a hash of all casters and visible surfaces, 16 digits
    std::vector<std::string> warnings;
    std::size_t positionsOfRun = 0;  ///< at most mostPositions
    std::vector<Position> positions; ///< every of-th position of the run, in order; see
                                     ///< countOfPart()
    std::chrono::minutes offset{0};  ///< offset of the clock
    Exposure exposure;
    std::vector<Probe> probes;
    /// Names of the exposure's materials and nodes, by index in the file.
    std::map<std::uint32_t, std::string> materials, nodes;
};

/// The number of a part's positions, of `positions`: those with index number - 1, number - 1 + of,
/// and so on, from 0. This spreads a day's positions, which differ in cost, evenly over the parts.
std::size_t countOfPart(std::size_t positions, std::size_t number, std::size_t of);

/// These positions.
std::vector<Position> ofPart(std::span<const Position> positions, std::size_t number,
                             std::size_t of);

} // namespace edgeshade::hours
