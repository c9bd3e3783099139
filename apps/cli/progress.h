#pragma once
// The progress of a render: a bar on a terminal, plain lines elsewhere, or JSON lines for render farms.

#include "console.h"

#include "glint/render.h"

#include <chrono>
#include <condition_variable>
#include <future>
#include <mutex>
#include <string>

namespace glint::cli {

enum class ProgressStyle { bar, plain, json, none };

/// `name` is "auto", "plain", "json" or "none".
ProgressStyle progress_style(const std::string& name);

/// Shows progress from its construction on: ten times a second as a bar, every ten seconds as plain lines,
/// once a second as JSON. A thread of its own does, since a tile may take minutes.
class ProgressMeter {
  public:
    /// `task` is what is rendered, "" or "frame 7 of 0..119"; JSON names it too.
    ProgressMeter(Console& console, ProgressStyle style, std::string task = {});
    ~ProgressMeter();
    ProgressMeter(const ProgressMeter&) = delete;
    ProgressMeter& operator=(const ProgressMeter&) = delete;

    void update(const Progress& progress);
    /// Erases the bar; for JSON, writes the last state.
    void finish();
    /// Fraction of the picture that is done.
    double fraction() const;

  private:
    void show_until_finished();
    void stop();
    void show();

    Console& console_;
    ProgressStyle style_;
    std::string task_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    mutable std::mutex mutex_; ///< of the state
    std::condition_variable finishes_;
    Progress state_;
    bool finished_ = false;
    std::future<void> shown_; ///< when all but the last state are
};

} // namespace glint::cli
