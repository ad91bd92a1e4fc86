// Pages and declarations that the tables of settings and options make.

#include "src/cli/option_table.hpp"
#include "src/settings/settings.hpp"
#include "tests/settings/generated.hpp"

#include <gtest/gtest.h>

namespace edgeshade::test {
namespace {

using cli::Option;

std::string verbsText(cli::Verbs verbs) {
    std::string text;
    for (const std::string_view verb : cli::verbNames)
        if (verbs & cli::verbOf(verb)) text += (text.empty() ? "" : ", ") + std::string(verb);
    return text;
}

std::string inCell(std::string text) {
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos; at += 2)
        text.insert(at, "\\");
    return text;
}

std::string rowOf(const Option& option) {
    const std::string type = option.type.empty() ? "" : " " + option.type;
    std::string meaning = option.sentence + ".";
    if (!option.needs.empty()) meaning += " Needs `" + option.needs + "`.";
    if (!option.more.empty()) meaning += " " + option.more;
    return "| `" + option.name + inCell(type) + "` | " + inCell(option.values.text()) + " | " +
           inCell(option.defaultText()) + " | " + verbsText(option.where.verbs) + " | " +
           inCell(meaning) + " |\n";
}

template <class Value, std::size_t N>
std::string typeOf(const Words<Value, N>& words) {
    std::string type;
    for (const Word<Value>& word : words)
        type += (type.empty() ? "'" : " | '") + std::string(word.text) + "'";
    return type;
}
std::string typeOf(const Words<ShadowMethod, settings::shadows.domain.size()>&) {
    return "Shadows"; // what pages can draw of them
}
template <std::size_t N>
std::string typeOf(const Words<int, N>&) {
    return "number";
}
template <class Domain>
std::string typeOf(const Domain&) {
    return "number";
}

/// The values that the type doesn't list.
template <class Domain>
std::string rangeOf(const Domain& domain) {
    return ": " + cli::valuesOf(domain).text();
}
template <class Value, std::size_t N>
std::string rangeOf(const Words<Value, N>&) {
    return "";
}
template <std::size_t N>
std::string rangeOf(const Words<int, N>& words) {
    std::string text;
    for (const Word<int>& word : words)
        text += (text.empty() ? ": " : ", ") + std::to_string(word.value) + " for " + word.text;
    return text;
}

} // namespace

TEST(Generated, ThePageOfOptionsIsCurrent) {
    std::string page;
    for (const cli::OptionGroup& group : cli::optionTable()) {
        page += "\n## " + std::string(group.title) +
                "\n\n| option | values | default | verbs | meaning |\n"
                "| --- | --- | --- | --- | --- |\n";
        for (const Option& option : group.options)
            page += rowOf(option);
    }
    expectGenerated("docs/options.md", "options", page + "\n");
}

TEST(Generated, TheElementDeclaresTheSettingsOfASide) {
    std::string members;
    forEachSideSetting([&](const auto& setting) {
        const Option& option = cli::optionOf("view", cli::optionNameOf(setting.key));
        members += "  /** " + option.sentence + rangeOf(setting.domain) + ". */\n  " +
                   std::string(setting.key) + ": " + typeOf(setting.domain) + ";\n";
    });
    expectGenerated("web/element/edgeshade-viewer.d.ts", "settings", members);
}

} // namespace edgeshade::test
