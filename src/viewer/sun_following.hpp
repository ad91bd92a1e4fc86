#pragma once

#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// The next state with its sun by place and time, if it has one, as its first light: where `before`
/// had none, a sun that is first already becomes it, else one is put before the others. Who moves
/// that light, or removes it, takes it from there: it is no sun by place and time any more.
ViewState withSun(const ViewState& before, ViewState next);

/// Whether the first light is a sun that is below the horizon and lights nothing.
bool sunIsDown(const ViewState& state);

} // namespace edgeshade::viewer
