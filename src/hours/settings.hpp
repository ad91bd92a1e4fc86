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

/// read(the field's text), a reader of src/sun/; its failure becomes the field's.
template <class Read>
auto readAs(const JsonField& field, Read read) {
    const std::string text = field.text();
    try {
        return read(text);
    } catch (const Error& error) {
        field.fail(std::string(" is invalid: ") + error.what());
    }
}

/// Reads a run's settings from JSON. Throws InputError if one is missing or invalid.
HoursSettings hoursSettings(const JsonField& settings);

} // namespace edgeshade::hours
