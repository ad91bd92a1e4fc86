// The extremes: each case is drawn in code, names the difficulty it provokes, and is checked
// against the oracle and for the closed chain (docs/method.md, C1, C30 and C32).

#include "tests/lab/extreme_check.hpp"

#include <gtest/gtest.h>
#include <iostream>

namespace edgeshade::test {
namespace {

constexpr std::size_t mostWrongBeyond1px = 0;

std::vector<Extreme> extremes(bool long_) {
    std::vector<Extreme> all;
    for (const auto& theme :
         {placeExtremes(), lightExtremes(), viewExtremes(), shapeExtremes(), amountExtremes()})
        for (const Extreme& extreme : theme)
            if (extreme.takesLong == long_) all.push_back(extreme);
    return all;
}

/// Letters and digits only: "1e-6" becomes 1eMinus6.
std::string nameOf(const testing::TestParamInfo<Extreme>& extreme) {
    std::string name;
    char last = ' ';
    for (const char c : extreme.param.name) {
        const bool sign = c == '-' && last == 'e';
        if (std::isalnum(static_cast<unsigned char>(c))) name += c;
        if (sign) name += "Minus";
        last = c;
    }
    return name;
}

} // namespace

void PrintTo(const Extreme& extreme, std::ostream* out) {
    *out << extreme.name;
}

class Extremes : public testing::TestWithParam<Extreme> {
  protected:
    static void SetUpTestSuite() { std::cout << tableHead() << std::endl; }
};

TEST_P(Extremes, AreRight) {
    const Extreme& extreme = GetParam();
    const ExtremeOutcome outcome = check(extreme);
    std::cout << tableRows(extreme, outcome) << std::endl;
    EXPECT_GE(outcome.triangles, extreme.leastTriangles);
    for (const auto& [name, counts] : outcome.ways) {
        SCOPED_TRACE(name);
        EXPECT_LE(counts.beyond1pxNotTied, mostWrongBeyond1px);
        EXPECT_LE(100.0 * static_cast<double>(counts.wrongImagePixels),
                  extreme.mostWrongPercent * static_cast<double>(counts.visiblePixels));
    }
    EXPECT_EQ(outcome.openEdges, 0u);
}

INSTANTIATE_TEST_SUITE_P(All, Extremes, testing::ValuesIn(extremes(false)), nameOf);
INSTANTIATE_TEST_SUITE_P(Long, Extremes, testing::ValuesIn(extremes(true)), nameOf);

} // namespace edgeshade::test
