#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace edgeshade::city {

/// Parses JSON. Throws InputError: `where`, which begins the sentence, then the reason.
nlohmann::ordered_json jsonFrom(std::string_view text, const std::string& where);

} // namespace edgeshade::city
