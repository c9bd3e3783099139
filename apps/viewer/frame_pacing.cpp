// The rules by which frames are drawn.
#include "frame_pacing.h"

#include "session/clock.h"

#include <algorithm>

namespace glint::viewer {
namespace {

/// Swapping buffers waits for the screen, at 60 Hz mostly. Where it does not wait, this limits the rate
/// however fast the mouse reports.
constexpr double frame_seconds = 1.0 / 70;
/// While the camera moves, a frame waits so long for the picture that shows it: drawing the old picture once
/// more would delay the new one.
constexpr double picture_wait_seconds = 1.0 / 30;
/// Dear ImGui reacts to input a frame or two later.
constexpr int frames_after_input = 3;
constexpr double max_wait_seconds = 0.5;
/// Without input for `calm_after`, refined pictures are shown at this interval only.
constexpr double calm_after = 0.5;
constexpr double calm_seconds = 0.1;
constexpr double max_frame_seconds = 0.1;

} // namespace

FramePacing::FramePacing() : frames_to_draw_(frames_after_input), last_input_(now()) {}

void FramePacing::add_input() { frames_to_draw_ = frames_after_input; }

void FramePacing::add_wake() {
    add_input();
    last_input_ = now();
}

bool FramePacing::is_due(double time, bool animating, double last_move) {
    const bool calm =
        time - std::max(last_input_, last_move) > calm_after && time - last_frame_ < calm_seconds;
    if (animating || (has_news_ && !calm)) frames_to_draw_ = std::max(frames_to_draw_, 1);
    const bool awaits_picture = !has_news_ && time - last_move < calm_seconds;
    due_ = last_frame_ + (awaits_picture ? picture_wait_seconds : frame_seconds);
    return frames_to_draw_ > 0 && time >= due_;
}

double FramePacing::begin_frame(double time) {
    const double seconds = last_frame_ > 0 ? std::min(time - last_frame_, max_frame_seconds) : 0;
    last_frame_ = time;
    return seconds;
}

void FramePacing::end_frame() {
    --frames_to_draw_;
    has_news_ = false;
}

double FramePacing::wait_seconds(bool animating) const {
    if (frames_to_draw_ > 0 || animating)
        return std::max(std::max(due_, last_frame_ + frame_seconds) - now(), 0.0);
    return has_news_ ? calm_seconds : max_wait_seconds;
}

} // namespace glint::viewer
