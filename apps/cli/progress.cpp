// Bar, plain lines and JSON lines.
#include "progress.h"

#include "text.h"

#include <fmt/format.h>

#include <cmath>

namespace glint::cli {
namespace {

constexpr int bar_width = 30;

/// Seconds between two updates.
double interval(ProgressStyle style) {
    return style == ProgressStyle::bar     ? 0.1
           : style == ProgressStyle::plain ? 10
           : style == ProgressStyle::json  ? 1
                                           : INFINITY;
}

} // namespace

ProgressStyle progress_style(const std::string& name) {
    if (name == "json") return ProgressStyle::json;
    if (name == "none") return ProgressStyle::none;
    return name == "auto" && stderr_is_terminal() ? ProgressStyle::bar : ProgressStyle::plain;
}

// Short renders show no plain line: the first one comes after an interval.
ProgressMeter::ProgressMeter(Console& console, ProgressStyle style, std::string task)
    : console_(console), style_(style), task_(std::move(task)),
      next_show_(style == ProgressStyle::plain ? interval(style) : 0) {}

void ProgressMeter::update(const Progress& progress) {
    last_ = progress;
    if (progress.seconds < next_show_ || style_ == ProgressStyle::none) return;
    next_show_ = progress.seconds + interval(style_);
    show();
}

void ProgressMeter::finish() {
    if (style_ == ProgressStyle::bar) console_.status("");
    if (style_ == ProgressStyle::json) show();
}

double ProgressMeter::fraction() const {
    return last_.tiles == 0 ? 0 : static_cast<double>(last_.tiles_done) / static_cast<double>(last_.tiles);
}

void ProgressMeter::show() {
    const double done = fraction();
    const double left = done > 0 ? last_.seconds * (1 - done) / done : 0;
    if (style_ == ProgressStyle::json) {
        // Explicitly asked for: -q does not hide it.
        console_.always(
            fmt::format(R"({{"event":"progress",{}"tiles_done":{},"tiles":{},"rays":{},"seconds":{:.3f},)"
                        R"("seconds_left":{:.3f}}})",
                        task_.empty() ? "" : fmt::format("\"task\":\"{}\",", task_), last_.tiles_done,
                        last_.tiles, last_.rays, last_.seconds, left));
        return;
    }
    const std::string rate = last_.rays > 0 ? ray_rate(last_.rays, last_.seconds) + "  " : "";
    const std::string state =
        fmt::format("{:3.0f} %  {}{} left", std::floor(done * 100), rate, whole_duration(left));
    const std::string task = task_.empty() ? "" : task_ + " ";
    if (style_ == ProgressStyle::plain) return console_.line("rendering " + task + state);
    const int filled = static_cast<int>(done * bar_width);
    console_.status(fmt::format("{}[{:#<{}}{:{}}] {}", task, "", filled, "", bar_width - filled, state));
}

} // namespace glint::cli
