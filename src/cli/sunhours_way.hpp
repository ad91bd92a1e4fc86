#pragma once

#include "src/cli/sunhours_options.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade::cli {

/// Whether a run counts by rays or by masks, and why.
struct SunHoursWay {
    bool byRays = false;
    std::string why; ///< for reports
};

/// The way that the options ask for. `automatic` creates a GL context to learn
/// whether the processor draws. Throws
/// Error(usage) for options that have no effect by rays, and for cutouts by masks.
SunHoursWay wayOf(const SunHoursOptions& options);

/// "rays" or "masks".
const char* nameOf(const SunHoursWay& way);

} // namespace edgeshade::cli
