// The transitions of the renderer's state machine.
#include "render_states.h"

#include <utility>

namespace glint::viewer {

bool RenderStates::has_work() const { return state_ != State::idle || request_pending_ || tone_pending_; }

RenderStates::State RenderStates::begin_work() {
    if (state_ == State::closed) return state_;
    state_ = std::exchange(request_pending_, false) ? State::first_pass : State::refining;
    return state_;
}

bool RenderStates::take_tone_change() { return std::exchange(tone_pending_, false); }

void RenderStates::finish_work(bool views_finished) {
    if (state_ != State::closed) state_ = views_finished ? State::idle : State::refining;
}

bool RenderStates::must_cancel() const {
    return state_ == State::closed || (state_ == State::refining && request_pending_);
}

} // namespace glint::viewer
