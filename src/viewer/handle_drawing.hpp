#pragma once

#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// The lights' handles: a disc for a point light, one with rays for a sun, a ring around the chosen
/// one. A sun hangs on a line from the scene's middle, a point light stands on one to its floor.
OverlayTriangles handleTriangles(const ViewState& state, const Stage& stage);

/// The line between the sides of a split.
OverlayTriangles splitTriangles(const ViewState& state, const Stage& stage);

} // namespace edgeshade::viewer
