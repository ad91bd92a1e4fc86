#pragma once

#include "preprocess/packing/pack.hpp"

#include <string>

namespace edgeshade::cli {

/// The report's figures in a few lines for people.
std::string summaryOf(const PackReport& report);

/// What of the scene can be chosen, a line each, every one after a newline: variants and cameras;
/// and the lights.
std::string choicesOf(const PackReport& report);

} // namespace edgeshade::cli
