// Frames of the animation by time, key and timeline.
#include "playback.h"

#include "messages.h"
#include "scene_editor.h"

#include <algorithm>
#include <cmath>

namespace glint::viewer {

void Playback::toggle() {
    if (playing_)
        step(0);
    else
        playing_ = editor_.animation() != nullptr;
}

void Playback::step(int frames) {
    if (editor_.animation() != nullptr) seek(std::round(editor_.frame_shown()) + frames);
}

void Playback::seek(double frame) {
    playing_ = false;
    show(std::round(frame));
}

void Playback::advance(double seconds) {
    const Animation* animation = editor_.animation();
    if (animation == nullptr) playing_ = false;
    if (!playing_ || seconds <= 0) return;
    const double length = std::max(1, animation->last - animation->first + 1);
    const double elapsed = editor_.frame_shown() - animation->first + seconds * animation->fps;
    show(animation->first + std::fmod(elapsed, length));
}

void Playback::show(double frame) {
    const Animation& animation = *editor_.animation();
    messages_.guarded([&] { editor_.show_at(std::clamp<double>(frame, animation.first, animation.last)); });
}

void Playback::report(UiMap& map) const {
    map.state("playing", playing_);
    if (editor_.animation() != nullptr) map.state("frame", editor_.frame_shown());
}

} // namespace glint::viewer
