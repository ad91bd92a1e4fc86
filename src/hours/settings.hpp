#pragma once

#include "preprocess/gltf/json_field.hpp"
#include "src/hours/preset.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace edgeshade::hours {

/// The settings of a run that pictures and reports need.
struct HoursSettings {
    std::string file;              ///< the scene's name, without folders
    std::string from, to;          ///< dates
    std::size_t days = 1;          ///< 1 to 100,000
    std::chrono::minutes step{10}; ///< 1 to 1440
    std::chrono::minutes offset{0};
    double latitude = 0.0, longitude = 0.0;
    std::optional<double> threshold; ///< hours per day, 0 or more
    const Preset* preset = nullptr;  ///< null: none
};

/// Reads a run's settings from JSON. Throws InputError if one is missing or invalid.
HoursSettings hoursSettings(const JsonField& settings);

} // namespace edgeshade::hours
