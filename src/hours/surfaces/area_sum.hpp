#pragma once

#include <algorithm>

namespace edgeshade::hours {

/// Least, mean and largest of a value, weighted by area. Sums in the order of add().
class AreaSum {
  public:
    void add(double area, double value) {
        least_ = count_ == 0 ? value : std::min(least_, value);
        most_ = count_ == 0 ? value : std::max(most_, value);
        area_ += area;
        sum_ += area * value;
        ++count_;
    }
    std::size_t count() const { return count_; }
    double area() const { return area_; }
    double least() const { return least_; } ///< 0 without values
    double most() const { return most_; }   ///< 0 without values
    double sum() const { return sum_; }     ///< of area times value
    double mean() const { return area_ > 0.0 ? sum_ / area_ : 0.0; }

  private:
    std::size_t count_ = 0;
    double area_ = 0.0, least_ = 0.0, most_ = 0.0, sum_ = 0.0;
};

} // namespace edgeshade::hours
