// The same with fused multiply-adds, since a device may contract expressions that GLSL spells out.
// One shared source must hold even then.
#include "open_chain_tally.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

TEST(ClosedChainInBulk, HoldsWithFusedMultiplyAdds) {
    if (!__builtin_cpu_supports("fma")) GTEST_SKIP() << "this processor has no fused multiply-add";
    const OpenChainTally tally = tallyOpenChains(tallyPairs, 2020);
    reportOpenChains(tally);
    if (!tally.fused) GTEST_SKIP() << "this build does not contract (unoptimised)";
    EXPECT_TRUE(tally.isTelling());
    EXPECT_EQ(tally.openOf(ChainMethod::referenceEdge), 0u);
    EXPECT_EQ(tally.openOf(ChainMethod::threeEdge), 0u);
    EXPECT_GT(tally.openOf(ChainMethod::singleEdge), 0u);
}

} // namespace
} // namespace edgeshade::test
