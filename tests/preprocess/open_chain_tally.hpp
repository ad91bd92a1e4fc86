#pragma once

// The closed chain in bulk: for one triangle it is closed exactly when every edge's multiplicity
// is the triangle's sign (negated for the edge from the smallest to the largest vertex).
// closed_chain_test.cpp shows that this agrees with the chain itself.
//
// The implementation is compiled twice, without and with fused multiply-adds.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace edgeshade::test {

enum class ChainMethod { referenceEdge, threeEdge, singleEdge };

constexpr std::size_t chainMethodCount = 3;

struct OpenChainTally {
    static constexpr std::size_t kinds = 7; ///< of lights, see hard_lights.hpp

    std::array<std::uint64_t, kinds> pairs{};   ///< triangles with a light, by its kind
    std::array<std::uint64_t, kinds> casting{}; ///< of those, with a sign other than 0
    /// Number of these pairs whose chain has a boundary.
    std::array<std::array<std::uint64_t, kinds>, chainMethodCount> open{};
    bool fused = false; ///< whether the arithmetic was contracted to fused multiply-adds

    /// Whether the pairs are hard enough for "none is open" to be meaningful: nearly all triangles
    /// cast under lights in general positions, and the single edge opens at least a tenth of the
    /// chains where the light is in line with the triangle.
    bool isTelling() const;

    std::uint64_t openOf(ChainMethod method) const {
        std::uint64_t sum = 0;
        for (const std::uint64_t count : open[static_cast<std::size_t>(method)])
            sum += count;
        return sum;
    }
};

/// Whether the chain of one triangle (corners in ascending order) has a boundary, by ChainMethod.
std::array<bool, chainMethodCount> isOpenByMethod(const std::array<glm::vec3, 3>& corners,
                                                  const glm::vec4& light);

/// Tries `pairs` random triangles with one light each, the same ones for all methods.
OpenChainTally tallyOpenChains(std::uint64_t pairs, std::uint64_t seed);

/// Prints the tally and records it as properties of the running test.
void reportOpenChains(const OpenChainTally& tally);

/// Triangle-light pairs of a tally.
constexpr std::uint64_t tallyPairs = 10'500'000;

} // namespace edgeshade::test
