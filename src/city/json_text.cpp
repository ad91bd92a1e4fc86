#include "src/city/json_text.hpp"

#include "preprocess/gltf/json_field.hpp"

namespace edgeshade::city {

nlohmann::ordered_json jsonFrom(std::string_view text, const std::string& where) {
    try {
        return nlohmann::ordered_json::parse(text);
    } catch (const nlohmann::json::exception& error) {
        throw InputError(where + ": " + reasonOf(error) + ".");
    }
}

} // namespace edgeshade::city
