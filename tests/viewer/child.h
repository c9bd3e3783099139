#pragma once
// A program that runs beside the test.

#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace glint::test {

class Child {
  public:
    /// Starts the program arguments[0], found on PATH. Its output goes to the file `log`; lines that it
    /// writes to file descriptor 3 are notes. `environment` is added to that of the test.
    Child(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
          const std::string& log);
    /// Ends the program if it still runs.
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    /// Its exit code, or 128 + signal; none while it runs.
    std::optional<int> ended();
    /// Waits at most that long.
    std::optional<int> wait(double seconds);
    /// The first line written to file descriptor 3; empty if the program ends without.
    std::string first_note();
    void signal(int number) const;
    pid_t pid() const { return pid_; }

  private:
    pid_t pid_ = -1;
    int notes_ = -1;
    std::optional<int> code_;
};

/// Is the program on PATH?
bool is_installed(const std::string& program);

void sleep_for(double seconds);
/// Seconds of a monotonic clock.
double now();

} // namespace glint::test
