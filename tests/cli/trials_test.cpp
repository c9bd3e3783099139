// Eight commands, stopped in the middle: by allocations that fail and by signals. A few moments of each; with
// GLINT_ALL_TRIALS=1 every allocation and 400 signals.

#include "cli_test.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <map>
#include <random>
#include <set>

namespace glint::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* commands[] = {
    "good.toml --size 96x72 -t 2 -o a.png",
    "mesh.toml --size 96x72 -t 2 --layers -o a.exr",
    "moving.toml --frames 0..2 -t 2 -o f-%d.pfm",
    "check good.toml mesh.toml",
    "info mesh.toml --json",
    "explain good.toml --pixel 8,6 --format svg -o a.svg",
    "diff one.exr two.exr --tolerance inf -o a.png",
    "new glass -o a.toml",
};

bool all_trials() { return std::getenv("GLINT_ALL_TRIALS") != nullptr; }

template <class Work>
int milliseconds_of(const Work& work) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    return static_cast<int>(taken.count());
}

class Trials : public CliTest {
  public:
    Trials() {
        write("mesh.toml",
              "[material.m]\ntransparency = 0.5\n[[mesh]]\nfile = \"mesh.ply\"\nmaterial = \"m\"\n"
              "[[light]]\ntype = \"point\"\nposition = [3, -4, 5]\nintensity = 40\n");
        write("moving.toml", content("good.toml") +
                                 "[[animate]]\nkey = \"sphere.0.radius\"\nframes = [0, 4]\n"
                                 "values = [1, 2]\n");
        if (GLINT_EXR) {
            glint("good.toml -q -o one.exr");
            glint("good.toml -q --spp 2 -o two.exr");
        }
        before_ = files();
    }

    /// The files that are new since the start, which are then removed.
    std::map<std::string, std::string> take_outputs() const {
        std::map<std::string, std::string> outputs;
        for (const std::string& name : files())
            if (before_.count(name) == 0) outputs[name] = content(name);
        for (const auto& [name, _] : outputs) fs::remove(path(name));
        return outputs;
    }

    /// Outputs are whole or not there; temporary files stay only if allowed.
    void expect_whole(const std::map<std::string, std::string>& whole, bool may_leave_temporary) const {
        for (const auto& [name, text] : take_outputs()) {
            const auto reference = whole.find(name);
            const bool is_whole = reference != whole.end() && text == reference->second;
            EXPECT_TRUE(is_whole || (may_leave_temporary && name.starts_with(".glint-")))
                << name << " is left";
        }
    }

  private:
    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(path(""))) names.insert(entry.path().filename());
        return names;
    }

    std::set<std::string> before_;
};

TEST_F(Trials, EndWithCode5WhereAnAllocationFails) {
    if (sanitized) GTEST_SKIP() << "a sanitizer has its own allocator";
    const std::string preload = std::string("LD_PRELOAD=") + GLINT_FAIL_ALLOCATION;
    for (const std::string command : commands) {
        if (!GLINT_EXR && command.find(".exr") != std::string::npos) continue;
        Setting setting;
        setting.environment = {preload, "COUNT_ALLOCATIONS=count"};
        ASSERT_EQ(glint(command, setting).exit, 0) << command;
        auto whole = take_outputs();
        const long count = std::stol(whole.at("count"));
        whole.erase("count");
        ASSERT_GT(count, 100) << command;
        // The last ones are those of writing.
        const long writing = all_trials() ? 1 : count - 20;
        for (long number = 1; number <= count;
             number += number < writing ? std::min(count / 6, writing - number) : 1)
            for (const std::string mode : {"", "+"}) {
                setting.environment = {preload, "FAIL_ALLOCATION=" + std::to_string(number) + mode};
                const Outcome outcome = glint(command, setting);
                EXPECT_TRUE(outcome.exit == 0 || outcome.exit == 5)
                    << command << ", allocation " << number << mode << ": " << outcome.exit << "\n"
                    << outcome.err;
                expect_whole(whole, false);
            }
    }
}

TEST_F(Trials, LeaveNothingHalfWrittenWhenASignalComes) {
    std::mt19937 random(1);
    for (const std::string command : commands) {
        if (!GLINT_EXR && command.find(".exr") != std::string::npos) continue;
        const int duration = milliseconds_of([&] { ASSERT_EQ(glint(command).exit, 0) << command; });
        const auto whole = take_outputs();
        for (int i = 0; i < (all_trials() ? 50 : 4); ++i) {
            Setting setting;
            setting.signal = std::array{SIGINT, SIGTERM, SIGHUP, SIGKILL}[static_cast<std::size_t>(i) % 4];
            setting.signal_after = std::uniform_int_distribution(0, duration)(random);
            Outcome outcome;
            const int taken = milliseconds_of([&] { outcome = glint(command, setting); });
            // The suite measures no time: other programs may run beside it.
            EXPECT_TRUE(!all_trials() || taken < setting.signal_after + 2000) << command << ": " << taken;
            EXPECT_TRUE(outcome.exit == 0 || outcome.exit == 128 + setting.signal)
                << command << ": " << outcome.exit << "\n"
                << outcome.err;
            expect_whole(whole, setting.signal == SIGKILL);
        }
    }
}

} // namespace
} // namespace glint::test
