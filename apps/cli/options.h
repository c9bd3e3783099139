#pragma once
// Every command and option in one table: it drives parsing, --help, "did you mean", the man page and the
// completions of shells.

#include <span>
#include <string>
#include <vector>

namespace glint::cli {

/// One option of a command.
struct Option {
    char letter = 0;       ///< 'o' for -o; 0: none
    const char* name = ""; ///< without dashes; empty: the letter alone
    const char* value =
        ""; ///< empty: a flag; without a capital: the allowed words ("srgb|raw"); else a placeholder
    const char* help = ""; ///< a few words
    bool joined = false;   ///< shares the line of the option before it in --help
    bool common = false;   ///< shown by `glint --help` too
};

/// What stands on the command line beside options.
enum class Operands { scene, maybe_scene, scenes, two_pictures, starter };

struct Command {
    const char* name;
    const char* synopsis; ///< "FILE [-o OUT]"
    const char* summary;  ///< a few words, for lists
    Operands operands;
    std::span<const Option> options;
    const char* notes; ///< lines that close --help; may be empty
};

/// All commands; the first is the default.
std::span<const Command> commands();
/// The command of that name, or none.
const Command* find_command(const std::string& name);
/// Names for "did you mean".
std::vector<std::string> command_names();

/// Under which name Arguments hold an option: "output", or "D" where there is a letter alone.
std::string key(const Option& option);
/// "--output", or "-D" where there is a letter alone.
std::string spelling(const Option& option);
/// Every spelling: {"-o", "--output"}.
std::vector<std::string> spellings(const Option& option);
/// The words that an option allows; empty: any value.
std::vector<std::string> choices(const Option& option);
/// "a|b" at '|': {"a", "b"}.
std::vector<std::string> split(const std::string& text, char separator);

} // namespace glint::cli
