// Frames of the animation by time, key and timeline.
#include "playback.h"

#include "activity.h"
#include "messages.h"
#include "workbench.h"

#include <algorithm>
#include <cmath>

namespace glint::viewer {

void Playback::toggle() {
    const bool has_animation = bench_.animation() != nullptr;
    playing_ = has_animation && !playing_;
    if (has_animation && !playing_) show(std::round(bench_.frame_shown()));
}

void Playback::step(int frames) {
    playing_ = false;
    if (bench_.animation() != nullptr) show(std::round(bench_.frame_shown()) + frames);
}

void Playback::seek(double frame) {
    playing_ = false;
    show(std::round(frame));
}

void Playback::advance(double seconds) {
    const Animation* animation = bench_.animation();
    if (animation == nullptr) playing_ = false;
    if (!playing_ || seconds <= 0) return;
    const double length = std::max(1, animation->last - animation->first + 1);
    const double elapsed = bench_.frame_shown() - animation->first + seconds * animation->fps;
    show(animation->first + std::fmod(elapsed, length));
}

void Playback::show(double frame) {
    const Animation& animation = *bench_.animation();
    messages_.guarded([&] { bench_.show_at(std::clamp<double>(frame, animation.first, animation.last)); });
    activity_.scene_changed();
}

void Playback::report(UiMap& map) const {
    map.state("playing", playing_);
    if (bench_.animation() != nullptr) map.state("frame", bench_.frame_shown());
}

} // namespace glint::viewer
