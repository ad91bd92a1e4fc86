#pragma once

#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// Outlines of the section's planes in the scene's bounds, and their handles: a disc that lies in
/// the plane, and an arrow along its normal towards the part that stays.
OverlayTriangles sectionTriangles(const ViewState& state, const Stage& stage);

} // namespace edgeshade::viewer
