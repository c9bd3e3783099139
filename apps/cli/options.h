#pragma once
// The table of commands and options: parsing, --help, "did you mean", the man page and shell completions
// follow from it.

#include <span>
#include <string>
#include <vector>

namespace glint::cli {

/// One option of a command.
struct Option {
    char letter = 0;       ///< 'o' for -o; 0: none
    const char* name = ""; ///< without dashes; empty: the letter alone
    const char* value =
        ""; ///< empty: a flag; lower case: the choices ("srgb|raw"); else what it stands for ("FILE")
    const char* help = ""; ///< short, for --help
    bool joined = false;   ///< shares the line of the option before it in --help
    bool common = false;   ///< shown by `glint --help` too
};

/// The arguments that are not options.
enum class Operands { scene, maybe_scene, scenes, two_pictures, starter };

struct Command {
    const char* name;
    const char* synopsis; ///< "FILE [-o OUT]"
    const char* summary;  ///< short, for lists of commands
    Operands operands;
    std::span<const Option> options;
    const char* notes; ///< last lines of --help; may be empty
};

/// All commands; the first is the default.
std::span<const Command> commands();
/// The command with this name, or null.
const Command* find_command(const std::string& name);
/// Names for "did you mean".
std::vector<std::string> command_names();

/// The key of an option in Arguments: "output", or "D" if it only has a letter.
std::string key(const Option& option);
/// "--output", or "-D" if it only has a letter.
std::string spelling(const Option& option);
/// Every spelling: {"-o", "--output"}.
std::vector<std::string> spellings(const Option& option);
/// Those of all its options.
std::vector<std::string> spellings(const Command& command);
/// The values that an option allows; empty: any.
std::vector<std::string> choices(const Option& option);
/// "a|b" with separator '|': {"a", "b"}.
std::vector<std::string> split(const std::string& text, char separator);

} // namespace glint::cli
