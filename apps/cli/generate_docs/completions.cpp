// Completions for bash, zsh and fish.
#include "generate_docs.h"

#include "../options.h"

#include <fmt/format.h>

namespace glint::cli {
namespace {

bool takes_file(const Option& option) { return option.value == std::string("FILE"); }

/// Names of all commands, joined.
std::string names(const char* separator) { return fmt::format("{}", fmt::join(command_names(), separator)); }

/// In single quotes. `quote`: a quote within them, which bash and zsh write differently from fish.
std::string quoted(const std::string& text, const char* quote) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? std::string(quote) : std::string(1, c);
    return safe + "'";
}

std::string bash_values(const Command& command) {
    std::string cases;
    for (const Option& option : command.options) {
        if (!*option.value || takes_file(option)) continue;
        std::string patterns;
        for (const std::string& name : spellings(option))
            patterns += fmt::format("{}{},{}", patterns.empty() ? "" : "|", command.name, name);
        // For other values no completion: file names would mislead.
        cases += fmt::format("        {}) mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$cur\"); return ;;\n",
                             patterns, fmt::join(choices(option), " "));
    }
    return cases;
}

std::string bash_options(const Command& command) {
    return fmt::format("        {}) words='{}' ;;\n", command.name, fmt::join(spellings(command), " "));
}

/// One option for zsh's _arguments: '(-o --output)'{-o,--output}'[help]:FILE:_files'.
std::string zsh_option(const Option& option) {
    std::string rest = "[" + std::string(option.help) + "]";
    if (*option.value) {
        const std::vector<std::string> allowed = choices(option);
        const std::string action =
            takes_file(option) ? "_files" : fmt::format("({})", fmt::join(allowed, " "));
        rest += fmt::format(":{}:{}", allowed.empty() ? option.value : "word",
                            allowed.empty() && !takes_file(option) ? " " : action);
    }
    const std::string tail = quoted(rest, "'\\''");
    // -D may be repeated.
    if (!*option.name) return fmt::format("'*{}'{}", spelling(option), tail);
    if (!option.letter) return fmt::format("'{}'{}", spelling(option), tail);
    return fmt::format("'({0})'{{{1}}}{2}", fmt::join(spellings(option), " "),
                       fmt::join(spellings(option), ","), tail);
}

const char* zsh_operand(const Command& command) {
    return command.operands == Operands::starter ? "'1:template:($(glint new --list 2>/dev/null))'"
                                                 : "'*:file:_files'";
}

std::string fish_option(const Command& command, const Option& option) {
    std::string text = fmt::format("complete -c glint -n '__glint_command {}'", command.name);
    if (option.letter) text += fmt::format(" -s {}", option.letter);
    if (*option.name) text += fmt::format(" -l {}", option.name);
    if (*option.value)
        text += takes_file(option) ? " -r -F" : fmt::format(" -x -a '{}'", fmt::join(choices(option), " "));
    return text + " -d " + quoted(option.help, "\\'") + "\n";
}

} // namespace

std::string bash_completion() {
    std::string text = "# bash completion for glint\n_glint() {\n"
                       "    local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD-1]} "
                       "command=render words values\n"
                       "    if (( COMP_CWORD > 1 )); then\n";
    text += fmt::format("        case ${{COMP_WORDS[1]}} in {}) command=${{COMP_WORDS[1]}} ;; esac\n    fi\n",
                        names("|"));
    text += "    # Options that take a value which is no file.\n    case $command,$prev in\n";
    for (const Command& command : commands()) text += bash_values(command);
    text += "    esac\n    case $command in\n";
    for (const Command& command : commands()) text += bash_options(command);
    text += "    esac\n    if (( COMP_CWORD == 1 )); then words+=' --version'; fi\n";
    text += "    if [[ $cur == -* ]]; then\n"
            "        mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$cur\")\n"
            "        return\n    fi\n    mapfile -t COMPREPLY < <(compgen -f -- \"$cur\")\n    values=\n";
    text += fmt::format("    if (( COMP_CWORD == 1 )); then values='{}'; fi\n", names(" "));
    return text + "    if [[ $command == new ]]; then values=$(glint new --list 2>/dev/null); fi\n"
                  "    if [[ $values ]]; then COMPREPLY+=($(compgen -W \"$values\" -- \"$cur\")); fi\n"
                  "}\ncomplete -o filenames -F _glint glint\n";
}

std::string zsh_completion() {
    std::string text = "#compdef glint\n_glint() {\n    local command=render\n    local -a all=(\n";
    for (const Command& command : commands())
        text +=
            fmt::format("        {}\n", quoted(fmt::format("{}:{}", command.name, command.summary), "'\\''"));
    text += fmt::format("    )\n"
                        "    if (( CURRENT > 2 )) && [[ ${{words[2]}} == ({}) ]]; then\n"
                        "        command=${{words[2]}}\n        shift words\n        (( CURRENT-- ))\n"
                        "    elif (( CURRENT == 2 )) && [[ ${{words[2]}} != -* ]]; then\n"
                        "        _describe command all\n    fi\n    case $command in\n",
                        names("|"));
    for (const Command& command : commands()) {
        text += fmt::format("        {}) _arguments", command.name);
        for (const Option& option : command.options) text += " \\\n            " + zsh_option(option);
        text += fmt::format(" \\\n            {} ;;\n", zsh_operand(command));
    }
    return text + "    esac\n}\n_glint \"$@\"\n";
}

std::string fish_completion() {
    std::string text = "# fish completion for glint\n"
                       "function __glint_command\n"
                       "    set -l words (commandline -opc)\n"
                       "    set -l command render\n";
    text += fmt::format("    if set -q words[2]; and contains -- $words[2] {}\n", names(" "));
    text += "        set command $words[2]\n    end\n    test $command = $argv[1]\nend\n";
    for (const Command& command : commands())
        text += fmt::format("complete -c glint -n 'test (count (commandline -opc)) -eq 1' -a {} -d {}\n",
                            command.name, quoted(command.summary, "\\'"));
    text += "complete -c glint -n '__glint_command new' -a '(glint new --list 2>/dev/null)'\n";
    for (const Command& command : commands())
        for (const Option& option : command.options) text += fish_option(command, option);
    return text;
}

} // namespace glint::cli
