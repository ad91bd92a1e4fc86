#pragma once

#include "src/settings/domains.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace edgeshade::cli {

/// The numbers that an option takes.
struct Interval {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool isAbove = false; ///< `low` itself is left out
    bool isBelow = false; ///< `high` itself is left out
    bool isWhole = false; ///< whole numbers only
    bool isBytes = false; ///< K, M or G may follow, for powers of 1024
};

/// Values of an option: one of the words, or a number of the interval; without either any text.
struct Values {
    std::vector<std::string> words{}; ///< as help lists them
    std::optional<Interval> interval{};

    /// "auto or 1 to 64", "1, 3, 5 or 7", "above 0"; empty: any text.
    std::string text() const;
};

/// Values of a setting (src/settings/domains.hpp) on the command line.
template <class Domain>
Values valuesOf(const Domain& domain) {
    Values values;
    if constexpr (requires { domain.low; }) {
        values.interval = Interval{.low = static_cast<double>(domain.low),
                                   .high = static_cast<double>(domain.high),
                                   .isWhole = std::is_integral_v<decltype(domain.low)>};
    } else if constexpr (requires { domain.all; }) {
        for (const int number : domain.all)
            values.words.push_back(std::to_string(number));
    } else if constexpr (requires { domain.domain; }) {
        values = valuesOf(domain.domain);
        values.words.push_back(domain.none);
    } else if constexpr (requires { domain.size(); }) {
        for (const auto& word : domain)
            if (word.use != WordUse::written) values.words.push_back(word.text);
    }
    return values;
}

/// Verbs, a bit each, in the order of verbNames.
using Verbs = unsigned;

inline constexpr std::string_view verbNames[] = {"pack",  "info",      "render",   "compare",
                                                 "bench", "tradeoff",  "sunhours", "sunhours-merge",
                                                 "view",  "city-plan", "city-run", "city-merge"};

/// The bit of a verb. Throws std::logic_error for any other name.
Verbs verbOf(std::string_view name);

/// The verbs that have an option, and those whose --help lists it; --help-all lists all options.
struct Where {
    Verbs verbs, brief;
    Where(Verbs verbs_, Verbs brief_ = 0) : verbs(verbs_), brief(brief_) {}
};

/// An option of one or more verbs, as help and docs/options.md explain it.
struct Option {
    std::string names;   ///< "--size", or "-o,--output"
    std::string name;    ///< the last of these
    std::string type;    ///< its value's type in help: "WxH"; empty: a flag
    Values values;       ///< the values that it takes
    std::string initial; ///< the default: after a "=" the text that would set it, else in words
    Where where;
    std::string sentence; ///< short, without a full stop
    std::string more;     ///< further sentences, for --help-all
    std::string needs{};  ///< options that it needs

    /// `nameAndType`: "--size WxH", or "-o,--output FILE".
    Option(const std::string& nameAndType, Values values_, std::string initial_, Where where_,
           std::string sentence_, std::string more_ = "")
        : names(nameAndType.substr(0, nameAndType.find(' '))),
          name(names.substr(names.find(',') + 1)),
          type(nameAndType, std::min(names.size() + 1, nameAndType.size())),
          values(std::move(values_)), initial(std::move(initial_)), where(where_),
          sentence(std::move(sentence_)), more(std::move(more_)) {}
    /// Any text follows.
    Option(const char* nameAndType, const char* initial_, Where where_, std::string sentence_,
           std::string more_ = "")
        : Option(nameAndType, Values(), initial_, where_, std::move(sentence_), std::move(more_)) {}
    /// A flag.
    Option(const char* name_, Where where_, std::string sentence_, std::string more_ = "")
        : Option(name_, "", where_, std::move(sentence_), std::move(more_)) {}

    bool setsDefault() const { return initial.starts_with('='); }
    std::string defaultText() const { return initial.substr(setsDefault()); }
    /// The sentence with its default, and with the words if they fit into the width.
    std::string briefText(std::size_t width) const;
    /// The whole explanation, for --help-all.
    std::string fullText() const;
};

struct OptionGroup {
    const char* title;
    std::vector<Option> options;
};

/// All options in groups, in the order of --help-all (option_rows.cpp).
const std::vector<OptionGroup>& optionTable();

/// The verb's option of that name; `verb` empty: any verb's. Throws std::logic_error without one.
const Option& optionOf(std::string_view verb, std::string_view name);

/// "map_size" as an option: "--map-size".
std::string optionNameOf(std::string_view key);

} // namespace edgeshade::cli
