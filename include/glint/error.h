#pragma once
// Errors and warnings. The library never prints: problems are returned as values (`Diagnostic`) or thrown as
// the only exception type of its own (`Error`).

#include <cstddef>
#include <cstdint>
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// A position in an input file. Lines and columns count from 1; 0 means unknown. Columns count bytes.
struct Location {
    std::string file;
    int line = 0;
    int column = 0;
    std::optional<std::uint64_t> byte = {}; ///< offset, for binary files

    friend bool operator==(const Location&, const Location&) = default;
};

enum class Severity { warning, error };

/// A problem: location, cause and suggested cure.
struct Diagnostic {
    Severity severity = Severity::error;
    Location location;
    std::string message; ///< what is wrong: one sentence without a full stop
    std::string hint;    ///< what was expected, or the nearest valid name; may be empty
    std::string excerpt; ///< the source line at the location; may be empty
};

/// Kind of failure; each has its own exit code on the command line.
enum class ErrorKind {
    usage,     ///< wrong arguments
    input,     ///< input invalid or unreadable
    output,    ///< output cannot be written
    resource,  ///< out of memory, or beyond a size limit
    device,    ///< a device is missing or was lost
    cancelled, ///< the caller asked to stop
    internal,  ///< a bug in glint
};

/// The text with control characters, except those `kept`, as escapes such as \u001b: for terminals.
std::string printable(std::string_view text, std::string_view kept = {});

/// "file:line:column", or "file: byte 17"; what is unknown is left out.
std::string to_string(const Location& location);

/// "file:line:column: error: message", the source line with a caret, and the hint.
std::string to_string(const Diagnostic& diagnostic);

/// The exception type of the library. Contains all errors that were found, at least one.
class Error : public std::exception {
  public:
    Error(ErrorKind kind, std::string message, std::string hint = {}, Location location = {});
    Error(ErrorKind kind, std::vector<Diagnostic> diagnostics);

    ErrorKind kind() const noexcept { return kind_; }
    const std::vector<Diagnostic>& diagnostics() const noexcept { return diagnostics_; }
    /// All diagnostics as text.
    const char* what() const noexcept override { return text_.c_str(); }

  private:
    ErrorKind kind_;
    std::vector<Diagnostic> diagnostics_;
    std::string text_;
};

/// The candidate with the smallest edit distance to `word`, if it is close enough to be meant.
std::optional<std::string> nearest_name(const std::string& word, const std::vector<std::string>& candidates);

/// "did you mean "glass"?", or `otherwise` where no candidate is near.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates,
                         std::string otherwise = {});

} // namespace glint
