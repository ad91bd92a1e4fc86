#pragma once

#include "preprocess/scene/ground.hpp"

#include <optional>
#include <string>

namespace edgeshade {

/// The ground a user chose: none, a coloured one, or a catcher of shadow.
using GroundChoice = std::optional<Ground>;

/// Parses "off", "catcher" or "#rrggbb"; null for other text.
std::optional<GroundChoice> groundFromText(const std::string& text);

/// The text of a ground, as groundFromText() reads it.
std::string textOf(const GroundChoice& ground);

} // namespace edgeshade
