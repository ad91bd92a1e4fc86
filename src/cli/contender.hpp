#pragma once

#include "src/cli/draw_settings.hpp"
#include "src/lab/compare.hpp"

namespace edgeshade::cli {

/// How settings are compared with the oracle: a map's bias is tuned unless it was typed.
lab::Contender contenderOf(const std::string& name, const DrawSettings& settings);

} // namespace edgeshade::cli
