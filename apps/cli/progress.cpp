// Bar, plain lines and JSON lines.
#include "progress.h"

#include "text.h"

#include <fmt/format.h>

#include <cmath>
#include <system_error>

namespace glint::cli {
namespace {

constexpr int bar_width = 30;

/// Between two updates.
std::chrono::milliseconds interval(ProgressStyle style) {
    return std::chrono::milliseconds(style == ProgressStyle::bar     ? 100
                                     : style == ProgressStyle::plain ? 10'000
                                                                     : 1'000);
}

} // namespace

ProgressStyle progress_style(const std::string& name) {
    if (name == "json") return ProgressStyle::json;
    if (name == "none") return ProgressStyle::none;
    return name == "auto" && stderr_is_terminal() ? ProgressStyle::bar : ProgressStyle::plain;
}

ProgressMeter::ProgressMeter(Console& console, ProgressStyle style, std::string task)
    : console_(console), style_(style), task_(std::move(task)) {
    if (style_ == ProgressStyle::none) return;
    try {
        shown_ = std::async(std::launch::async, [this] { show_until_finished(); });
    } catch (const std::system_error&) {
        // Too few threads are allowed: only the end is shown.
    }
}

ProgressMeter::~ProgressMeter() { stop(); }

/// Short renders show no plain line: the first one comes after an interval.
void ProgressMeter::show_until_finished() {
    std::unique_lock lock(mutex_);
    if (style_ != ProgressStyle::plain && !finished_) show();
    while (!finishes_.wait_for(lock, interval(style_), [this] { return finished_; })) show();
}

void ProgressMeter::update(const Progress& progress) {
    const std::lock_guard lock(mutex_);
    state_ = progress;
}

void ProgressMeter::stop() {
    {
        const std::lock_guard lock(mutex_);
        finished_ = true;
    }
    finishes_.notify_all();
    if (shown_.valid()) shown_.wait();
}

void ProgressMeter::finish() {
    stop();
    if (style_ == ProgressStyle::bar) console_.status("");
    if (style_ == ProgressStyle::json) show();
}

double ProgressMeter::fraction() const {
    const std::lock_guard lock(mutex_);
    return state_.fraction;
}

void ProgressMeter::show() {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    const double done = state_.fraction;
    const double left = elapsed.count() * (1 - done) / done;
    if (style_ == ProgressStyle::json) {
        // Explicitly asked for: -q does not hide it.
        console_.always(fmt::format(
            R"({{"event":"progress",{}"fraction":{:.6f},"tiles_done":{},"tiles":{},"rays":{},"seconds":{:.3f},)"
            R"("seconds_left":{}}})",
            task_.empty() ? "" : fmt::format("\"task\":\"{}\",", task_), done, state_.tiles_done,
            state_.tiles, state_.rays, elapsed.count(), done > 0 ? fmt::format("{:.3f}", left) : "null"));
        return;
    }
    const std::string rate = state_.rays > 0 ? ray_rate(state_.rays, state_.seconds) + "  " : "";
    const std::string state = fmt::format("{:3.0f} %  {}{}", std::floor(done * 100), rate,
                                          done > 0 ? whole_duration(left) + " left" : "");
    const std::string task = task_.empty() ? "" : task_ + " ";
    if (style_ == ProgressStyle::plain) return console_.line("rendering " + task + state);
    const int filled = static_cast<int>(done * bar_width);
    console_.status(fmt::format("{}[{:#<{}}{:{}}] {}", task, "", filled, "", bar_width - filled, state));
}

} // namespace glint::cli
