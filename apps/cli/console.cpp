// Verbosity, colours and the status line.
#include "console.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace glint::cli {
namespace {

constexpr const char* red = "\x1b[1;31m";
constexpr const char* magenta = "\x1b[1;35m";
constexpr const char* cyan = "\x1b[1;36m";
constexpr const char* plain = "\x1b[0m";
constexpr const char* erase_line = "\r\x1b[K";

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

bool is_terminal(int file) {
    const std::string term = environment("TERM");
    return isatty(file) == 1 && !term.empty() && term != "dumb";
}

/// Messages that cannot be shown must not stop the work.
void print(const std::string& text) {
    static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
    std::fflush(stderr);
}

bool wants_color_on(int file, const std::string& when) {
    if (when != "auto") return when == "always";
    return is_terminal(file) && environment("NO_COLOR").empty();
}

} // namespace

void reserve_standard_streams() {
    for (const int file : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(file, F_GETFD) < 0 && open("/dev/null", file == STDIN_FILENO ? O_WRONLY : O_RDONLY) < 0)
            return;
}

bool stderr_is_terminal() { return is_terminal(STDERR_FILENO); }

bool wants_color(const std::string& when) { return wants_color_on(STDERR_FILENO, when); }

bool wants_color_on_stdout(const std::string& when) { return wants_color_on(STDOUT_FILENO, when); }

void Console::error(const Diagnostic& diagnostic) {
    // Messages that are not about a file name the program.
    const std::string text = (diagnostic.location.file.empty() ? "glint: " : "") + to_string(diagnostic);
    write(text, "error:", red);
}

void Console::error(const std::string& message, const std::string& hint) {
    error(Diagnostic{Severity::error, {}, message, hint, {}});
}

void Console::always(const std::string& line) { write(line); }

void Console::warning(const Diagnostic& diagnostic) {
    if (!quiet()) write(to_string(diagnostic), "warning:", magenta);
}

void Console::warnings(const std::vector<Diagnostic>& diagnostics) {
    for (const Diagnostic& diagnostic : diagnostics) warning(diagnostic);
}

void Console::note(const std::string& text) {
    if (!quiet()) write("note: " + text, "note:", cyan);
}

void Console::line(const std::string& text) {
    if (!quiet()) write(text);
}

void Console::detail(const std::string& text) {
    if (verbose()) write(text);
}

void Console::status(const std::string& text) {
    if (quiet() || !stderr_is_terminal()) return;
    const std::lock_guard lock(mutex_);
    if (!text.empty() || status_shown_) print(erase_line + printable(text));
    status_shown_ = !text.empty();
}

void Console::write(const std::string& text, const std::string& word, const char* color) {
    std::string shown = printable(text, "\n\t");
    const std::size_t at = shown.find(word);
    if (color && color_ && at != std::string::npos) shown.replace(at, word.size(), color + word + plain);
    const std::lock_guard lock(mutex_);
    print((status_shown_ ? erase_line : "") + shown + "\n");
    status_shown_ = false;
}

void print_data(const std::string& text) {
    const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
    if (written == text.size() && std::fflush(stdout) == 0) return;
    throw Error(ErrorKind::output, fmt::format("cannot write to stdout: {}", std::strerror(errno)));
}

} // namespace glint::cli
