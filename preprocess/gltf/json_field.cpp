#include "preprocess/gltf/json_field.hpp"

#include <cmath>

namespace edgeshade {
namespace {

/// A value as a message quotes it: short, on one line.
std::string shown(const JsonField::Json& value) {
    constexpr std::size_t longest = 60;
    if (value.is_object()) return "an object";
    if (value.is_array()) return "an array";
    std::string text = value.dump(-1, ' ', false, JsonField::Json::error_handler_t::replace);
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

} // namespace

std::string JsonField::name() const {
    if (!parent_) return key_;
    const std::string parent = parent_->name();
    if (*key_ == '\0') return parent + "[" + std::to_string(item_) + "]";
    return parent.empty() ? key_ : parent + "." + key_;
}

std::string JsonField::where() const {
    return "'" + file_.string() + "': " + name();
}

void JsonField::fail(const std::string& what) const {
    throw InputError(where() + what + ".");
}

void JsonField::failKind(const std::string& wanted) const {
    fail(" is " + shown(value_) + ", but must be " + wanted);
}

std::optional<JsonField> JsonField::find(const char* key) const {
    requireObject();
    const auto found = value_.find(key);
    if (found == value_.end()) return std::nullopt;
    return JsonField(*this, *found, key);
}

JsonField JsonField::member(const char* key) const {
    requireObject();
    const auto found = value_.find(key);
    if (found == value_.end())
        throw InputError("'" + file_.string() + "': " + JsonField(*this, value_, key).name() +
                         " is missing.");
    return JsonField(*this, *found, key);
}

std::size_t JsonField::countOf(const char* key) const {
    const auto field = find(key);
    return field ? field->size() : 0;
}

void JsonField::requireObject() const {
    if (!value_.is_object()) failKind("an object");
}

void JsonField::requireArray() const {
    if (!value_.is_array()) failKind("an array");
}

std::string JsonField::text() const {
    if (!value_.is_string()) failKind("text");
    return value_.get<std::string>();
}

std::string JsonField::oneOf(std::initializer_list<const char*> words) const {
    const std::string given = text();
    std::string all;
    for (const char* word : words) {
        if (given == word) return given;
        all += (all.empty() ? "" : ", ") + std::string(word);
    }
    fail(" is '" + given + "', but must be one of " + all);
}

double JsonField::number() const {
    if (!value_.is_number()) failKind("a number");
    return value_.get<double>();
}

double JsonField::positive() const {
    const double value = number();
    if (!std::isfinite(value) || value <= 0.0) failKind("positive");
    return value;
}

double JsonField::notNegative() const {
    const double value = number();
    if (!std::isfinite(value) || value < 0.0) failKind("0 or more");
    return value;
}

double JsonField::notZero() const {
    const double value = number();
    if (!std::isfinite(value) || value == 0.0) failKind("other than 0");
    return value;
}

std::vector<double> JsonField::numbers(std::size_t count) const {
    std::vector<double> all;
    forEachItem([&](const JsonField& item) { all.push_back(item.number()); });
    if (count != 0 && all.size() != count)
        fail(" has " + std::to_string(all.size()) + " numbers, not " + std::to_string(count));
    return all;
}

void JsonField::requireVersion(const char* key, std::uint64_t version) const {
    const JsonField says = member(key);
    if (says.wholeNumber() != version)
        says.fail(" is " + says.value().dump() + ", but this program reads version " +
                  std::to_string(version));
}

bool JsonField::boolean() const {
    if (!value_.is_boolean()) failKind("true or false");
    return value_.get<bool>();
}

std::int64_t JsonField::integer() const {
    constexpr std::int64_t least = std::numeric_limits<int>::min();
    constexpr std::int64_t most = std::numeric_limits<int>::max();
    const bool fits = value_.is_number_unsigned()
                          ? value_.get<std::uint64_t>() <= static_cast<std::uint64_t>(most)
                          : value_.is_number_integer() && value_.get<std::int64_t>() >= least;
    if (!fits) failKind("a 32-bit whole number");
    return value_.get<std::int64_t>();
}

std::uint64_t JsonField::wholeNumber(std::uint64_t most) const {
    // Numbers set from code may be of a signed type without being negative.
    const bool isWhole = value_.is_number_unsigned() ||
                         (value_.is_number_integer() && value_.get<std::int64_t>() >= 0);
    if (!isWhole) failKind("a whole number that is not negative");
    const auto number = value_.get<std::uint64_t>();
    if (number > most) failKind("at most " + std::to_string(most));
    return number;
}

int JsonField::index() const {
    return static_cast<int>(wholeNumber(std::numeric_limits<int>::max()));
}

int JsonField::indexInto(std::size_t count, const char* things) const {
    const int value = index();
    if (static_cast<std::size_t>(value) >= count)
        fail(" is " + std::to_string(value) + ", but there are " + std::to_string(count) + " " +
             things);
    return value;
}

std::string reasonOf(const nlohmann::json::exception& error) {
    const std::string message = clauseOf(error.what()); // "[json.exception. ...] text"
    const std::size_t text = message.find("] ");
    return message.substr(text == std::string::npos ? 0 : text + 2);
}

} // namespace edgeshade
