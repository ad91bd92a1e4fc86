#pragma once

#include "src/viewer/viewer.hpp"

#include <string>

namespace edgeshade::desktop {

/// Command of a typed character, on any keyboard layout.
std::optional<viewer::Command> commandForCharacter(unsigned character);

/// Command of a GLFW key that types no character, with GLFW modifiers.
std::optional<viewer::Command> commandForKey(int key, int modifiers);

/// All keys and their effects: one line each, with a tab between key and effect.
std::string helpText();

} // namespace edgeshade::desktop
