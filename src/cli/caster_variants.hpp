#pragma once

#include "src/cli/options.hpp"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

namespace edgeshade::cli {

/// A call's scene with other casters, as settings that it compares ask for. Settings that mean the
/// same casters share one.
class CasterVariants {
  public:
    /// `own`, read from `path`, must outlive this.
    CasterVariants(std::filesystem::path path, const LoadedScene& own)
        : path_(std::move(path)), own_(own) {}

    /// Null where nothing changes. Throws InputError.
    std::shared_ptr<const LoadedScene> with(const CasterChanges& changes);

    /// The call's settings with those changes; a weld tolerance of 'auto' is chosen once. Throws
    /// InputError.
    CasterSettings settingsWith(const CasterChanges& changes);

  private:
    std::filesystem::path path_;
    const LoadedScene& own_;
    std::vector<std::shared_ptr<const LoadedScene>> others_;
    std::vector<std::pair<CasterSettings, CasterSettings>>
        chosen_; ///< asked for, and with tolerance
};

/// The settings as report keys, by the options' names.
nlohmann::ordered_json casterJson(const CasterSettings& settings);

} // namespace edgeshade::cli
