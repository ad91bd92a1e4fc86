#pragma once

#include "preprocess/scene/section.hpp"
#include "src/viewer/state_field.hpp"

namespace edgeshade::viewer {

/// The colour of cut faces unless another is given, linear; `--section-fill` has the same default.
glm::vec3 defaultFill();

/// null, or {"planes": [[x, y, z, d], ...], "shadows": "cut", "fill": "#cc5540"}: 1 to 12 planes,
/// and defaults for the rest. Throws Error(usage) that names the field and its value.
std::optional<Section> sectionFrom(const Field& field);

/// The same JSON.
nlohmann::ordered_json toJson(const std::optional<Section>& section);

} // namespace edgeshade::viewer
