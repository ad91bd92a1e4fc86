#pragma once

#include "preprocess/gltf/json_field.hpp"
#include "src/hours/preset.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace edgeshade::hours {

/// What of a run's settings pictures and reports are made by.
struct HoursSettings {
    std::string file;              ///< the scene's, without folders
    std::string from, to;          ///< dates
    std::size_t days = 1;          ///< 1 to 100,000
    std::chrono::minutes step{10}; ///< 1 to 1440
    std::chrono::minutes offset{0};
    double latitude = 0.0, longitude = 0.0;
    std::optional<double> threshold; ///< hours a day, 0 or more
    const Preset* preset = nullptr;  ///< null: none
};

/// Out of a run's settings as JSON. Throws InputError where one is missing or can't be.
HoursSettings hoursSettings(const JsonField& settings);

} // namespace edgeshade::hours
