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

/// The thesis' Equation 6.10, with e edges in thousands of multiplicity m:
/// (k0 m^2 + k2 m + k4) e + (k1 m^2 + k3 m + k5) milliseconds.
struct EquationFit {
    std::array<double, 6> k{};
    double mwsePercent = 0.0; ///< mean of the errors, each relative to its measured time

    double at(double edges, double multiplicity) const;
};

/// The coefficients by least squares of relative errors. Needs times of at least two numbers of
/// edges and three multiplicities, each with each.
EquationFit fitEquation(std::span<const EvaluationTime> times);

} // namespace edgeshade::bench
