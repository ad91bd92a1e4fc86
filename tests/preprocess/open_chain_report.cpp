#include "open_chain_tally.hpp"
#include "tests/support/hard_lights.hpp"

#include <gtest/gtest.h>
#include <iostream>
#include <string>

namespace edgeshade::test {

bool OpenChainTally::isTelling() const {
    const auto& bySingleEdge = open[static_cast<std::size_t>(ChainMethod::singleEdge)];
    for (std::size_t kind = 0; kind < kinds; ++kind) {
        const auto light = static_cast<LightKind>(kind);
        const bool anywhere = light == LightKind::pointAnywhere || light == LightKind::sunAnywhere;
        if (anywhere && 10 * casting[kind] < 9 * pairs[kind]) return false;
        if (!anywhere && 10 * bySingleEdge[kind] < pairs[kind]) return false;
    }
    return true;
}

void reportOpenChains(const OpenChainTally& tally) {
    constexpr std::array<const char*, chainMethodCount> methods = {"reference edge", "three edge",
                                                                   "single edge"};
    const char* arithmetic = tally.fused ? ", fused multiply-adds" : "";
    for (std::size_t method = 0; method < methods.size(); ++method)
        for (std::size_t kind = 0; kind < lightKindCount; ++kind) {
            const std::uint64_t open = tally.open[method][kind];
            const std::string what =
                std::string(methods[method]) + ", " + std::string(lightKindNames[kind]);
            std::cout << "[ closed chain ] " << what << arithmetic << ": " << open << " of "
                      << tally.pairs[kind] << " open\n";
            testing::Test::RecordProperty("open: " + what, std::to_string(open));
        }
}

} // namespace edgeshade::test
