#include "src/rivals/synthetic/equation_fit.hpp"

#include <gtest/gtest.h>
#include <vector>

namespace edgeshade::bench {
namespace {

std::vector<EvaluationTime> timesBy(const EquationFit& equation) {
    std::vector<EvaluationTime> times;
    for (int e = 10; e <= 90; e += 10)
        for (int m = 1; m <= 9; ++m)
            times.push_back({double(e), double(m), equation.at(e, m)});
    return times;
}

TEST(EquationFit, FindsCoefficientsAgain) {
    // Thesis, Table 6.6: GeForce GTX 980, Radeon R9 290X.
    for (const std::array<double, 6>& k : {std::array{8.437815e-4, 1.7681964e-3, 4.4036999e-3,
                                                      -1.19359553e-2, 8.84234e-4, 4.30166459e-2},
                                           std::array{4.229571e-4, 1.344101e-4, 1.7166787e-3,
                                                      1.7862163e-3, 1.4015652e-3, 3.33773652e-2}}) {
        const EquationFit fit = fitEquation(timesBy({k, 0.0}));
        for (std::size_t i = 0; i < k.size(); ++i)
            EXPECT_NEAR(fit.k[i], k[i], 1e-9) << "k" << i;
        EXPECT_NEAR(fit.mwsePercent, 0.0, 1e-6);
    }
}

TEST(EquationFit, SaysHowFarTimesAreFromTheEquation) {
    std::vector<EvaluationTime> times = timesBy({{1e-3, 1e-3, 5e-3, 1e-3, 1e-3, 4e-2}, 0.0});
    for (std::size_t i = 0; i < times.size(); ++i)
        times[i].milliseconds *= i % 2 == 0 ? 1.1 : 0.9;
    const double error = fitEquation(times).mwsePercent;
    EXPECT_GT(error, 8.0);
    EXPECT_LT(error, 12.0);
}

} // namespace
} // namespace edgeshade::bench
