#pragma once

#include "preprocess/scene/ground.hpp"

#include <optional>
#include <string>

namespace edgeshade {

/// The grounds that users ask for: none, or one of some colour, or one that catches shadow.
using GroundChoice = std::optional<Ground>;

/// What "off", "catcher" or "#rrggbb" means; nothing for other texts.
std::optional<GroundChoice> groundFromText(const std::string& text);

/// The other way round.
std::string textOf(const GroundChoice& ground);

} // namespace edgeshade
