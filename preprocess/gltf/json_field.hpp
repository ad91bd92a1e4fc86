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

/// A value in a file's JSON and where it stands, so that whatever is wrong with it can be said in
/// one sentence: "'scene.glb': accessors[3].count is -24, but must be ...".
///
/// Reading functions throw that InputError. A field refers to the one that it was reached from,
/// which must outlive it; the name is put together only for messages.
class JsonField {
  public:
    using Json = nlohmann::ordered_json;

    /// A field of its own; `name` stands at the start of the names of all below it.
    JsonField(const std::filesystem::path& file, const Json& value, const char* name = "")
        : file_(file), value_(value), key_(name) {}

    const Json& value() const { return value_; }
    std::string name() const;                              ///< "accessors[3].count"
    std::string where() const;                             ///< "'file': name"
    [[noreturn]] void fail(const std::string& what) const; ///< where() + what + "."

    /// The member, which must be there.
    JsonField member(const char* key) const;
    std::optional<JsonField> find(const char* key) const;
    std::size_t size() const { return value_.size(); }
    JsonField item(std::size_t i) const { return JsonField(*this, value_.at(i), i); }
    /// How many items the member has; 0 where it isn't there.
    std::size_t countOf(const char* key) const;

    void requireObject() const;
    void requireArray() const;
    std::string text() const;
    /// One of these words.
    std::string oneOf(std::initializer_list<const char*> words) const;
    double number() const;
    /// A finite number that is above 0; 0 or more; other than 0.
    double positive() const;
    double notNegative() const;
    double notZero() const;
    /// An array of numbers, `count` of them, or any number of them for 0.
    std::vector<double> numbers(std::size_t count = 0) const;
    bool boolean() const;
    std::int64_t integer() const; ///< as wide as an int
    std::uint64_t wholeNumber(std::uint64_t most = std::numeric_limits<std::int64_t>::max()) const;
    /// An index, as wide as an int; what it refers to is for the caller to check.
    int index() const;
    /// An index into `count` things named `things`.
    int indexInto(std::size_t count, const char* things) const;

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
    const JsonField* parent_ = nullptr; ///< null: this is where the name starts
    const char* key_ = "";
    std::size_t item_ = 0; ///< where key_ is empty
};

/// Does `action`; what the JSON library throws in it becomes an InputError that names the file. A
/// net below the checks: each field that is read should have been looked at as a JsonField before.
template <class Action>
auto withJsonErrors(const std::filesystem::path& file, Action action) {
    try {
        return action();
    } catch (const nlohmann::json::exception& error) {
        const std::string message = clauseOf(error.what()); // "[json.exception. ...] text"
        const std::size_t text = message.find("] ");
        throw InputError("'" + file.string() + "' is no valid glTF 2.0: " +
                         message.substr(text == std::string::npos ? 0 : text + 2) + ".");
    }
}

} // namespace edgeshade
