#pragma once

#include "preprocess/scene/section.hpp"

#include <optional>
#include <string>

namespace edgeshade {

/// Whether a section can have the plane: it has a direction, and numbers that are finite.
bool isSectionPlane(const glm::dvec4& plane);

/// Six planes that keep a box.
std::vector<glm::dvec4> sectionBox(const glm::dvec3& low, const glm::dvec3& high);

/// A fill from "none" or "#rrggbb"; null: the text is neither.
std::optional<std::optional<glm::vec3>> fillFromText(const std::string& text);

/// "none" or "#rrggbb".
std::string textOfFill(const std::optional<glm::vec3>& fill);

} // namespace edgeshade
