#include "src/cli/bash_completion.hpp"

#include "src/cli/option_table.hpp"

namespace edgeshade::cli {
namespace {

std::string spaced(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words)
        text += (text.empty() ? "" : " ") + word;
    return text;
}

bool takesFile(const Option& option) {
    return option.type.starts_with("FILE") || option.type.starts_with("OUT");
}

/// A line of a bash case: values of the verb's option, unless it is a flag.
std::string caseOf(std::string_view verb, const Option& option) {
    if (option.type.empty()) return "";
    const std::string use = takesFile(option) ? "return 1" // as the shell completes files
                            : option.values.words.empty()
                                ? "return"
                                : "words='" + spaced(option.values.words) + "'";
    return "        " + std::string(verb) + option.name + ") " + use + " ;;\n";
}

} // namespace

std::string bashCompletion(const CLI::App& program) {
    std::string verbs, options, values;
    for (const CLI::App* verb : program.get_subcommands(nullptr)) {
        const std::string& name = verb->get_name();
        verbs += (verbs.empty() ? "" : " ") + name;
        std::string names;
        for (const OptionGroup& group : optionTable())
            for (const Option& option : group.options)
                if (option.where.verbs & verbOf(name)) {
                    names += " " + option.name;
                    values += caseOf(name, option);
                }
        options += "        " + name + ") words='" + names.substr(1) + "' ;;\n";
    }
    return "# bash completion for edgeshade\n"
           "_edgeshade_words() { # sets `words`; status 1: the word is a file\n"
           "    local verb=$1 option=$2 current=$3\n"
           "    words=\n"
           "    case $verb$option in\n" +
           values +
           "        *)\n"
           "        [[ $current == -* ]] || return 1\n"
           "        case $verb in\n" +
           options +
           "        esac ;;\n"
           "    esac\n"
           "}\n"
           "_edgeshade() {\n"
           "    local words current=${COMP_WORDS[COMP_CWORD]} option=\n"
           "    COMPREPLY=()\n"
           "    if ((COMP_CWORD == 1)); then\n"
           "        words='" +
           verbs +
           " --help --version'\n"
           "    else\n"
           "        # Bash makes `=` a word of its own: \"--shadows\" \"=\" \"map\".\n"
           "        if [[ $current == = ]]; then\n"
           "            option=${COMP_WORDS[COMP_CWORD - 1]} current=\n"
           "        elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == = ]]; then\n"
           "            option=${COMP_WORDS[COMP_CWORD - 2]}\n"
           "        elif [[ ${COMP_WORDS[COMP_CWORD - 1]} == --* ]]; then\n"
           "            option=${COMP_WORDS[COMP_CWORD - 1]}\n"
           "        fi\n"
           "        _edgeshade_words \"${COMP_WORDS[1]}\" \"$option\" \"$current\" || {\n"
           "            compopt -o default 2>/dev/null\n"
           "            return 0\n"
           "        }\n"
           "    fi\n"
           "    # Words have neither blanks nor patterns. `< <(...)` would need /dev/fd.\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$current\"))\n"
           "}\n"
           "complete -F _edgeshade edgeshade\n";
}

} // namespace edgeshade::cli
