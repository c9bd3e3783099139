#pragma once
// Messages to stderr. stdout is for data only.

#include "glint/error.h"

#include <mutex>
#include <string>
#include <vector>

namespace glint::cli {

enum class Verbosity { quiet, normal, verbose };

/// If the caller has closed stdin, stdout or stderr, opens them so that every use fails. Otherwise the next
/// file that is opened would take the place, and messages would be written into a picture.
void reserve_standard_streams();

/// Is stderr a terminal with colours and cursor movement (TERM is set and not "dumb")?
bool stderr_is_terminal();
/// Are messages coloured? `when` is "auto", "always" or "never"; auto respects NO_COLOR.
bool wants_color(const std::string& when);
/// The same for data on stdout.
bool wants_color_on_stdout(const std::string& when);

/// Thread-safe: messages are not mixed.
class Console {
  public:
    Console(Verbosity verbosity, bool color) : verbosity_(verbosity), color_(color) {}

    bool quiet() const { return verbosity_ == Verbosity::quiet; }
    bool verbose() const { return verbosity_ == Verbosity::verbose; }

    /// Shown at any verbosity.
    void error(const Diagnostic& diagnostic);
    void error(const std::string& message, const std::string& hint = {});
    void always(const std::string& line);
    /// Hidden by -q.
    void warning(const Diagnostic& diagnostic);
    void warnings(const std::vector<Diagnostic>& diagnostics);
    /// "note: …", about a choice made for the user.
    void note(const std::string& text);
    void line(const std::string& text);
    /// Shown with -v only.
    void detail(const std::string& text);
    /// A line that the next message or status replaces, on terminals only; empty erases it.
    void status(const std::string& text);

  private:
    /// Colours the word where it first stands in the text.
    void write(const std::string& text, const std::string& word = {}, const char* color = nullptr);

    Verbosity verbosity_;
    bool color_;
    bool status_shown_ = false;
    std::mutex mutex_;
};

/// Writes all data to stdout and flushes it. Throws Error(output).
void print_data(const std::string& text);

} // namespace glint::cli
