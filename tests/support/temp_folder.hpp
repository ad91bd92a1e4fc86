#pragma once

#include "preprocess/base/file_io.hpp"

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace edgeshade::test {

/// A new folder that is deleted with all its contents.
class TempFolder {
  public:
    TempFolder();
    ~TempFolder();
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

    /// Writes a file into the folder and returns its path.
    std::filesystem::path write(const std::string& name, const Bytes& bytes) const;
    std::filesystem::path write(const std::string& name, std::string_view text) const;

    /// Names of the folder's entries, sorted.
    std::vector<std::string> names() const;

    /// Number of them that a write left unfinished.
    std::size_t partialFiles() const;

  private:
    std::filesystem::path path_;
};

} // namespace edgeshade::test
