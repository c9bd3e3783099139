// Switching between CPU and GPU, and the fall-back after faults of the GPU. The GPU is simulated, so that
// faults occur on demand and a driver's threads do not hide ours.

#include "session/renderer.h"

#include "scene_kit.h"
#include "wait_until.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace glint::viewer {
namespace {

/// A simulated GPU that fails on demand.
struct Card {
    std::atomic<int> made{0};
    std::atomic<int> alive{0};
    std::atomic<int> on_other_threads{0};
    std::atomic<bool> is_there{true};
    std::atomic<bool> is_lost{false};     ///< advance() fails
    std::atomic<bool> is_full{false};     ///< start() fails
    std::atomic<bool> cannot_show{false}; ///< copy_to() fails

    void fail_if(bool so, const char* why) const {
        if (so) throw Error(ErrorKind::device, why);
    }
    BackendFactory maker();
};

class CardBackend : public Backend {
  public:
    explicit CardBackend(Card& card) : card_(card), thread_(std::this_thread::get_id()), picture_(1) {
        ++card_.made;
        ++card_.alive;
    }
    ~CardBackend() override {
        check_thread();
        --card_.alive;
    }

    void start(const Scene& scene, const ProgressiveOptions& options) override {
        check_thread();
        card_.fail_if(card_.is_full, "the card is full");
        picture_.start(scene, options);
    }
    bool advance(double seconds) override {
        check_thread();
        card_.fail_if(card_.is_lost, "the card is lost\nand this is its log");
        return picture_.advance(seconds);
    }
    const Refinement& reached() const override { return picture_.reached(); }
    void copy_to(RenderedFrame& frame) override {
        card_.fail_if(card_.cannot_show, "the card has no room for pictures");
        frame.image = picture_.image();
        frame.width = frame.image.width;
        frame.height = frame.image.height;
    }
    std::string device() const override { return "card"; }

  private:
    void check_thread() const {
        if (std::this_thread::get_id() != thread_) ++card_.on_other_threads;
    }

    Card& card_;
    std::thread::id thread_;
    Progressive picture_;
};

BackendFactory Card::maker() {
    return [this]() -> std::unique_ptr<Backend> {
        fail_if(!is_there, "there is no card");
        return std::make_unique<CardBackend>(*this);
    };
}

/// A ball in front of a bright background: no pixel is black.
SceneDescription ball(int samples) {
    SceneDescription scene = kit::empty_scene(Vec3(0, -6, 1), Vec3(0, 6, -1), 48, 40);
    scene.render.spp = samples;
    scene.render.filter = PixelFilter::box; // it never gives less than was seen
    scene.render.background = Vec3(0.4, 0.5, 0.9);
    Material red;
    red.emission = Vec3(0.3, 0.1, 0.1);
    kit::add(scene, SphereShape{Vec3(0), 1}, red);
    return scene;
}

class Backend : public testing::Test {
  protected:
    // Too short a time: every first pass is coarse.
    Backend() : renderer({.threads = 2, .first_picture_seconds = 1e-6, .changed = {}}) {}
    ~Backend() override { EXPECT_EQ(card.on_other_threads, 0); }

    void show(const SceneDescription& description) {
        scene = build_scene(description);
        renderer.set_camera(scene->camera(), 48, 36);
        renderer.set_scene(ViewSlot::main, *scene);
    }
    std::shared_ptr<const RenderedFrame> finished(const std::string& device) const {
        std::shared_ptr<const RenderedFrame> frame;
        EXPECT_TRUE(wait_until([&] {
            frame = renderer.latest(ViewSlot::main);
            return frame && frame->reached.finished && frame->device == device;
        })) << "not finished by "
            << (device.empty() ? "the CPU" : device);
        return frame;
    }
    std::string expected() const {
        return picture_hash(render(with_view(*scene, scene->camera(), 48, 36)).image);
    }

    Card card;
    std::optional<Scene> scene;
    SessionRenderer renderer; ///< ends before the card
};

TEST_F(Backend, TheCardDrawsWhenItIsToldTo) {
    show(ball(4));
    EXPECT_EQ(picture_hash(finished("")->image), expected());
    renderer.set_backend(card.maker());
    EXPECT_EQ(picture_hash(finished("card")->image), expected());
    renderer.set_backend({});
    EXPECT_EQ(picture_hash(finished("")->image), expected());
    renderer.set_backend(card.maker());
    finished("card");
    EXPECT_EQ(card.made, 1) << "it is kept meanwhile";
}

TEST_F(Backend, SwitchingWhileItRendersShowsNothingButPictures) {
    show(ball(4096));
    ASSERT_TRUE(wait_until([&] {
        return renderer.latest(ViewSlot::main) && renderer.latest(ViewSlot::main)->reached.step == 1;
    }));
    std::atomic<bool> done{false};
    std::atomic<int> black{0};
    std::atomic<int> coarse{0};
    std::atomic<int> frames{0};
    std::thread window([&] {
        std::uint64_t number = 0;
        while (!done) {
            const auto frame = renderer.latest(ViewSlot::main);
            if (!frame || frame->width != 48 || frame->height != 36) ++black;
            if (frame && frame->number != number) {
                ++frames;
                number = frame->number;
                for (const float value : frame->image.pixels) black += !(value > 0.05f);
                coarse += frame->reached.step > 1;
            }
            std::this_thread::sleep_for(std::chrono::microseconds(200));
        }
    });
    for (int i = 0; i < 200; ++i) {
        renderer.set_backend(i % 2 == 0 ? card.maker() : BackendFactory());
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 7));
        const std::string device = i % 2 == 0 ? "card" : "";
        if (i % 25 == 24) {
            EXPECT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::main)->device == device; }));
        }
    }
    renderer.set_backend(card.maker());
    EXPECT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::main)->device == "card"; }));
    done = true;
    window.join();
    EXPECT_EQ(black, 0);
    EXPECT_EQ(coarse, 0);
    EXPECT_GT(frames, 1);
    EXPECT_EQ(card.alive, 1);
}

TEST_F(Backend, TheCardDrawsEveryView) {
    renderer.set_backend(card.maker());
    show(ball(2));
    finished("card");
    RenderOptions options;
    options.show = Aov::normal;
    const Image numbers = render(with_view(*scene, scene->camera(), 48, 36), options).image;
    renderer.set_show(ViewSlot::main, Aov::normal);
    ASSERT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::main)->show == Aov::normal; }));
    const auto normals = finished("card");
    EXPECT_EQ(normals->why_cpu, "");
    EXPECT_EQ(picture_hash(normals->image), picture_hash(visible(numbers, Aov::normal, *scene)));
}

TEST_F(Backend, AfterAFaultTheCpuDrawsUntilThereIsAReasonToTryAgain) {
    card.is_there = false;
    renderer.set_backend(card.maker());
    show(ball(2));
    EXPECT_EQ(finished("")->why_cpu, "there is no card");
    EXPECT_EQ(picture_hash(finished("")->image), expected());

    // Another camera is no reason, another scene is one.
    card.is_there = true;
    CameraDescription camera = scene->camera();
    camera.eye.x += 0.5;
    const std::uint64_t number = renderer.latest(ViewSlot::main)->number;
    renderer.set_camera(camera, 48, 36);
    ASSERT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::main)->number > number; }));
    EXPECT_EQ(finished("")->why_cpu, "there is no card");
    EXPECT_EQ(card.made, 0);
    show(ball(3));
    EXPECT_EQ(finished("card")->why_cpu, "");
    EXPECT_EQ(card.made, 1);
}

TEST_F(Backend, ACardThatFailsInAnyStateIsLetGo) {
    renderer.set_backend(card.maker());
    show(ball(512)); // not finished before the card is lost
    ASSERT_TRUE(wait_until([&] {
        return renderer.latest(ViewSlot::main) && renderer.latest(ViewSlot::main)->device == "card";
    }));
    card.is_lost = true;
    EXPECT_EQ(finished("")->why_cpu, "the card is lost\nand this is its log");
    EXPECT_EQ(picture_hash(finished("")->image), expected());
    EXPECT_EQ(card.alive, 0);
    card.is_lost = false;
    for (std::atomic<bool>* fault : {&card.is_full, &card.cannot_show}) {
        *fault = true;
        renderer.set_backend(card.maker());
        ASSERT_TRUE(
            wait_until([&] { return !renderer.latest(ViewSlot::main)->why_cpu.empty() && card.alive == 0; }));
        EXPECT_EQ(picture_hash(finished("")->image), expected());
        *fault = false;
        renderer.set_backend(card.maker());
        EXPECT_EQ(picture_hash(finished("card")->image), expected());
    }
}

TEST_F(Backend, ACardThatFailsAfterItsLastPassLeavesAFinishedPicture) {
    renderer.set_backend(card.maker());
    show(ball(2));
    finished("card");
    card.cannot_show = true;
    renderer.set_tone(View::raw); // its picture is to be shown once more
    const auto frame = finished("");
    EXPECT_EQ(frame->why_cpu, "the card has no room for pictures");
    EXPECT_EQ(picture_hash(frame->image), expected());
    EXPECT_EQ(card.alive, 0);
}

TEST_F(Backend, AFaultMakesNothingCoarserThanItWas) {
    show(ball(2));
    finished("");
    for (const bool same_view : {true, false}) {
        renderer.set_backend(card.maker());
        if (!same_view) show(ball(3));
        // The card's picture of the scene before may be there already.
        ASSERT_TRUE(wait_until([&] { return picture_hash(finished("card")->image) == expected(); }));
        std::uint64_t number = renderer.latest(ViewSlot::main)->number;
        card.cannot_show = true;
        renderer.set_tone(same_view ? View::raw : View::srgb);
        int coarse = 0;
        EXPECT_TRUE(wait_until([&] {
            const auto frame = renderer.latest(ViewSlot::main);
            if (frame->number != number) coarse += frame->reached.step > 1;
            number = frame->number;
            return frame->reached.finished && frame->device.empty();
        }));
        EXPECT_EQ(coarse, 0);
        EXPECT_EQ(finished("")->why_cpu, "the card has no room for pictures");
        EXPECT_EQ(picture_hash(finished("")->image), expected());
        card.cannot_show = false;
    }
}

TEST_F(Backend, TheCardRendersBothViews) {
    renderer.set_backend(card.maker());
    show(ball(2));
    renderer.set_scene(ViewSlot::reference, build_scene(ball(3)));
    finished("card");
    ASSERT_TRUE(wait_until([&] {
        const auto frame = renderer.latest(ViewSlot::reference);
        return frame && frame->reached.finished && frame->device == "card";
    }));
    EXPECT_EQ(card.made, 2);
    renderer.set_scene(ViewSlot::reference, std::nullopt);
    renderer.set_backend({});
    finished("");
}

TEST_F(Backend, ARemovedSceneLeavesNoFrameBehind) {
    show(ball(4096));
    const Scene other = build_scene(ball(4096));
    for (int i = 0; i < 20; ++i) {
        renderer.set_scene(ViewSlot::reference, other);
        ASSERT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::reference) != nullptr; }));
        renderer.set_scene(ViewSlot::reference, std::nullopt);
        // Frames of the first pass after it come from the newer request.
        const std::uint64_t number = renderer.latest(ViewSlot::main)->number;
        ASSERT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::main)->number > number + 2; }));
        ASSERT_EQ(renderer.latest(ViewSlot::reference), nullptr);
    }
}

TEST_F(Backend, WithoutAnySceneNothingIsRendered) {
    show(ball(4096));
    ASSERT_TRUE(wait_until([&] { return renderer.latest(ViewSlot::main) != nullptr; }));
    renderer.set_scene(ViewSlot::main, std::nullopt);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_EQ(renderer.latest(ViewSlot::main), nullptr);
    show(ball(2));
    EXPECT_EQ(picture_hash(finished("")->image), expected());
}

} // namespace
} // namespace glint::viewer
