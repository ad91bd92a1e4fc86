#pragma once

#include <string>
#include <vector>

namespace edgeshade::cli {

/// What kind of shadows a setting has, for people: "volumes", "maps, vsm", "cascades". `text`: the
/// setting as `--against` takes it. What it says decides, so that a kind of map, a filter or a
/// method that is new has a family of its own by its word.
std::string familyOf(const std::string& text);

/// The families of these settings and those that are always there, each once, in an order that
/// doesn't change as settings come and go.
std::vector<std::string> familiesOf(const std::vector<std::string>& texts);

} // namespace edgeshade::cli
