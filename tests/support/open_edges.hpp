#pragma once

// The closed chain (docs/method.md) on packed records, by multiplicities alone.

#include "preprocess/volumes/shadow_data.hpp"
#include "tests/support/chain.hpp"
#include "tests/support/record_multiplicity.hpp"

#include <cmath>
#include <vector>

namespace edgeshade::test {

/// Number of edges at which `Method`'s sides don't fit its caps.
template <class Method>
std::size_t openEdgesOf(const BatchTopology& topology, const BatchShadow& shadow,
                        const glm::vec4& light) {
    const auto rounded = [](float value) { return static_cast<int>(std::lround(value)); };
    std::vector<int> multiplicities, signs;
    for (std::size_t r = 0; r < shadow.sides.recordCount(); ++r)
        multiplicities.push_back(
            rounded(recordMultiplicity<Method>(sidesRecord(shadow.sides, r), light)));
    for (std::size_t r = 0; r < shadow.caps.recordCount(); ++r)
        signs.push_back(rounded(capSign<Method>(capsRecord(shadow.caps, r), light)));
    return openEdges(topology, shadow.sides.maxMultiplicity, multiplicities, signs);
}

} // namespace edgeshade::test
