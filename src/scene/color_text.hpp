#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace edgeshade {

/// "#rrggbb", sRGB, as a linear colour; nothing where it is no such text.
std::optional<glm::vec3> linearFromText(const std::string& text);

/// The other way round.
std::string textFromLinear(const glm::vec3& color);

} // namespace edgeshade
