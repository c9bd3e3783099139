#include "process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace glint::test {
namespace {

struct Pipe {
    int read_end = -1;
    int write_end = -1;
    Pipe() {
        std::array<int, 2> ends{};
        if (pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
        read_end = ends[0];
        write_end = ends[1];
    }
    ~Pipe() {
        close_read();
        close_write();
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;
    void close_read() { close_end(read_end); }
    void close_write() { close_end(write_end); }

  private:
    static void close_end(int& end) {
        if (end >= 0) close(end);
        end = -1;
    }
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> all;
    for (std::string& text : texts) all.push_back(text.data());
    all.push_back(nullptr);
    return all;
}

/// In the child: becomes the program.
[[noreturn]] void become(std::vector<char*> words, std::vector<char*> environment, const Setting& setting,
                         const std::array<int, 3>& streams) {
    for (int i = 0; i < 3; ++i) dup2(streams[static_cast<std::size_t>(i)], i);
    // Whoever runs the tests may ignore signals; the program must not inherit that.
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    std::signal(SIGHUP, SIG_DFL);
    std::signal(SIGPIPE, SIG_DFL);
    if (!setting.folder.empty() && chdir(setting.folder.c_str()) != 0) _exit(127);
    execve(words[0], words.data(), environment.data());
    _exit(127);
}

/// What can be read now goes to `text`; false at the end of the stream.
bool drain(int file, std::string& text) {
    std::array<char, 4096> buffer{};
    const ssize_t count = read(file, buffer.data(), buffer.size());
    if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    return count > 0 || (count < 0 && errno == EINTR);
}

/// Reads both streams until they end; sends the signal when its text or its time comes.
void listen(pid_t child, Pipe& out, Pipe& err, const Setting& setting, Outcome& outcome) {
    using Clock = std::chrono::steady_clock;
    const auto due = Clock::now() + std::chrono::milliseconds(setting.signal_after);
    bool sent = setting.signal == 0;
    while (out.read_end >= 0 || err.read_end >= 0) {
        std::array<pollfd, 2> waiting{{{out.read_end, POLLIN, 0}, {err.read_end, POLLIN, 0}}};
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - Clock::now());
        const int limit = sent || left.count() < 0 ? -1 : static_cast<int>(left.count());
        if (poll(waiting.data(), waiting.size(), limit) < 0) continue;
        if (waiting[0].revents != 0 && !drain(out.read_end, outcome.out)) out.close_read();
        if (waiting[1].revents != 0 && !drain(err.read_end, outcome.err)) err.close_read();
        if (!sent && Clock::now() >= due && outcome.err.find(setting.signal_when) != std::string::npos) {
            kill(child, setting.signal);
            sent = true;
        }
    }
}

std::vector<std::string> environment_of(const Setting& setting) {
    std::vector<std::string> all = setting.environment;
    for (const char* name :
         {"PATH", "HOME", "LD_LIBRARY_PATH", "ASAN_OPTIONS", "TSAN_OPTIONS", "UBSAN_OPTIONS"})
        if (const char* value = std::getenv(name)) all.push_back(std::string(name) + "=" + value);
    return all;
}

} // namespace

Outcome run_program(const std::vector<std::string>& words, const Setting& setting) {
    std::vector<std::string> own_words = words;
    std::vector<std::string> own_environment = environment_of(setting);
    Pipe in;
    Pipe out;
    Pipe err;
    const int out_file = setting.out_file.empty() ? -1 : open(setting.out_file.c_str(), O_WRONLY | O_CLOEXEC);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0)
        become(pointers(own_words), pointers(own_environment), setting,
               {in.read_end, out_file >= 0 ? out_file : out.write_end, err.write_end});

    in.close_read();
    out.close_write();
    err.close_write();
    // Scenes are far smaller than a pipe, so that this cannot block.
    const ssize_t fed = write(in.write_end, setting.input.data(), setting.input.size());
    in.close_write();
    Outcome outcome;
    listen(child, out, err, setting, outcome);
    if (out_file >= 0) close(out_file);
    int status = 0;
    waitpid(child, &status, 0);
    if (fed != static_cast<ssize_t>(setting.input.size())) throw std::runtime_error("stdin was not taken");
    outcome.exit = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

Outcome run_glint(const std::vector<std::string>& words, const Setting& setting) {
    std::vector<std::string> all{GLINT_PROGRAM};
    all.insert(all.end(), words.begin(), words.end());
    return run_program(all, setting);
}

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

} // namespace glint::test
