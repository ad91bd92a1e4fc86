// Ten million triangles with one light each: sides and caps must be consistent; exactness is not
// needed (docs/method.md, The closed chain).
#include "open_chain_tally.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

TEST(ClosedChainInBulk, OnlyTheSingleEdgeOpensIt) {
    const OpenChainTally tally = tallyOpenChains(tallyPairs, 2020);
    reportOpenChains(tally);
    EXPECT_FALSE(tally.fused);
    EXPECT_TRUE(tally.isTelling());
    EXPECT_EQ(tally.openOf(ChainMethod::referenceEdge), 0u);
    EXPECT_EQ(tally.openOf(ChainMethod::threeEdge), 0u);
    EXPECT_GT(tally.openOf(ChainMethod::singleEdge), 0u);
}

} // namespace
} // namespace edgeshade::test
