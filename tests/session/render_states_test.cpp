// Every transition of the renderer's state machine.

#include "session/render_states.h"

#include <gtest/gtest.h>

namespace glint::viewer {
namespace {

using State = RenderStates::State;

RenderStates in_first_pass() {
    RenderStates states;
    states.request_changed();
    states.begin_work();
    return states;
}

RenderStates in_refining() {
    RenderStates states = in_first_pass();
    states.finish_work(false);
    states.begin_work();
    return states;
}

TEST(RenderStates, IdleSleepsUntilAnEvent) {
    RenderStates states;
    EXPECT_EQ(states.state(), State::idle);
    EXPECT_FALSE(states.has_work());
    EXPECT_FALSE(states.must_cancel());
    states.request_changed();
    EXPECT_TRUE(states.has_work());
    EXPECT_FALSE(states.must_cancel()) << "nothing is under way";
    EXPECT_EQ(states.begin_work(), State::first_pass);
    EXPECT_FALSE(states.is_request_pending());
}

TEST(RenderStates, IdleShowsAFinishedPictureInAnotherToneOnce) {
    RenderStates states;
    states.tone_changed();
    EXPECT_TRUE(states.has_work());
    EXPECT_EQ(states.begin_work(), State::refining);
    EXPECT_TRUE(states.take_tone_change());
    states.finish_work(true);
    EXPECT_EQ(states.state(), State::idle);
    EXPECT_FALSE(states.has_work());
    EXPECT_FALSE(states.take_tone_change());
}

TEST(RenderStates, AFirstPassIsNotCancelledByANewerRequest) {
    RenderStates states = in_first_pass();
    states.request_changed();
    EXPECT_FALSE(states.must_cancel());
    states.finish_work(false);
    EXPECT_TRUE(states.has_work());
    EXPECT_EQ(states.begin_work(), State::first_pass) << "that of the newer request";
    states.finish_work(false);
    EXPECT_EQ(states.begin_work(), State::refining);
}

TEST(RenderStates, AToneChangedDuringTheFirstPassIsShownAfterIt) {
    RenderStates states = in_first_pass();
    states.tone_changed();
    EXPECT_FALSE(states.must_cancel());
    states.finish_work(true);
    EXPECT_TRUE(states.has_work());
    EXPECT_EQ(states.begin_work(), State::refining);
    EXPECT_TRUE(states.take_tone_change());
}

TEST(RenderStates, AFinishedFirstPassGoesToSleep) {
    RenderStates states = in_first_pass();
    states.finish_work(true);
    EXPECT_EQ(states.state(), State::idle);
    EXPECT_FALSE(states.has_work());
}

TEST(RenderStates, RefiningGoesOnUntilAllViewsAreFinished) {
    RenderStates states = in_refining();
    EXPECT_FALSE(states.must_cancel());
    states.finish_work(false);
    EXPECT_TRUE(states.has_work());
    EXPECT_EQ(states.begin_work(), State::refining);
    EXPECT_FALSE(states.take_tone_change());
    states.finish_work(true);
    EXPECT_FALSE(states.has_work());
}

TEST(RenderStates, ANewerRequestCancelsRefining) {
    RenderStates states = in_refining();
    states.tone_changed();
    EXPECT_FALSE(states.must_cancel());
    states.request_changed();
    EXPECT_TRUE(states.must_cancel());
    states.finish_work(false);
    EXPECT_TRUE(states.must_cancel()) << "until the request is taken";
    EXPECT_EQ(states.begin_work(), State::first_pass);
    EXPECT_FALSE(states.must_cancel());
    // A view that a request leaves as it is may be the last one to finish.
    RenderStates finished = in_refining();
    finished.request_changed();
    finished.finish_work(true);
    EXPECT_EQ(finished.begin_work(), State::first_pass);
}

TEST(RenderStates, ClosingCancelsAndIsFinal) {
    for (RenderStates states : {RenderStates(), in_first_pass(), in_refining()}) {
        states.close();
        EXPECT_TRUE(states.must_cancel());
        EXPECT_TRUE(states.has_work());
        states.finish_work(false);
        states.request_changed();
        states.tone_changed();
        EXPECT_EQ(states.begin_work(), State::closed);
        EXPECT_TRUE(states.must_cancel());
    }
}

} // namespace
} // namespace glint::viewer
