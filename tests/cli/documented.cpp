#include "tests/cli/documented.hpp"

#include "preprocess/base/file_io.hpp"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

namespace edgeshade::test {
namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

void expectDocumented(const std::string& section, const std::vector<std::string>& rows,
                      const std::string& page) {
    const std::string path = EDGESHADE_DOCS "/" + page;
    const Bytes bytes = readFile(path);
    const std::string text(bytes.begin(), bytes.end());
    const std::string begin = "<!-- " + section + ": begin -->\n";
    const std::size_t marker = text.find(begin);
    const std::size_t end = text.find("<!-- " + section + ": end -->");
    ASSERT_TRUE(marker < end && end != std::string::npos)
        << path << " lacks the section " << section;
    // Keeps the table's first two lines.
    std::size_t start = marker + begin.size();
    for (int line = 0; line < 2; ++line)
        start = text.find('\n', start) + 1;
    if (std::getenv("EDGESHADE_UPDATE_DOCS")) {
        std::string joined;
        for (const std::string& row : rows)
            joined += row + "\n";
        writeFile(path, std::string_view(text.substr(0, start) + joined + text.substr(end)));
        return;
    }
    const std::vector<std::string> documented = linesOf(text.substr(start, end - start));
    EXPECT_EQ(documented, rows) << "EDGESHADE_UPDATE_DOCS=1 in the environment writes them again";
}

std::string withoutFolder(std::string text, const std::string& folder) {
    for (std::size_t at; (at = text.find(folder)) != std::string::npos;)
        text.erase(at, folder.size() + (text[at + folder.size()] == '/'));
    return text;
}

std::string cellOf(std::string text) {
    constexpr std::size_t longest = 200;
    if (text.size() > longest) text = text.substr(0, longest) + "…";
    std::string cell;
    for (const char c : text) {
        if (c == '|' || c == '*' || c == '_' || c == '<' || c == '`') cell += '\\';
        cell += c == '\n' ? ' ' : c;
    }
    return cell;
}

} // namespace edgeshade::test
