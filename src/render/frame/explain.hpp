#pragma once

#include "src/shadow/plan/light_plan.hpp"

#include <string>

namespace edgeshade {

/// A light's plan in words, a line for each range of clusters that are treated alike: what is drawn
/// of them, how, and why. `casters` must be those that it was made of.
std::string explain(const LightPlan& plan, const std::vector<PlacedShadow>& casters);

} // namespace edgeshade
