#pragma once
// Runs programs and says what they printed and how they ended.

#include <string>
#include <vector>

namespace glint::test {

struct Outcome {
    int exit = -1; ///< exit code, or 128 + signal if a signal killed the program
    std::string out;
    std::string err;
};

/// How to run a program, beside its words.
struct Setting {
    std::string folder;                   ///< working directory
    std::string input;                    ///< stdin
    std::vector<std::string> environment; ///< "NAME=value"; PATH and HOME are passed on
    std::string signal_when;              ///< when stderr holds this text …
    int signal = 0;                       ///< … this signal is sent, once
    int signal_after = 0;                 ///< … but not before so many milliseconds
    std::string out_file;                 ///< stdout goes to this file instead
};

/// Runs words[0] with the rest for its arguments and waits for its end.
Outcome run_program(const std::vector<std::string>& words, const Setting& setting);

/// The same for the built glint.
Outcome run_glint(const std::vector<std::string>& words, const Setting& setting);

/// "a b  c" → {"a", "b", "c"}.
std::vector<std::string> words_of(const std::string& line);

/// Does a sanitizer look on, which has an allocator of its own and takes terabytes of addresses, and must be
/// loaded before other libraries?
constexpr bool sanitized =
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    true;
#else
    false;
#endif

} // namespace glint::test
