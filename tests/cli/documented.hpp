#pragma once

#include <string>
#include <vector>

namespace edgeshade::test {

/// Expects that the page of docs/ has exactly these table rows between the comments "<section>:
/// begin" and "<section>: end". With EDGESHADE_UPDATE_DOCS in the environment it writes them there
/// instead.
void expectDocumented(const std::string& section, const std::vector<std::string>& rows,
                      const std::string& page = "bad-inputs.md");

/// `text` without the path of a folder that differs each time.
std::string withoutFolder(std::string text, const std::string& folder);

/// A cell of a table: on one line, of readable length, without text that Markdown would take for
/// markup.
std::string cellOf(std::string text);

} // namespace edgeshade::test
