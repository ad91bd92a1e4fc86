#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>

namespace edgeshade {

/// Parses "#rrggbb" in sRGB to a linear colour; null for other text.
std::optional<glm::vec3> linearFromText(const std::string& text);

/// The text of a linear colour, as linearFromText() reads it.
std::string textFromLinear(const glm::vec3& color);

} // namespace edgeshade
