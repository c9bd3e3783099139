#include "child.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace glint::test {

Child::Child(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
             const std::string& log) {
    std::vector<std::string> own = arguments;
    std::vector<char*> pointers;
    for (std::string& word : own) pointers.push_back(word.data());
    pointers.push_back(nullptr);
    std::array<int, 2> pipe_ends{};
    if (pipe2(pipe_ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process");
    if (pid_ == 0) {
        for (const std::string& setting : environment) putenv(const_cast<char*>(setting.c_str()));
        dup2(file, STDOUT_FILENO);
        dup2(file, STDERR_FILENO);
        // A descriptor that is 3 already would keep its mark to be closed.
        const int spare = fcntl(pipe_ends[1], F_DUPFD_CLOEXEC, 10);
        dup2(spare, 3);
        execvp(pointers[0], pointers.data());
        _exit(127);
    }
    close(file);
    close(pipe_ends[1]);
    notes_ = pipe_ends[0];
}

Child::~Child() {
    if (!ended()) {
        kill(pid_, SIGTERM);
        if (!wait(3)) {
            kill(pid_, SIGKILL);
            waitpid(pid_, nullptr, 0);
        }
    }
    close(notes_);
}

std::optional<int> Child::ended() {
    if (code_) return code_;
    int status = 0;
    if (waitpid(pid_, &status, WNOHANG) == pid_)
        code_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return code_;
}

std::optional<int> Child::wait(double seconds) {
    for (const double end = now() + seconds; !ended() && now() < end;) sleep_for(0.005);
    return ended();
}

std::string Child::first_note() {
    std::string line;
    for (char c = 0; read(notes_, &c, 1) == 1 && c != '\n';) line += c;
    return line;
}

void Child::signal(int number) const { kill(pid_, number); }

bool is_installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        if (access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    return false;
}

void sleep_for(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace glint::test
