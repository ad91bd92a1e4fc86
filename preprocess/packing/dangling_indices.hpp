#pragma once

#include <nlohmann/json.hpp>

namespace edgeshade {

/// Erases indices of views and accessors that don't exist. Images and animations may have them, and
/// drawing leaves these out with a warning, as it does without an index. Such an index would refer
/// to the next view or accessor that is added. Returns whether there were any.
bool eraseDanglingIndices(nlohmann::ordered_json& json);

} // namespace edgeshade
