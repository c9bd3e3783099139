// Signal handlers.
#include "interrupt.h"

#include "glint/write_file.h"

#include <csignal>
#include <unistd.h>

namespace glint {
namespace {

constexpr unsigned seconds_to_stop = 1;

// Signal handlers can only reach globals, and may only access lock-free atomics.
CancelFlag cancelled{false};
std::atomic<bool> gentle{false};
std::atomic<int> last_signal{0};
static_assert(CancelFlag::is_always_lock_free && std::atomic<int>::is_always_lock_free);

void on_signal(int number) {
    const bool first = !cancelled.exchange(true);
    // The alarm only tells that the time after another signal is over.
    if (number != SIGALRM || first) last_signal = number;
    if (gentle && first) {
        alarm(seconds_to_stop);
        return;
    }
    remove_temporary_files();
    _exit(stopped_by());
}

} // namespace

void report_failing_writes() {
    std::signal(SIGPIPE, SIG_IGN);
    std::signal(SIGXFSZ, SIG_IGN);
}

void watch_signals() {
    struct sigaction action {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    action.sa_flags = SA_RESTART;
    for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGALRM}) {
        // Signals that the parent ignores (nohup, background jobs of scripts) stay ignored.
        struct sigaction before {};
        sigaction(number, nullptr, &before);
        if (before.sa_handler != SIG_IGN || number == SIGALRM) sigaction(number, &action, nullptr);
    }
}

void stop_gently() { gentle = true; }

void take_time() { alarm(0); }

const CancelFlag& cancel_flag() { return cancelled; }

int stopped_by() { return last_signal == 0 ? 0 : 128 + last_signal; }

} // namespace glint
