#pragma once

#include "src/viewer/viewer.hpp"

#include <string>

namespace edgeshade::desktop {

/// What a typed character does, on any keyboard layout.
std::optional<viewer::Command> commandForCharacter(unsigned character);

/// What a GLFW key with GLFW modifiers does that types no character.
std::optional<viewer::Command> commandForKey(int key, int modifiers);

/// All keys, a tab, and what they do, a line each.
std::string helpText();

} // namespace edgeshade::desktop
