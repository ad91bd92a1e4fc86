#pragma once

#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// Handles of the lights: a disc for a point light, a disc with rays for a sun, a ring around the
/// chosen one. A line connects a sun to the scene's middle, and a point light to the scene's floor.
OverlayTriangles handleTriangles(const ViewState& state, const Stage& stage);

/// The line between the two sides of a split.
OverlayTriangles splitTriangles(const ViewState& state, const Stage& stage);

} // namespace edgeshade::viewer
