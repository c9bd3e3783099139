// Notices, errors, progress and help, in the order in which they cover each other.
#include "messages.h"

#include "activity.h"
#include "overlay.h"
#include "workbench.h"

#include <algorithm>
#include <utility>

namespace glint::viewer {
namespace {

constexpr double notice_seconds = 3;
/// Files that load faster need no progress: nobody could read it.
constexpr double silent_loading_seconds = 0.3;

} // namespace

void Messages::show(std::string text) {
    notice_ = std::move(text);
    notice_until_ = now() + notice_seconds;
}

bool Messages::is_showing() const { return now() < notice_until_; }

bool Messages::close_help() { return std::exchange(help_, false); }

void Messages::draw(Ui& ui, const Area& space, const WindowSize& window, Workbench& bench) {
    const bool has_scene = bench.description() != nullptr;
    if (!has_scene && bench.problems().empty() && !bench.status().busy)
        draw_hint(ui, space, "Drop a scene (.toml) or a mesh (.ply) here.");
    draw_errors(ui, space, bench.problems(),
                has_scene ? "The picture shows the scene as it was before." : "");
    draw_progress(ui, space, bench);
    const double left = notice_until_ - now();
    if (left > 0) draw_notice(ui, space, notice_, static_cast<float>(std::min(1.0, left * 2)));
    if (help_)
        help_ = draw_help(ui, {0, 0, static_cast<float>(window.width), static_cast<float>(window.height)});
}

void Messages::draw_progress(Ui& ui, const Area& space, Workbench& bench) {
    const LoadStatus& status = bench.status();
    if (!status.busy) loading_since_ = 0;
    if (status.busy && loading_since_ == 0) loading_since_ = now();
    if (!status.busy || now() - loading_since_ < silent_loading_seconds) return;
    if (draw_loading(ui, space, status.progress.activity, status.progress.fraction))
        bench.session().cancel_loading();
}

} // namespace glint::viewer
