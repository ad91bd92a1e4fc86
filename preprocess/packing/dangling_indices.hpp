#pragma once

#include <nlohmann/json.hpp>

namespace edgeshade {

/// Erases indices of views and accessors that name nothing. Pictures and animations may have them:
/// they are left out with a warning when they are drawn, with no index at all just as well. Where a
/// view or an accessor is added, such an index would name that. Returns whether there were any.
bool eraseDanglingIndices(nlohmann::ordered_json& json);

} // namespace edgeshade
