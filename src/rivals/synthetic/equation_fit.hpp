#pragma once

#include <array>
#include <span>

namespace edgeshade::bench {

/// A measured time of evaluating edges.
struct EvaluationTime {
    double edges = 0.0; ///< in thousands
    double multiplicity = 0.0;
    double milliseconds = 0.0; ///< above 0
};

/// The thesis' Equation 6.10, for e thousand edges of multiplicity m: (k0 m^2 + k2 m + k4) e + (k1
/// m^2 + k3 m + k5) milliseconds.
struct EquationFit {
    std::array<double, 6> k{};
    double mwsePercent = 0.0; ///< mean error relative to the measured times

    double at(double edges, double multiplicity) const;
};

/// Fits the coefficients by least squares of relative errors. Needs times for all combinations of
/// at least two numbers of edges and three multiplicities.
EquationFit fitEquation(std::span<const EvaluationTime> times);

} // namespace edgeshade::bench
