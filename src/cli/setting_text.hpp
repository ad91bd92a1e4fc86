#pragma once

#include "src/cli/add_options.hpp"
#include "src/settings/settings.hpp"

#include <nlohmann/json.hpp>

namespace edgeshade::cli {

/// Reads a setting's value as typed. `name`: the option's, for CLI::ValidationError.
template <class Domain, class Value>
void read(const Domain& domain, const std::string& name, const std::string& text, Value& value) {
    if constexpr (requires { domain.size(); }) { // words, those that help doesn't list too
        for (const auto& word : domain)
            if (word.text == text) {
                value = word.value;
                return;
            }
        wordIn(valuesOf(domain), name, text); // throws
    } else if constexpr (requires { domain.all; }) {
        value = domain.all[wordIn(valuesOf(domain), name, text)];
    } else if constexpr (std::is_same_v<Domain, FileName>) {
        value = text == domain.none ? "" : text;
    } else {
        setNumber(value, numberIn(valuesOf(domain), name, text));
    }
}

/// The value as reports have it.
template <class Domain, class Value>
nlohmann::ordered_json written(const Domain& domain, const Value& value) {
    if constexpr (requires { domain.size(); })
        return wordOf(domain, value);
    else if constexpr (requires { domain.domain; })
        return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(domain.none);
    else if constexpr (std::is_same_v<Domain, FileName>)
        return value.empty() ? domain.none : value;
    else
        return value;
}

/// Adds the setting's option, see add_options.hpp.
template <class Domain, class Value>
CLI::Option* addSetting(CLI::App& verb, const Setting<Domain>& setting, Value& value) {
    const std::string name = optionNameOf(setting.key);
    return addOption(verb, name, [&setting, &value, name](const std::string& text) {
        read(setting.domain, name, text, value);
    });
}

} // namespace edgeshade::cli
