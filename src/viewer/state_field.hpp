#pragma once

#include "preprocess/base/error.hpp"
#include "preprocess/scene/extremes.hpp"
#include "src/settings/domains.hpp"

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace edgeshade::viewer {

/// A value of the state with its name for messages.
class Field {
  public:
    using Json = nlohmann::ordered_json;

    Field(std::string name, const nlohmann::ordered_json& value)
        : name_(std::move(name)), value_(value) {}

    [[noreturn]] void fail(const std::string& wanted) const {
        throw Error(ExitStatus::usage, name_ + " is " + text() + ", but must be " + wanted + ".");
    }

    /// Calls read(key, Field) for every member; `read` returns false for an unknown key.
    template <class Read>
    void forEachMember(Read read) const {
        if (!value_.is_object()) fail("an object");
        for (const auto& [key, value] : value_.items()) {
            const Field member(memberName(key), value);
            if (!read(key, member))
                throw Error(ExitStatus::usage, "There is no '" + member.name_ +
                                                   "' in a view's state (its value is " +
                                                   member.text() + ").");
        }
    }

    std::optional<Field> member(const char* key) const {
        if (!value_.is_object()) fail("an object");
        const auto found = value_.find(key);
        if (found == value_.end()) return std::nullopt;
        return Field(memberName(key), *found);
    }

    /// Refuses members of other keys.
    void requireMembersAmong(const std::vector<std::string_view>& keys) const {
        forEachMember([&](const std::string& key, const Field&) {
            return std::find(keys.begin(), keys.end(), key) != keys.end();
        });
    }

    /// Calls read(Field) for every item.
    template <class Read>
    void forEachItem(Read read) const {
        for (std::size_t i = 0; i < value_.size(); ++i)
            read(Field(name_ + "[" + std::to_string(i) + "]", value_[i]));
    }

    std::size_t arraySize() const { return value_.is_array() ? value_.size() : 0; }

    bool isNull() const { return value_.is_null(); }

    bool isObject() const { return value_.is_object(); }

    double number(double low, double high) const {
        const double number = value_.is_number() ? value_.get<double>() : NAN;
        if (!(number >= low && number <= high)) // false for NaN too
            fail("a number from " + Json(low).dump() + " to " + Json(high).dump());
        return number;
    }

    int integer(int low, int high) const {
        const double asNumber = number(low, high);
        if (asNumber != std::floor(asNumber)) fail("a whole number");
        return static_cast<int>(asNumber);
    }

    bool boolean() const {
        if (!value_.is_boolean()) fail("true or false");
        return value_.get<bool>();
    }

    std::string word() const {
        if (!value_.is_string()) fail("a string");
        return value_.get<std::string>();
    }

    /// A value of a setting (src/settings/domains.hpp). Words for integers are read as these.
    template <class Domain>
    auto in(const Domain& domain) const {
        if constexpr (requires { domain.all; })
            return oneOf(domain.all, [](int number) { return Json(number); });
        else if constexpr (requires { domain.size(); })
            return oneOf(domain, [](const auto& word) { return jsonOf(word); }).value;
        else if constexpr (std::is_same_v<Domain, WholeRange>)
            return integer(static_cast<int>(domain.low), static_cast<int>(domain.high));
        else
            return number(domain.low, domain.high);
    }

    template <int N>
    glm::vec<N, double> place(double low = -farthestPlace, double high = farthestPlace) const {
        if (arraySize() != N) fail("an array of " + std::to_string(N) + " numbers");
        glm::vec<N, double> result;
        glm::length_t i = 0;
        forEachItem([&](const Field& item) { result[i++] = item.number(low, high); });
        return result;
    }

    static constexpr const char* rootName = "the view's state";

  private:
    std::string memberName(const std::string& key) const {
        return name_ == rootName ? key : name_ + "." + key;
    }

    static Json jsonOf(const Word<int>& word) { return word.value; }
    template <class Value>
    static Json jsonOf(const Word<Value>& word) {
        return word.text;
    }

    template <class Item, std::size_t N, class JsonOf>
    Item oneOf(const std::array<Item, N>& items, JsonOf jsonOf) const {
        std::string all;
        for (const Item& item : items) {
            const Json json = jsonOf(item);
            if (value_ == json) return item;
            all += (all.empty() ? "" : ", ") +
                   (json.is_string() ? json.get<std::string>() : json.dump());
        }
        fail("one of " + all);
    }

    std::string text() const {
        if (value_.is_number_float() && !std::isfinite(value_.get<double>())) return "not finite";
        constexpr std::size_t longest = 60;
        std::string text = value_.dump(-1, ' ', true, Json::error_handler_t::replace);
        if (text.size() > longest) text = text.substr(0, longest) + "...";
        return text;
    }

    std::string name_;
    const Json& value_;
};

/// [x, y, z].
inline nlohmann::ordered_json toJson(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

} // namespace edgeshade::viewer
