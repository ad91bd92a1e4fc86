#pragma once

#include "src/hours/positions.hpp"

#include <chrono>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace edgeshade::hours {

/// The members that runs of pictures and of surfaces share.
struct RunHead {
    /// The settings requested, as in reports. Includes those that HoursSettings reads.
    nlohmann::ordered_json settings;
    std::string scene; ///< a hash of all casters and surfaces, 16 digits
    std::vector<std::string> warnings;
    std::vector<Position> positions;                       ///< those of a part; see countOfPart()
    std::chrono::minutes offset{0};                        ///< of the clock
    std::map<std::uint32_t, std::string> materials, nodes; ///< names, by index in the file
};

/// The place of a part in its run; a whole run is part 1 of 1.
struct PartNumber {
    std::size_t number = 1, of = 1; ///< 1 <= number <= of
    std::size_t positionsOfRun = 0; ///< at most mostPositions
};

} // namespace edgeshade::hours
