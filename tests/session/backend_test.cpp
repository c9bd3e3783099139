// Who draws: the CPU or a graphics card, and what becomes of pictures when that changes. The card is one of
// the tests' own, so that faults come when they are wanted, and no driver's threads hide ours.

#include "session/renderer.h"

#include "patience.h"
#include "scene_kit.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace glint::viewer {
namespace {

/// A card that fails when it is told to.
struct Card {
    std::atomic<int> made{0};
    std::atomic<int> alive{0};
    std::atomic<int> on_other_threads{0};
    std::atomic<bool> is_there{true};
    std::atomic<bool> is_lost{false};     ///< in advance()
    std::atomic<bool> is_full{false};     ///< in start()
    std::atomic<bool> cannot_show{false}; ///< in show()

    void fail_if(bool so, const char* why) const {
        if (so) throw Error(ErrorKind::device, why);
    }
    PainterMaker maker();
};

class CardPainter : public Painter {
  public:
    explicit CardPainter(Card& card) : card_(card), thread_(std::this_thread::get_id()), picture_(1) {
        ++card_.made;
        ++card_.alive;
    }
    ~CardPainter() override {
        look_at_thread();
        --card_.alive;
    }

    void start(const Scene& scene, const ProgressiveOptions& options) override {
        look_at_thread();
        card_.fail_if(card_.is_full, "the card is full");
        picture_.start(scene, options);
    }
    bool advance(double seconds) override {
        look_at_thread();
        card_.fail_if(card_.is_lost, "the card is lost\nand this is its log");
        return picture_.advance(seconds);
    }
    const Refinement& reached() const override { return picture_.reached(); }
    void show(Frame& frame) override {
        card_.fail_if(card_.cannot_show, "the card has no room for pictures");
        frame.image = picture_.image();
        frame.width = frame.image.width;
        frame.height = frame.image.height;
    }
    std::string device() const override { return "card"; }

  private:
    void look_at_thread() const {
        if (std::this_thread::get_id() != thread_) ++card_.on_other_threads;
    }

    Card& card_;
    std::thread::id thread_;
    Progressive picture_;
};

PainterMaker Card::maker() {
    return [this]() -> std::unique_ptr<Painter> {
        fail_if(!is_there, "there is no card");
        return std::make_unique<CardPainter>(*this);
    };
}

/// A ball on a bright ground: no pixel of its pictures is black.
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
    // So short a time makes every first picture a coarse one.
    Backend() : renderer({.threads = 2, .first_picture_seconds = 1e-6, .changed = {}}) {}
    ~Backend() override { EXPECT_EQ(card.on_other_threads, 0); }

    void show(const SceneDescription& description) {
        scene = freeze(description);
        renderer.set_view(scene->camera(), 48, 36);
        renderer.set_scene(0, *scene);
    }
    std::shared_ptr<const Frame> finished(const std::string& device) const {
        std::shared_ptr<const Frame> frame;
        EXPECT_TRUE(comes_true([&] {
            frame = renderer.latest(0);
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
    ASSERT_TRUE(comes_true([&] { return renderer.latest(0) && renderer.latest(0)->reached.step == 1; }));
    std::atomic<bool> done{false};
    std::atomic<int> black{0};
    std::atomic<int> coarse{0};
    std::atomic<int> frames{0};
    std::thread window([&] {
        std::uint64_t number = 0;
        while (!done) {
            const auto frame = renderer.latest(0);
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
        renderer.set_backend(i % 2 == 0 ? card.maker() : PainterMaker());
        std::this_thread::sleep_for(std::chrono::milliseconds(i % 7));
        const std::string device = i % 2 == 0 ? "card" : "";
        if (i % 25 == 24) {
            EXPECT_TRUE(comes_true([&] { return renderer.latest(0)->device == device; }));
        }
    }
    renderer.set_backend(card.maker());
    EXPECT_TRUE(comes_true([&] { return renderer.latest(0)->device == "card"; }));
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
    options.show = Aspect::normal;
    const Image numbers = render(with_view(*scene, scene->camera(), 48, 36), options).image;
    renderer.set_show(0, Aspect::normal);
    ASSERT_TRUE(comes_true([&] { return renderer.latest(0)->show == Aspect::normal; }));
    const auto normals = finished("card");
    EXPECT_EQ(normals->why_cpu, "");
    EXPECT_EQ(picture_hash(normals->image), picture_hash(visible(numbers, Aspect::normal, *scene)));
}

TEST_F(Backend, AfterAFaultTheCpuDrawsUntilThereIsAReasonToTryAgain) {
    card.is_there = false;
    renderer.set_backend(card.maker());
    show(ball(2));
    EXPECT_EQ(finished("")->why_cpu, "there is no card");
    EXPECT_EQ(picture_hash(finished("")->image), expected());

    // Another camera is none; another scene is.
    card.is_there = true;
    CameraDescription camera = scene->camera();
    camera.eye.x += 0.5;
    const std::uint64_t number = renderer.latest(0)->number;
    renderer.set_view(camera, 48, 36);
    ASSERT_TRUE(comes_true([&] { return renderer.latest(0)->number > number; }));
    EXPECT_EQ(finished("")->why_cpu, "there is no card");
    EXPECT_EQ(card.made, 0);
    show(ball(3));
    EXPECT_EQ(finished("card")->why_cpu, "");
    EXPECT_EQ(card.made, 1);
}

TEST_F(Backend, ACardThatFailsInAnyStateIsLetGo) {
    renderer.set_backend(card.maker());
    show(ball(512)); // not finished before the card is lost
    ASSERT_TRUE(comes_true([&] { return renderer.latest(0) && renderer.latest(0)->device == "card"; }));
    card.is_lost = true;
    EXPECT_EQ(finished("")->why_cpu, "the card is lost\nand this is its log");
    EXPECT_EQ(picture_hash(finished("")->image), expected());
    EXPECT_EQ(card.alive, 0);
    card.is_lost = false;
    for (std::atomic<bool>* fault : {&card.is_full, &card.cannot_show}) {
        *fault = true;
        renderer.set_backend(card.maker());
        ASSERT_TRUE(comes_true([&] { return !renderer.latest(0)->why_cpu.empty() && card.alive == 0; }));
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
        ASSERT_TRUE(comes_true([&] { return picture_hash(finished("card")->image) == expected(); }));
        std::uint64_t number = renderer.latest(0)->number;
        card.cannot_show = true;
        renderer.set_tone(same_view ? View::raw : View::srgb);
        int coarse = 0;
        EXPECT_TRUE(comes_true([&] {
            const auto frame = renderer.latest(0);
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

TEST_F(Backend, BothPlacesAreDrawnByTheCard) {
    renderer.set_backend(card.maker());
    show(ball(2));
    renderer.set_scene(1, freeze(ball(3)));
    finished("card");
    ASSERT_TRUE(comes_true([&] {
        const auto frame = renderer.latest(1);
        return frame && frame->reached.finished && frame->device == "card";
    }));
    EXPECT_EQ(card.made, 2);
    renderer.set_scene(1, std::nullopt);
    renderer.set_backend({});
    finished("");
}

} // namespace
} // namespace glint::viewer
