#pragma once

#include <string>

namespace edgeshade::test {

/// Expects `text` between the lines that contain "<section>: begin" and "<section>: end" in a file
/// of the repository. With EDGESHADE_UPDATE_DOCS in the environment it writes it there instead.
void expectGenerated(const std::string& file, const std::string& section, const std::string& text);

} // namespace edgeshade::test
