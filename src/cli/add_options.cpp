#include "src/cli/add_options.hpp"

#include "src/cli/number_text.hpp"

#include <algorithm>
#include <cmath>

namespace edgeshade::cli {
namespace {

/// The reason why a value is not in an interval; empty: it is.
std::string faultOf(double value, const Interval& of) {
    if (of.isWhole && value != std::floor(value)) return "no whole number";
    if (value < of.low || (of.isAbove && value == of.low))
        return (of.isAbove ? "not above " : "below ") + shortText(of.low);
    if (value > of.high || (of.isBelow && value == of.high))
        return (of.isBelow ? "not below " : "above ") + shortText(of.high);
    return "";
}

} // namespace

CLI::Option* addOption(CLI::App& verb, const std::string& name,
                       const std::function<void(const std::string&)>& use) {
    const Option& option = optionOf(verb.get_name(), name);
    if (!verb.get_name().empty() && option.setsDefault()) use(option.defaultText());
    return verb.add_option_function<std::string>(option.names, use)->type_name(option.type);
}

CLI::Option* addRepeated(CLI::App& verb, const std::string& name,
                         const std::function<void(const std::string&)>& use) {
    const auto useAll = [use](const std::vector<std::string>& texts) {
        for (const std::string& text : texts)
            use(text);
    };
    // One call an occurrence keeps the order of several such options.
    return verb.add_option_function<std::vector<std::string>>(name, useAll)
        ->type_name(optionOf(verb.get_name(), name).type)
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
        ->trigger_on_parse();
}

std::optional<double> numberIn(const Values& values, const std::string& name,
                               const std::string& text) {
    if (std::ranges::find(values.words, text) != values.words.end()) return std::nullopt;
    const std::size_t power = // 0: no unit follows
        values.interval->isBytes && !text.empty() ? std::string("KMG").find(text.back()) + 1 : 0;
    const double value = std::ldexp(numberFrom(text.substr(0, text.size() - (power > 0)), name),
                                    static_cast<int>(10 * power));
    if (const std::string fault = faultOf(value, *values.interval); !fault.empty())
        throw CLI::ValidationError(name, "'" + text + "' is " + fault);
    return value;
}

std::size_t wordIn(const Values& values, const std::string& name, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < values.words.size(); ++i) {
        if (values.words[i] == text) return i;
        all += (i == 0 ? "" : ", ") + values.words[i];
    }
    throw CLI::ValidationError(name, "'" + text + "' is none of " + all);
}

} // namespace edgeshade::cli
