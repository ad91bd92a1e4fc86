#pragma once

#include <filesystem>
#include <string>

namespace edgeshade::cli {

/// The folder of a plan's results: the typed one, or PLAN.jobs beside the plan.
inline std::filesystem::path cityResultsOf(const std::string& plan, const std::string& typed) {
    return typed.empty() ? plan + ".jobs" : typed;
}

} // namespace edgeshade::cli
