#include "src/city/json_text.hpp"

#include "preprocess/base/error.hpp"

namespace edgeshade::city {

nlohmann::ordered_json jsonFrom(std::string_view text, const std::string& where) {
    try {
        return nlohmann::ordered_json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        const std::string message = clauseOf(error.what()); // "[json.exception. ...] text"
        const std::size_t start = message.find("] ");
        throw InputError(where + ": " + message.substr(start == std::string::npos ? 0 : start + 2) +
                         ".");
    }
}

} // namespace edgeshade::city
