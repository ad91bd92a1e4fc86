#include "src/hours/surfaces/surface_run.hpp"

namespace edgeshade::hours {
namespace {

/// Days from which tables have columns by month.
constexpr std::size_t daysOfYear = 365;

} // namespace

LightQuestion questionOf(const SurfaceRun& run, std::size_t days, std::span<const double> beam,
                         bool bits) {
    LightQuestion question;
    question.positions = run.positions;
    question.step = run.step;
    question.offset = run.offset;
    question.months = days >= daysOfYear;
    question.bits = bits || run.ofWindows;
    question.normalIrradiance = beam;
    return question;
}

} // namespace edgeshade::hours
