#pragma once

#include <string>
#include <vector>

namespace edgeshade::cli {

/// The family of a setting's shadows, for people: "volumes", "maps, vsm", "cascades". `text`: the
/// setting as `--against` takes it. The family comes from the words of the text, so a new kind of
/// map, filter or method gets its own family.
std::string familyOf(const std::string& text);

/// The families of these settings and the built-in ones, each once, in an order that does not
/// depend on the settings.
std::vector<std::string> familiesOf(const std::vector<std::string>& texts);

} // namespace edgeshade::cli
