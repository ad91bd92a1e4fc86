#pragma once

#include <string>
#include <vector>

namespace edgeshade::plot {

/// A logarithmic axis between two values above 0.
class LogAxis {
  public:
    /// `from`, `to`: pixels of the axis' ends.
    LogAxis(double least, double most, double from, double to);

    double at(double value) const;

    /// Powers of ten; if there are few, also 2 and 5 times them.
    std::vector<double> ticks() const;

  private:
    double least_, most_; ///< stored as logarithms
    double from_, to_;
};

/// Labels such as 0.0001, 0.05, 20, 3000.
std::string tickLabel(double value);

} // namespace edgeshade::plot
