#pragma once

#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// The next state, with its sun by place and time, if any, as the first light. If `before` had
/// none, a directional light that is already first becomes the sun; otherwise the sun is inserted
/// before the other lights. Moving or removing that light ends the sun by place and time.
ViewState withSun(const ViewState& before, ViewState next);

/// Whether the first light is a sun below the horizon, which lights nothing.
bool sunIsDown(const ViewState& state);

} // namespace edgeshade::viewer
