#pragma once

#include <filesystem>
#include <fstream>
#include <string_view>
#include <vector>

namespace edgeshade::city {

/// Texts of sources that become known in any order, kept in a file and not in memory.
class TextBySource {
  public:
    /// `path`: of a new file. Throws Error(output) naming it.
    TextBySource(const std::filesystem::path& path, std::size_t sources);

    void add(std::size_t source, std::string_view text);
    /// Writes a file: the header, then the texts by source. Throws Error(output).
    void write(const std::filesystem::path& path, std::string_view header);

  private:
    struct Place {
        std::streamoff begin = 0;
        std::size_t size = 0;
    };

    std::filesystem::path path_;
    std::fstream file_;
    std::vector<Place> places_;
};

} // namespace edgeshade::city
