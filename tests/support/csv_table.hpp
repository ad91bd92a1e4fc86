#pragma once

#include "preprocess/base/file_io.hpp"

#include <map>
#include <string>
#include <vector>

namespace edgeshade::test {

/// A table as text, by column.
using CsvTable = std::map<std::string, std::vector<std::string>>;

/// Splits CSV (RFC 4180) with a line of headings.
inline CsvTable csvTableOf(const std::string& csv) {
    std::vector<std::vector<std::string>> lines(1);
    lines[0].emplace_back();
    bool quoted = false;
    for (std::size_t i = 0; i < csv.size(); ++i) {
        std::string& field = lines.back().back();
        if (csv[i] == '"' && quoted && i + 1 < csv.size() && csv[i + 1] == '"')
            field += csv[++i];
        else if (csv[i] == '"')
            quoted = !quoted;
        else if (csv[i] == ',' && !quoted)
            lines.back().emplace_back();
        else if (csv[i] == '\n' && !quoted)
            lines.emplace_back(1);
        else
            field += csv[i];
    }
    lines.pop_back();
    CsvTable table;
    for (std::size_t l = 1; l < lines.size(); ++l)
        for (std::size_t c = 0; c < lines[0].size(); ++c)
            table[lines[0][c]].push_back(lines[l].at(c));
    return table;
}

/// The table of a file.
inline CsvTable readCsv(const std::string& path) {
    const Bytes bytes = readFile(path);
    return csvTableOf(std::string(bytes.begin(), bytes.end()));
}

} // namespace edgeshade::test
