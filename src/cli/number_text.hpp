#pragma once

#include <array>
#include <CLI/CLI.hpp>
#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <string_view>

namespace edgeshade::cli {

/// Parses the whole text as a finite number. These functions throw CLI::ValidationError that names
/// the option.
double numberFrom(std::string_view text, const std::string& option);

/// Parses `count` finite numbers with commas in between. `form` describes the expected text.
template <std::size_t count>
std::array<double, count> numbersFrom(const std::string& text, const std::string& option,
                                      const std::string& form) {
    std::array<double, count> numbers;
    std::size_t start = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t comma = text.find(',', start);
        if ((comma == std::string::npos) != (i + 1 == count))
            throw CLI::ValidationError(option, "'" + text + "' is not " + form);
        numbers[i] = numberFrom(std::string_view(text).substr(start, comma - start), option);
        start = comma + 1;
    }
    return numbers;
}

/// 12 digits at the most: 0.5, 134217728.
std::string shortText(double value);

/// "x,y,z".
glm::dvec3 vectorFrom(const std::string& text, const std::string& option);

} // namespace edgeshade::cli
