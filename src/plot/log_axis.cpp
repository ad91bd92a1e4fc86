#include "src/plot/log_axis.hpp"

#include <cmath>
#include <iomanip>
#include <sstream>

namespace edgeshade::plot {
namespace {

constexpr double fewDecades = 2.5;

} // namespace

LogAxis::LogAxis(double least, double most, double from, double to)
    : least_(std::log10(least)), most_(std::log10(most)), from_(from), to_(to) {}

double LogAxis::at(double value) const {
    return from_ + (to_ - from_) * (std::log10(value) - least_) / (most_ - least_);
}

std::vector<double> LogAxis::ticks() const {
    constexpr double rounding = 1e-9;
    std::vector<double> ticks;
    for (int power = static_cast<int>(std::floor(least_)); power <= most_ + rounding; ++power)
        for (const double factor : {1.0, 2.0, 5.0}) {
            if (factor > 1.0 && most_ - least_ > fewDecades) break;
            const double place = power + std::log10(factor);
            if (place >= least_ - rounding && place <= most_ + rounding)
                ticks.push_back(factor * std::pow(10.0, power));
        }
    return ticks;
}

std::string tickLabel(double value) {
    const int digits = std::max(0, -static_cast<int>(std::floor(std::log10(value) + 1e-9)));
    std::ostringstream text;
    text << std::fixed << std::setprecision(digits) << value;
    return text.str();
}

} // namespace edgeshade::plot
