#pragma once

#include "src/shadow/plan/frame_plan.hpp"

#include <string>

namespace edgeshade {

/// A frame's plan in words: for every light, group of casters and slice what is drawn, how, and
/// why, and what is left out; a line for each range of clusters that are treated alike. Of adapted
/// records.
std::string explain(const FramePlan& plan, const FrameView& view);

} // namespace edgeshade
