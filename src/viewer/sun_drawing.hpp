#pragma once

#include "src/viewer/overlay_pass.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/sun_day.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// The sun's path over the day on the sphere of its handle, with a dot at every full hour, and the
/// horizon with a needle pointing north.
OverlayTriangles sunTriangles(const SunDay& day, const ViewState& state, const Stage& stage);

} // namespace edgeshade::viewer
