#pragma once

#include <filesystem>
#include <vector>

namespace edgeshade::city {

/// Files that appear in a folder together, when all of them are complete. Until then they are in a
/// folder of their own inside it, .edgeshade-….part, which the destructor removes.
class StagedFiles {
  public:
    /// Makes `folder` if it is missing. Throws Error(output) naming it.
    explicit StagedFiles(const std::filesystem::path& folder);
    ~StagedFiles();
    StagedFiles(const StagedFiles&) = delete;
    StagedFiles& operator=(const StagedFiles&) = delete;

    /// Where to write a file that will be `name`, which may have folders, in the folder.
    std::filesystem::path add(const std::filesystem::path& name);
    /// Where to write a file that goes with this.
    std::filesystem::path scratch(const std::string& name) const { return staging_ / name; }
    /// Moves all added files over those of the same names; the first comes last, so that who waits
    /// for it finds the others. Throws Error(output) naming a file that can't be replaced.
    void commit();

  private:
    std::filesystem::path folder_, staging_;
    std::vector<std::filesystem::path> names_;
};

} // namespace edgeshade::city
