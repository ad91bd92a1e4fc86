#include "src/cli/option_table.hpp"

#include "src/cli/number_text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace edgeshade::cli {
namespace {

std::string textOf(const Interval& of) {
    const std::string low = shortText(of.low), high = shortText(of.high);
    const bool isClosed = std::isfinite(of.low) && !of.isAbove && !of.isBelow;
    if (isClosed && std::isfinite(of.high)) return low + " to " + high;
    return (of.isAbove ? "above " : "at least ") + low +
           (std::isfinite(of.high) ? (of.isBelow ? ", below " : ", at most ") + high : "");
}

std::string inParentheses(const std::string& text) {
    return text.empty() ? "" : " (" + text + ")";
}

} // namespace

std::string Values::text() const {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() && !interval ? " or " : ", ") + words[i];
    if (interval) text += (words.empty() ? "" : " or ") + textOf(*interval);
    return text;
}

std::string Option::briefText(std::size_t width) const {
    const std::string words = values.words.empty() ? "" : ": " + values.text();
    const std::string end = inParentheses(defaultText());
    return sentence + (sentence.size() + words.size() + end.size() <= width ? words : "") + end;
}

std::string Option::fullText() const {
    const std::string range = values.text();
    return sentence + (range.empty() ? "" : ": " + range) + inParentheses(defaultText()) + "." +
           (needs.empty() ? "" : " Needs " + needs + ".") + (more.empty() ? "" : " " + more);
}

Verbs verbOf(std::string_view name) {
    const auto found = std::ranges::find(verbNames, name);
    if (found == std::end(verbNames)) throw std::logic_error(std::string(name) + " is no verb");
    return 1u << (found - verbNames);
}

const Option& optionOf(std::string_view verb, std::string_view name) {
    const Verbs wanted = verb.empty() ? ~Verbs{0} : verbOf(verb);
    for (const OptionGroup& group : optionTable())
        for (const Option& option : group.options)
            if (option.name == name && (option.where.verbs & wanted)) return option;
    throw std::logic_error(std::string(verb) + " has no " + std::string(name) +
                           " in src/cli/option_rows.cpp");
}

std::string optionNameOf(std::string_view key) {
    std::string name = "--" + std::string(key);
    std::ranges::replace(name, '_', '-');
    return name;
}

} // namespace edgeshade::cli
