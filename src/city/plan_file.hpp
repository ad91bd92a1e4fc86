#pragma once

#include "src/city/plan.hpp"

namespace edgeshade::city {

/// A plan as JSON text, with its folder as it is: one that isn't absolute is relative to the plan's
/// own.
std::string textOf(const Plan& plan);

/// A plan with the hash of its file, which results repeat.
struct ReadPlan {
    Plan plan;
    std::string hash;
};

/// Throws InputError naming the field.
ReadPlan planFrom(const std::filesystem::path& path);

} // namespace edgeshade::city
