#pragma once

#include "src/scene/load.hpp"
#include "src/shadow/view/frame_view.hpp"

#include <span>

namespace edgeshade {

/// A view whose picture is the sum of the lit masks of directional lights; everything else is as in
/// `seen`. `directions`: towards the lights, at most mostSummed. BLEND surfaces are left out, as
/// they take no part in shadows.
FrameView directionMasks(const FrameView& seen, const LoadedScene& loaded,
                         std::span<const glm::dvec3> directions);

} // namespace edgeshade
