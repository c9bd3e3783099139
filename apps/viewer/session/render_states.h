#pragma once
// The state machine of the renderer's thread, without threads or locks of its own.
//
// state      | request_changed()    | tone_changed()       | finish_work()       | close()
// -----------+----------------------+----------------------+---------------------+------------------
// idle       | -> first_pass        | -> refining          |                     | -> closed
// first_pass | -> first_pass again  | -> refining, shown   | all views finished: | cancel, -> closed
//            | after this one       | again after the pass | -> idle             |
//            |                      |                      | else: -> refining   |
// refining   | cancel,              | shown again          | all views finished: | cancel, -> closed
//            | -> first_pass        | after the slice      | -> idle             |
//            |                      |                      | else: -> refining   |
// closed     |                      |                      |                     |
//
// idle       : every view is finished or none is requested; the thread sleeps.
// first_pass : the first, coarse pass of each view. A newer request does not cancel it: otherwise nothing
//              would be seen while the camera moves.
// refining   : a slice of some 40 ms makes every view better. From idle, it shows them in another tone.
// closed     : the thread ends.

#include <utility>

namespace glint::viewer {

class RenderStates {
  public:
    enum class State { idle, first_pass, refining, closed };

    // Events of the renderer's owner.
    void request_changed() { request_pending_ = true; }
    void tone_changed() { tone_pending_ = true; }
    void close() { state_ = State::closed; }

    // The renderer's thread.

    /// False: sleep until an event.
    bool has_work() const { return state_ != State::idle || request_pending_ || tone_pending_; }
    /// The work to do next: first_pass (take the request as it is now), refining or closed. Needs has_work().
    State begin_work() {
        if (state_ != State::closed)
            state_ = std::exchange(request_pending_, false) ? State::first_pass : State::refining;
        return state_;
    }
    /// Is every view to be shown again although it may have no better picture? Once for each change of tone.
    bool take_tone_change() { return std::exchange(tone_pending_, false); }
    /// The work is done or was cancelled.
    void finish_work(bool views_finished) {
        if (state_ != State::closed) state_ = views_finished ? State::idle : State::refining;
    }

    /// Is the work under way to be given up?
    bool must_cancel() const {
        return state_ == State::closed || (state_ == State::refining && request_pending_);
    }
    /// Has the request changed since the thread took it?
    bool is_request_pending() const { return request_pending_; }
    State state() const { return state_; }

  private:
    State state_ = State::idle;
    bool request_pending_ = false;
    bool tone_pending_ = false;
};

} // namespace glint::viewer
