#pragma once

#include "src/shadow/plan/frame_plan.hpp"

#include <string>

namespace edgeshade {

/// Describes a frame's plan in words. For every light, group of casters and slice it says what is
/// drawn, how and why, and what is left out, in one line per range of clusters that share a plan.
/// `view` is the frame's, or differs from it in its lights alone: the plan has their places.
/// Covers adapted records only.
std::string explain(const FramePlan& plan, const FrameView& view);

} // namespace edgeshade
