#pragma once

#include <string>
#include <vector>

namespace edgeshade::plot {

/// A logarithmic axis between two values above 0.
class LogAxis {
  public:
    /// `from`, `to`: where its ends are in pixels.
    LogAxis(double least, double most, double from, double to);

    double at(double value) const;

    /// Powers of ten, and where there are few of them their doubles and fivefolds too.
    std::vector<double> ticks() const;

  private:
    double least_, most_; ///< logarithms
    double from_, to_;
};

/// 0.0001, 0.05, 20, 3000.
std::string tickLabel(double value);

} // namespace edgeshade::plot
