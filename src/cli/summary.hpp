#pragma once

#include "preprocess/packing/pack.hpp"

#include <string>

namespace edgeshade::cli {

/// The report's figures in a few lines for people.
std::string summaryOf(const PackReport& report);

/// The scene's variants, cameras and lights, one per line, each after a newline.
std::string choicesOf(const PackReport& report);

} // namespace edgeshade::cli
