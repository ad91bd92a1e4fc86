#include "src/rivals/synthetic/equation_fit.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::bench {
namespace {

constexpr std::size_t terms = 6;
using Row = std::array<double, terms + 1>; ///< the last entry is the right-hand side

/// The factors of k0..k5.
std::array<double, terms> termsOf(double e, double m) {
    return {m * m * e, m * m, m * e, m, e, 1.0};
}

/// Solves by Gaussian elimination with partial pivoting.
std::array<double, terms> solved(std::array<Row, terms> rows) {
    for (std::size_t c = 0; c < terms; ++c) {
        const auto pivot =
            std::max_element(rows.begin() + c, rows.end(), [&](const Row& a, const Row& b) {
                return std::abs(a[c]) < std::abs(b[c]);
            });
        std::swap(rows[c], *pivot);
        for (std::size_t r = 0; r < terms; ++r) {
            if (r == c) continue;
            const double factor = rows[r][c] / rows[c][c];
            for (std::size_t i = c; i <= terms; ++i)
                rows[r][i] -= factor * rows[c][i];
        }
    }
    std::array<double, terms> solution{};
    for (std::size_t c = 0; c < terms; ++c)
        solution[c] = rows[c][terms] / rows[c][c];
    return solution;
}

} // namespace

double EquationFit::at(double edges, double multiplicity) const {
    const auto factors = termsOf(edges, multiplicity);
    double sum = 0.0;
    for (std::size_t i = 0; i < terms; ++i)
        sum += k[i] * factors[i];
    return sum;
}

EquationFit fitEquation(std::span<const EvaluationTime> times) {
    // Normal equations of the terms divided by the time; scaled, as e is far larger than 1.
    std::array<double, terms> scale{};
    for (const EvaluationTime& time : times) {
        const auto factors = termsOf(time.edges, time.multiplicity);
        for (std::size_t i = 0; i < terms; ++i)
            scale[i] = std::max(scale[i], factors[i] / time.milliseconds);
    }
    std::array<Row, terms> rows{};
    for (const EvaluationTime& time : times) {
        auto factors = termsOf(time.edges, time.multiplicity);
        for (std::size_t i = 0; i < terms; ++i)
            factors[i] /= time.milliseconds * scale[i];
        for (std::size_t r = 0; r < terms; ++r) {
            for (std::size_t c = 0; c < terms; ++c)
                rows[r][c] += factors[r] * factors[c];
            rows[r][terms] += factors[r];
        }
    }
    EquationFit fit;
    fit.k = solved(rows);
    for (std::size_t i = 0; i < terms; ++i)
        fit.k[i] /= scale[i];
    for (const EvaluationTime& time : times)
        fit.mwsePercent +=
            100.0 * std::abs(fit.at(time.edges, time.multiplicity) / time.milliseconds - 1.0) /
            static_cast<double>(times.size());
    return fit;
}

} // namespace edgeshade::bench
