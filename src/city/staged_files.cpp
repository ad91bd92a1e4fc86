#include "src/city/staged_files.hpp"

#include "preprocess/base/error.hpp"

#include <cstdio>
#include <random>
#include <ranges>

namespace edgeshade::city {
namespace {

namespace fs = std::filesystem;

constexpr const char* filesName = "files";

[[noreturn]] void fail(const fs::path& path, const std::error_code& error) {
    throw Error(ExitStatus::output,
                "'" + path.string() + "' can't be written: " + error.message() + ".");
}

/// A name that is unique among all processes, also on other machines that share the folder.
std::string uniqueName() {
    std::random_device random;
    char name[40];
    std::snprintf(name, sizeof name, ".edgeshade-%08x%08x.part", random(), random());
    return name;
}

void makeFolders(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    if (error) fail(path, error);
}

} // namespace

StagedFiles::StagedFiles(const fs::path& folder)
    : folder_(folder), staging_(folder / uniqueName()) {
    makeFolders(staging_ / filesName);
}

StagedFiles::~StagedFiles() {
    std::error_code error;
    fs::remove_all(staging_, error);
}

fs::path StagedFiles::add(const fs::path& name) {
    const fs::path path = staging_ / filesName / name;
    makeFolders(path.parent_path());
    names_.push_back(name);
    return path;
}

void StagedFiles::commit() {
    for (const fs::path& name : names_ | std::views::reverse) {
        makeFolders((folder_ / name).parent_path());
        std::error_code error;
        fs::rename(staging_ / filesName / name, folder_ / name, error);
        if (error) fail(folder_ / name, error);
    }
}

} // namespace edgeshade::city
