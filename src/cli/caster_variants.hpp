#pragma once

#include "src/cli/options.hpp"

#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

namespace edgeshade::cli {

/// Variants of a call's scene with other casters, as the compared settings require. Settings with
/// the same casters share a variant.
class CasterVariants {
  public:
    /// `own`, read from `path`, must outlive this.
    CasterVariants(std::filesystem::path path, const LoadedScene& own)
        : path_(std::move(path)), own_(own) {}

    /// Returns null if nothing changes. Throws InputError.
    std::shared_ptr<const LoadedScene> with(const CasterChanges& changes);

    /// The call's caster settings with those changes; chooses a weld tolerance of 'auto' once.
    /// Throws InputError.
    CasterSettings settingsWith(const CasterChanges& changes);

  private:
    std::filesystem::path path_;
    const LoadedScene& own_;
    std::vector<std::shared_ptr<const LoadedScene>> others_;
    std::vector<std::pair<CasterSettings, CasterSettings>>
        chosen_; ///< as requested, and with the tolerance chosen
};

/// The settings as report keys, named like the options.
nlohmann::ordered_json casterJson(const CasterSettings& settings);

} // namespace edgeshade::cli
