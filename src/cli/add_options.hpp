#pragma once

#include "src/cli/option_table.hpp"

#include <CLI/CLI.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace edgeshade::cli {

/// The number that is the whole text; nothing: it is one of the words. This and wordIn() throw
/// CLI::ValidationError that names the option.
std::optional<double> numberIn(const Values& values, const std::string& name,
                               const std::string& text);

/// The index of the word.
std::size_t wordIn(const Values& values, const std::string& name, const std::string& text);

template <class Number>
void setNumber(Number& number, const std::optional<double>& value) {
    number = static_cast<Number>(*value);
}
template <class Number>
void setNumber(std::optional<Number>& number, const std::optional<double>& value) {
    number.reset();
    if (value) setNumber(number.emplace(), value);
}

// Each of these adds an option of the table to a verb. It first sets the table's default, so
// members of options need none. A parser without a name, such as that of --against, sets no
// defaults: it changes existing values. Referenced values must outlive parsing.

/// `use` gets the option's text, and throws CLI::ValidationError that names the option.
CLI::Option* addOption(CLI::App& verb, const std::string& name,
                       const std::function<void(const std::string&)>& use);

/// The option may be repeated; `use` gets each text, in order with other repeated options.
CLI::Option* addRepeated(CLI::App& verb, const std::string& name,
                         const std::function<void(const std::string&)>& use);

/// `text`: a string or an optional one.
template <class Text>
CLI::Option* addText(CLI::App& verb, const std::string& name, Text& text) {
    return addOption(verb, name, [&text](const std::string& typed) { text = typed; });
}

/// The option may be repeated.
inline CLI::Option* addTexts(CLI::App& verb, const std::string& name,
                             std::vector<std::string>& texts) {
    return addRepeated(verb, name, [&texts](const std::string& typed) { texts.push_back(typed); });
}

/// `number`: of any type; a word empties an optional one.
template <class Number>
CLI::Option* addNumber(CLI::App& verb, const std::string& name, Number& number) {
    const Values& values = optionOf(verb.get_name(), name).values;
    return addOption(verb, name, [&number, &values, name](const std::string& text) {
        setNumber(number, numberIn(values, name, text));
    });
}

/// `values`: the meanings of the table's words, in order. `value`: one of them, or optional.
template <class Target, class Value>
CLI::Option* addWords(CLI::App& verb, const std::string& name, Target& value,
                      const std::vector<Value>& values) {
    const Values& words = optionOf(verb.get_name(), name).values;
    return addOption(verb, name, [&value, &words, values, name](const std::string& text) {
        value = values.at(wordIn(words, name, text));
    });
}

} // namespace edgeshade::cli
