#include "src/hours/one_run.hpp"

#include "preprocess/base/error.hpp"

#include <optional>

namespace edgeshade::hours {

void OneRun::fail(const std::string& field, const std::string& value,
                  const std::string& firstValue) const {
    throw InputError("'" + path_ + "': " + field + " is " + value + ", but in '" + firstPath_ +
                     "' it is " + firstValue + "; these are not parts of one run.");
}

void OneRun::requireSame(const std::string& field, const nlohmann::ordered_json& value,
                         const nlohmann::ordered_json& firstValue) const {
    if (value == firstValue) return;
    if (value.is_object() && firstValue.is_object()) {
        for (const auto& [key, inner] : firstValue.items())
            requireSame(field + "." + key, value.value(key, nlohmann::ordered_json()), inner);
        for (const auto& [key, inner] : value.items())
            requireSame(field + "." + key, inner, firstValue.value(key, nlohmann::ordered_json()));
    }
    fail(field, value.dump(), firstValue.dump());
}

std::vector<std::size_t> partsInOrder(std::span<const NumberedFile> files, std::size_t of) {
    std::vector<std::optional<std::size_t>> byNumber(of);
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::optional<std::size_t>& place = byNumber[files[i].number - 1];
        if (place)
            throw InputError("'" + files[i].path + "': part is " + std::to_string(files[i].number) +
                             ", but '" + files[*place].path + "' already has that number.");
        place = i;
    }
    std::vector<std::size_t> order;
    for (const std::optional<std::size_t>& place : byNumber) {
        if (!place)
            throw InputError("'" + files.front().path + "': parts is " + std::to_string(of) +
                             ", but part " + std::to_string(order.size() + 1) + " is missing.");
        order.push_back(*place);
    }
    return order;
}

void requireLater(const Position& position, const std::vector<Position>& before,
                  const std::string& path, std::size_t index) {
    if (!before.empty() && position.time <= before.back().time)
        throw InputError("'" + path + "': positions[" + std::to_string(index) +
                         "].time is not later than the position before it in the run.");
}

} // namespace edgeshade::hours
