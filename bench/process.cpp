// Running child processes.

#include "process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <stdexcept>

namespace glint::bench {
namespace {

/// Reads everything a child writes to its pipe.
std::string read_all(int descriptor) {
    std::string text;
    std::array<char, 256> part;
    for (ssize_t n = read(descriptor, part.data(), part.size()); n > 0;
         n = read(descriptor, part.data(), part.size()))
        text.append(part.data(), static_cast<std::size_t>(n));
    return text;
}

} // namespace

std::string run_self(const std::vector<std::string>& arguments) {
    std::vector<std::string> all_arguments{program_invocation_short_name};
    all_arguments.insert(all_arguments.end(), arguments.begin(), arguments.end());
    std::vector<char*> pointers;
    for (std::string& word : all_arguments) pointers.push_back(word.data());
    pointers.push_back(nullptr);

    std::array<int, 2> ends;
    if (pipe(ends.data()) != 0) throw std::runtime_error("cannot create a pipe");
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("cannot start a child process");
    if (child == 0) {
        dup2(ends[1], STDOUT_FILENO);
        close(ends[0]);
        execv("/proc/self/exe", pointers.data());
        _exit(127);
    }
    close(ends[1]);
    std::string text = read_all(ends[0]);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (status != 0) {
        std::string message = "child process failed: " + std::string(program_invocation_short_name);
        for (const std::string& word : arguments) message += " " + word;
        throw std::runtime_error(message);
    }
    return text;
}

} // namespace glint::bench
