#pragma once

#include <array>
#include <CLI/CLI.hpp>
#include <string>
#include <utility>
#include <vector>

namespace edgeshade::cli {

/// The words that an option accepts, in the order of help and messages.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

template <class Value, std::size_t N>
Choices<Value> choicesOf(const std::array<std::pair<const char*, Value>, N>& words) {
    return {words.begin(), words.end()};
}

/// The choices' words with `separator` between them.
template <class Value>
std::string wordsOf(const Choices<Value>& choices, const std::string& separator) {
    std::string words;
    for (const auto& choice : choices)
        words += (words.empty() ? "" : separator) + choice.first;
    return words;
}

/// Adds an option that accepts only these words; CLI11's own transformer also accepts the numbers
/// behind them. `value`, a Value or an optional one, must outlive parsing. `synonyms` are accepted
/// but not listed.
template <class Target, class Value = Target>
void addChoice(CLI::App& verb, const std::string& option, Target& value,
               const std::vector<std::pair<std::string, Value>>& choices, const std::string& help,
               const std::vector<std::pair<std::string, Value>>& synonyms = {}) {
    const auto use = [option, &value, choices, synonyms](const std::string& text) {
        for (const auto* words : {&choices, &synonyms})
            for (const auto& [word, meaning] : *words)
                if (word == text) {
                    value = meaning;
                    return;
                }
        throw CLI::ValidationError(option,
                                   "'" + text + "' is not one of " + wordsOf(choices, ", "));
    };
    verb.add_option_function<std::string>(option, use, help)->type_name(wordsOf(choices, "|"));
}

} // namespace edgeshade::cli
