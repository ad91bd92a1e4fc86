#pragma once

#include "src/hours/exposure.hpp"
#include "src/hours/schedule.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::hours {

/// A point in the world that is asked for its sun.
struct ProbePoint {
    glm::dvec3 point{0.0};
    std::optional<glm::dvec3> normal; ///< not 0; nothing: it faces everywhere
};

/// And what it sees.
struct Probe : ProbePoint {
    std::vector<bool> lit; ///< of each position of its part
};

/// What was found of some of a run's sun positions; a whole run is part 1 of 1. It holds all that
/// pictures and reports are made of, so that they come out the same from a whole run and from
/// merged parts.
struct Part {
    std::size_t number = 1, of = 1; ///< 1 <= number <= of
    /// As reports have them: what was asked for. Those that HoursSettings reads are there.
    nlohmann::ordered_json settings;
    nlohmann::ordered_json camera; ///< likewise
    std::string scene;             ///< a hash of all that casts or is seen, 16 digits
    std::vector<std::string> warnings;
    std::size_t positionsOfRun = 0;  ///< at most mostPositions
    std::vector<Position> positions; ///< every of-th of the run's, in order; see countOfPart()
    std::chrono::minutes offset{0};  ///< the clock's
    Exposure exposure;
    std::vector<Probe> probes;
    /// Names in the file by index, of what the exposure shows.
    std::map<std::uint32_t, std::string> materials, nodes;
};

/// How many of so many positions are the part's: numbers number - 1, number - 1 + of, and so on,
/// from 0. A day's positions, which cost unlike much, are spread evenly then.
std::size_t countOfPart(std::size_t positions, std::size_t number, std::size_t of);

} // namespace edgeshade::hours
