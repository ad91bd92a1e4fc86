#pragma once

#include "preprocess/base/error.hpp"

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade {

/// A value in a file's JSON and its location, so that one sentence can report any error in it:
/// "'scene.glb': accessors[3].count is -24, but must be ...".
///
/// Reading functions throw that InputError. A field refers to its parent, which must outlive it.
/// Its full name is built only for messages.
class JsonField {
  public:
    using Json = nlohmann::ordered_json;

    /// A root field; `name` begins the names of all fields below it.
    JsonField(const std::filesystem::path& file, const Json& value, const char* name = "")
        : file_(file), value_(value), key_(name) {}

    const Json& value() const { return value_; }
    std::string name() const;                              ///< "accessors[3].count"
    std::string where() const;                             ///< "'file': name"
    [[noreturn]] void fail(const std::string& what) const; ///< where() + what + "."

    /// The member, which must exist. Throws InputError.
    JsonField member(const char* key) const;
    std::optional<JsonField> find(const char* key) const;
    std::size_t size() const { return value_.size(); }
    JsonField item(std::size_t i) const { return JsonField(*this, value_.at(i), i); }
    /// The number of items of the member; 0 if it is missing.
    std::size_t countOf(const char* key) const;

    void requireObject() const;
    void requireArray() const;
    std::string text() const;
    /// The value, which must be one of `words`.
    std::string oneOf(std::initializer_list<const char*> words) const;
    double number() const;
    /// A finite number above 0 (positive), at least 0 (notNegative), or other than 0 (notZero).
    double positive() const;
    double notNegative() const;
    double notZero() const;
    /// An array of `count` numbers; of any length if `count` is 0.
    std::vector<double> numbers(std::size_t count = 0) const;
    bool boolean() const;
    std::int64_t integer() const; ///< within the range of int
    std::uint64_t wholeNumber(std::uint64_t most = std::numeric_limits<std::int64_t>::max()) const;
    /// An index within the range of int; the caller checks what it refers to.
    int index() const;
    /// An index into `count` things named `things`.
    int indexInto(std::size_t count, const char* things) const;

    /// Checks that the member is this version of the file's format.
    void requireVersion(const char* key, std::uint64_t version) const;

    /// Calls check(JsonField) for every item of this array.
    template <class Check>
    void forEachItem(Check check) const {
        requireArray();
        for (std::size_t i = 0; i < value_.size(); ++i)
            check(item(i));
    }

    /// Calls check(JsonField) for every member of this object.
    template <class Check>
    void forEachMember(Check check) const {
        requireObject();
        for (auto member = value_.begin(); member != value_.end(); ++member)
            check(JsonField(*this, *member, member.key().c_str()));
    }

    /// Calls check(JsonField) for the member, if it is there.
    template <class Check>
    void ifPresent(const char* key, Check check) const {
        if (const auto field = find(key)) check(*field);
    }

    /// Calls check(JsonField) for the extension of that name, if this object has it.
    template <class Check>
    void ifExtension(const char* name, Check check) const {
        ifPresent("extensions",
                  [&](const JsonField& extensions) { extensions.ifPresent(name, check); });
    }

    const char* key() const { return key_; } ///< of a member; empty for an item

  private:
    JsonField(const JsonField& parent, const Json& value, const char* key)
        : file_(parent.file_), value_(value), parent_(&parent), key_(key) {}
    JsonField(const JsonField& parent, const Json& value, std::size_t item)
        : file_(parent.file_), value_(value), parent_(&parent), item_(item) {}

    [[noreturn]] void failKind(const std::string& wanted) const;

    const std::filesystem::path& file_;
    const Json& value_;
    const JsonField* parent_ = nullptr; ///< null: the name starts here
    const char* key_ = "";
    std::size_t item_ = 0; ///< used if key_ is empty
};

/// The reason of an error of the JSON library, without its number: "parse error at line 1, ...".
std::string reasonOf(const nlohmann::json::exception& error);

/// Runs `action`, and turns exceptions of the JSON library into an InputError that names the file.
/// This is a safety net below the checks: every field should have been read as a JsonField first.
template <class Action>
auto withJsonErrors(const std::filesystem::path& file, Action action) {
    try {
        return action();
    } catch (const nlohmann::json::exception& error) {
        throw InputError("'" + file.string() + "' is not valid glTF 2.0: " + reasonOf(error) + ".");
    }
}

} // namespace edgeshade
