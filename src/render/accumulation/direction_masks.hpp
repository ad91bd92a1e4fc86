#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <span>

namespace edgeshade {

/// A view whose picture is the sum of the lit masks of directional lights, towards which these
/// point, at most mostSummed; else as `seen`. BLEND surfaces, which take no part in shadows, are
/// left out.
FrameView directionMasks(const FrameView& seen, const LoadedScene& loaded,
                         std::span<const glm::dvec3> directions);

} // namespace edgeshade
