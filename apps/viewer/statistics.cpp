// Collects frame times and prints their histograms.
#include "statistics.h"

#include "activity.h"

namespace glint::viewer {
namespace {

/// The camera counts as moving for this long after its last movement.
constexpr double moving_seconds = 0.1;
/// Longer pauses between pictures are not part of a movement.
constexpr double max_pause = 0.5;

} // namespace

void Statistics::frame_drawn(double seconds, double last_move) {
    frames_.add(seconds);
    if (now() - seconds - last_move < moving_seconds) moving_frames_.add(seconds);
}

void Statistics::picture_shown(double last_move) {
    const double time = now();
    if (time - last_move < moving_seconds && time - last_picture_ < max_pause)
        pictures_.add(time - last_picture_);
    last_picture_ = time;
}

std::string Statistics::text() const {
    std::string text = "window: " + frames_.summary() + "\n" + frames_.histogram();
    if (moving_frames_.count() > 0)
        text +=
            "window while the camera moved: " + moving_frames_.summary() + "\n" + moving_frames_.histogram();
    if (pictures_.count() > 0)
        text += "pictures while the camera moved: " + pictures_.summary() + "\n" + pictures_.histogram();
    return text;
}

} // namespace glint::viewer
