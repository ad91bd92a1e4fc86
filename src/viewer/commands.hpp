#pragma once

#include "src/viewer/input.hpp"
#include "src/viewer/stage.hpp"
#include "src/viewer/view_state.hpp"

namespace edgeshade::viewer {

/// The state after a command. Lights and settings at the end of their range stay there.
ViewState after(Command command, const ViewState& state, const Stage& stage);

/// A view of the whole scene from slightly above, with the file's lights or one sun; settings stay.
ViewState framed(const ViewState& state, const Stage& stage);

} // namespace edgeshade::viewer
