#pragma once

#include "src/hours/exposure.hpp"
#include "src/hours/run_head.hpp"
#include "src/hours/schedule.hpp"

#include <optional>
#include <span>
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
/// parts. Names are those of the exposure's materials and nodes.
struct Part : PartNumber, RunHead {
    nlohmann::ordered_json camera; ///< the camera requested, as in reports
    Exposure exposure;
    std::vector<Probe> probes;
};

/// The number of a part's positions, of `positions`: those with index number - 1, number - 1 + of,
/// and so on, from 0. This spreads a day's positions, which differ in cost, evenly over the parts.
std::size_t countOfPart(std::size_t positions, std::size_t number, std::size_t of);

/// These positions.
std::vector<Position> ofPart(std::span<const Position> positions, std::size_t number,
                             std::size_t of);

} // namespace edgeshade::hours
