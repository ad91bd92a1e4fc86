#include "src/cli/number_text.hpp"

#include <charconv>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <iomanip>
#include <sstream>

namespace edgeshade::cli {

double numberFrom(std::string_view text, const std::string& option) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0.0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() ||
        !std::isfinite(value))
        throw CLI::ValidationError(option, "'" + std::string(text) + "' is not a finite number");
    return value;
}

std::string shortText(double value) {
    std::ostringstream text;
    text << std::setprecision(12) << value;
    return text.str();
}

glm::dvec3 vectorFrom(const std::string& text, const std::string& option) {
    return glm::make_vec3(numbersFrom<3>(text, option, "of the form x,y,z").data());
}

} // namespace edgeshade::cli
