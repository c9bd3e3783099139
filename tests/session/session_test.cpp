// The session: files read, watched and edited in the background, and the resulting pictures.

#include "session/session.h"

#include "../kit/temporary_folder.h"

#include "scene_kit.h"
#include "wait_until.h"

#include "glint/mesh_files.h"
#include "glint/pick.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <thread>

namespace glint::viewer {
namespace {

namespace fs = std::filesystem;
const std::string ball_text = R"([camera]
eye = [0, -6, 0]
direction = [0, 1, 0]
[render]
spp = 2
[material.red]
color = [1, 0, 0]
[[sphere]]
name = "ball"
center = [0, 0, 0]
radius = 1
material = "red"
[[light]]
type = "point"
position = [3, -5, 4]
intensity = 40
)";

class SessionTest : public testing::Test {
  protected:
    /// Replaces a file atomically, as editors do.
    std::string write(const std::string& name, const std::string& text) const {
        const fs::path path = folder_.at(name);
        std::ofstream(path.string() + ".new") << text;
        fs::rename(path.string() + ".new", path);
        return path.string();
    }

    static SessionOptions options() {
        SessionOptions options;
        options.threads = 2;
        options.width = 48;
        options.height = 36;
        return options;
    }

    static bool finished(const Session& session, ViewSlot slot = ViewSlot::main) {
        return wait_until([&] {
            const auto frame = session.frame(slot);
            return frame && frame->reached.finished;
        });
    }
    /// The picture that the session has to finish with.
    static std::string expected(const Session& session, ViewSlot slot = ViewSlot::main) {
        RenderOptions how;
        how.show = session.show(slot);
        const Scene scene = session.scene_in_view(slot).value();
        return picture_hash(visible(render(scene, how).image, how.show, scene));
    }
    static bool shows_what_it_should(const Session& session, ViewSlot slot = ViewSlot::main) {
        const std::string wanted = expected(session, slot);
        return wait_until([&] {
            const auto frame = session.frame(slot);
            return frame && frame->reached.finished && picture_hash(frame->image) == wanted;
        });
    }
    static bool is_shown(const Session& session, std::uint64_t loads) {
        return wait_until([&] {
            const auto scene = session.scene();
            return scene && scene->loads >= loads;
        });
    }
    static bool has_problem(const Session& session) {
        return wait_until([&] { return !session.load_status().problems.empty(); });
    }

    test::TemporaryFolder folder_;
};

TEST_F(SessionTest, OpensAFileAndFinishesThePictureThatRenderGives) {
    Session session(options());
    EXPECT_FALSE(session.scene());
    EXPECT_FALSE(session.frame());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    EXPECT_TRUE(shows_what_it_should(session));
    EXPECT_TRUE(wait_until([&] { return !session.load_status().busy; }));
    EXPECT_TRUE(session.load_status().problems.empty());
}

TEST_F(SessionTest, TurnsAroundWhatThePicturesMiddleShows) {
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    const auto expect_target = [&](const Vec3& target) {
        EXPECT_LT(glm::length(session.camera().target() - target), 1e-5)
            << session.camera().target().y << " " << session.camera().target_distance();
    };
    expect_target(Vec3(0, -1, 0));
    session.move([](CameraControl& c) { c.fly(0, 0, 0.4); });
    session.orbit(0.1, 0);
    expect_target(Vec3(0, -1, 0));
    // Orbiting and zooming keep the target, although other parts of the ball are now in the middle.
    session.orbit(1.4, 0);
    expect_target(Vec3(0, -1, 0));
    session.move([](CameraControl& c) { c.zoom(1); });
    session.orbit(0.1, 0.1);
    expect_target(Vec3(0, -1, 0));
    // The middle shows nothing: the distance stays.
    session.move([](CameraControl& c) { c.reset(), c.pan(2, 0); });
    session.orbit(0, 0);
    EXPECT_NEAR(session.camera().target_distance(), 5, 1e-5);
}

TEST_F(SessionTest, OrbitingStaysInARoom) {
    Session session(options());
    session.open(write("room.toml", std::string(ball_text) + R"(
[[polyhedron]]
kind = "box"
size = [8, 14, 8]
material = "red"
[[rectangle]]
corner = [3, -7, -4]
u = [0, 14, 0]
v = [0, 0, 8]
material = "red"
)"));
    ASSERT_TRUE(is_shown(session, 1));
    const Vec3 target = session.camera().target();
    for (int turn = 0; turn < 200; ++turn) {
        session.orbit(0.05, 0);
        const Vec3 eye = session.camera().camera().eye;
        ASSERT_LT(eye.x, 3) << turn << ": through the rectangle";
        ASSERT_GT(eye.x, -4) << turn << ": out of the box";
        ASSERT_LT(std::abs(eye.y), 7) << turn;
        EXPECT_LT(glm::length(session.camera().target() - target), 1e-4);
    }
    EXPECT_GT(session.camera().target_distance(), 1.5) << "near walls, not in the ball";
}

TEST_F(SessionTest, AnEmptiedFileAndAPipeAreReported) {
    Session session(options());
    const std::string path = write("ball.toml", ball_text);
    session.open(path);
    ASSERT_TRUE(is_shown(session, 1));
    write("ball.toml", "");
    EXPECT_TRUE(wait_until([&] { return !session.load_status().problems.empty(); }));
    EXPECT_EQ(session.load_status().problems.at(0).message, "the file is empty");
    EXPECT_EQ(session.scene()->scene.stats().objects, 1u) << "the picture stays";
    const std::string pipe = folder_.at("pipe.toml");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    session.open(pipe);
    EXPECT_TRUE(wait_until([&] {
        const LoadStatus status = session.load_status();
        return !status.busy && status.path == pipe && !status.problems.empty();
    }));
}

TEST_F(SessionTest, CameraSizeAndWhatIsShownLeadToTheirPictures) {
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    session.move([](CameraControl& c) { c.orbit(0.5, 0.3); });
    EXPECT_TRUE(shows_what_it_should(session));
    session.resize(31, 57);
    EXPECT_TRUE(shows_what_it_should(session));
    for (const Aov show : {Aov::normal, Aov::diffuse, Aov::shadows}) {
        session.set_show(show);
        EXPECT_TRUE(shows_what_it_should(session)) << aov_name(show);
    }
}

TEST_F(SessionTest, EditsOfMaterialsLightsAndObjectsShow) {
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    SceneDescription edited = session.scene()->scene.description();
    edited.materials[0].transparency = 0.75;
    edited.whitted.max_depth = 2;
    std::get<PointLight>(edited.lights[0].kind).intensity = 10;
    std::get<SphereShape>(edited.objects[0].shape).radius = 1.5;
    session.edit(edited);
    ASSERT_TRUE(
        wait_until([&] { return session.scene()->scene.description().materials[0].transparency == 0.75; }));
    EXPECT_TRUE(shows_what_it_should(session));
    EXPECT_EQ(std::get<SphereShape>(session.scene_in_view()->description().objects[0].shape).radius, 1.5);
}

TEST_F(SessionTest, AnImpossibleEditIsToldAndNothingChanges) {
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    SceneDescription edited = session.scene()->scene.description();
    edited.materials[0].index = -1;
    session.edit(edited);
    ASSERT_TRUE(has_problem(session));
    EXPECT_EQ(session.scene()->scene.description().materials[0].index, 1.5);
    EXPECT_TRUE(shows_what_it_should(session));
}

TEST_F(SessionTest, SavingTheFileShowsItAndKeepsTheCamera) {
    Session session(options());
    const std::string path = write("ball.toml", ball_text);
    session.open(path);
    ASSERT_TRUE(is_shown(session, 1));
    session.move([](CameraControl& c) { c.orbit(1, 0.2); });
    const Vec3 eye = session.camera().camera().eye;
    std::string blue = ball_text;
    blue.replace(blue.find("[1, 0, 0]"), 9, "[0, 0, 1]");
    write("ball.toml", blue);
    ASSERT_TRUE(is_shown(session, 2));
    EXPECT_EQ(session.scene()->scene.description().materials[0].color, Vec3(0, 0, 1));
    EXPECT_EQ(session.camera().camera().eye, eye);
    EXPECT_TRUE(shows_what_it_should(session));
    session.move([](CameraControl& c) { c.reset(); });
    EXPECT_EQ(session.camera().camera().eye, Vec3(0, -6, 0)) << "home is the file's camera";
}

TEST_F(SessionTest, ABrokenFileIsToldWhileTheLastGoodSceneStays) {
    Session session(options());
    const std::string path = write("ball.toml", ball_text);
    session.open(path);
    ASSERT_TRUE(is_shown(session, 1));
    ASSERT_TRUE(finished(session));
    const std::string shown = expected(session);
    write("ball.toml", ball_text + "[[sphere]]\ncenter = [0, 0, 0]\nradius = \"large\"\n");
    ASSERT_TRUE(has_problem(session));
    EXPECT_EQ(session.load_status().problems[0].location.file, path);
    EXPECT_GT(session.load_status().problems[0].location.line, 10);
    EXPECT_EQ(picture_hash(session.frame()->image), shown);
    write("ball.toml", ball_text + "# better\n");
    ASSERT_TRUE(is_shown(session, 2));
    EXPECT_TRUE(wait_until([&] { return session.load_status().problems.empty(); }));
}

TEST_F(SessionTest, SavingAMeshShowsItToo) {
    write_ply(folder_.at("shape.ply"), kit::box_mesh(Vec3(0), Vec3(1)));
    Session session(options());
    session.open(write("scene.toml", ball_text + "[[mesh]]\nfile = \"shape.ply\"\nmaterial = \"red\"\n"));
    ASSERT_TRUE(is_shown(session, 1));
    EXPECT_EQ(session.scene()->scene.stats().triangles, 12u);
    write_ply(folder_.at("shape.ply"), kit::sphere_mesh(1, 8));
    ASSERT_TRUE(is_shown(session, 2));
    EXPECT_GT(session.scene()->scene.stats().triangles, 12u);
}

TEST_F(SessionTest, AFileThatIsNotThereIsTold) {
    Session session(options());
    session.open(folder_.at("nothing.toml"));
    ASSERT_TRUE(has_problem(session));
    EXPECT_FALSE(session.scene());
    write("nothing.toml", ball_text);
    EXPECT_TRUE(is_shown(session, 1)) << "it is watched all the same";
}

TEST_F(SessionTest, ComparingShowsBothFromTheSameCamera) {
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    SceneDescription other = session.scene()->scene.description();
    other.materials[0].color = Vec3(0, 1, 0);
    session.compare(other);
    session.set_show(Aov::diffuse, ViewSlot::reference);
    ASSERT_TRUE(wait_until([&] { return session.scene_in_view(ViewSlot::reference).has_value(); }));
    session.move([](CameraControl& c) { c.zoom(2); });
    EXPECT_TRUE(shows_what_it_should(session, ViewSlot::main));
    EXPECT_TRUE(shows_what_it_should(session, ViewSlot::reference));
    EXPECT_EQ(session.frame(ViewSlot::main)->camera.eye, session.frame(ViewSlot::reference)->camera.eye);
    session.compare(std::nullopt);
    EXPECT_FALSE(session.frame(ViewSlot::reference));
    EXPECT_FALSE(session.is_comparing());
}

TEST_F(SessionTest, PickingFindsWhatStandsThere) {
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    const Scene seen = session.scene_in_view().value();
    const auto found = pick(seen, 24, 18);
    ASSERT_TRUE(found);
    EXPECT_EQ(session.scene()->scene.description().objects[found->object].name, "ball");
    EXPECT_NEAR(found->distance, 5, 1e-5);
    EXPECT_NEAR(glm::length(found->position - Vec3(0, -1, 0)), 0, 1e-5);
    EXPECT_NEAR(glm::length(found->normal - Vec3(0, -1, 0)), 0, 1e-5);
    EXPECT_FALSE(pick(seen, 0, 0)) << "nothing is there";
    EXPECT_FALSE(pick(seen, -1, 5)) << "outside the picture";
}

TEST_F(SessionTest, APictureComesForEveryMovementWhileTheCameraNeverRests) {
    SceneDescription large;
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    std::uint64_t seen = 0;
    for (int i = 0; i < 30; ++i)
        ASSERT_TRUE(wait_until([&] {
            session.move([](CameraControl& c) { c.orbit(0.01, 0); });
            const auto frame = session.frame();
            const bool is_new = frame && frame->number > seen;
            if (is_new) seen = frame->number;
            return is_new;
        }));
}

TEST_F(SessionTest, EverythingAtOnceEndsInTheRightPicture) {
    Session session(options());
    const std::string path = write("ball.toml", ball_text);
    session.open(path);
    ASSERT_TRUE(is_shown(session, 1));
    std::thread saver([&] {
        for (int i = 0; i < 5; ++i) {
            write("ball.toml", ball_text + std::string(static_cast<std::size_t>(i), '\n'));
            std::this_thread::sleep_for(std::chrono::milliseconds(60));
        }
    });
    for (int i = 0; i < 60; ++i) {
        session.move([](CameraControl& c) { c.orbit(0.1, 0.01); });
        if (i % 7 == 0) session.resize(20 + i, 30);
        if (i % 11 == 0) session.reload();
        if (i % 13 == 0) session.cancel_loading();
        if (i % 17 == 0) session.open(path);
        if (i % 19 == 0) session.set_show(i % 2 == 0 ? Aov::final : Aov::cost);
        if (const auto scene = session.scene()) {
            SceneDescription edited = scene->scene.description();
            edited.materials[0].reflectivity = i / 100.0;
            session.edit(edited);
            if (i % 23 == 0) session.compare(edited);
        }
        session.frame();
        session.frame(ViewSlot::reference);
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    saver.join();
    session.compare(std::nullopt);
    const std::uint64_t before = session.scene()->loads;
    session.open(path);
    ASSERT_TRUE(is_shown(session, before + 1));
    ASSERT_TRUE(wait_until([&] { return !session.load_status().busy; }));
    EXPECT_TRUE(shows_what_it_should(session));
}

TEST_F(SessionTest, ClosesWhileALargeMeshIsRead) {
    const std::string path = folder_.at("large.ply");
    write_ply(path, kit::sphere_mesh(1, 150));
    for (int delay = 0; delay < 100; delay += 9) {
        Session session(options());
        session.open(path);
        std::this_thread::sleep_for(std::chrono::milliseconds(delay));
    }
}

TEST_F(SessionTest, GivingUpAFileLeavesTheSceneBefore) {
    const std::string large = folder_.at("large.ply");
    write_ply(large, kit::sphere_mesh(1, 150));
    Session session(options());
    session.open(write("ball.toml", ball_text));
    ASSERT_TRUE(is_shown(session, 1));
    session.open(large);
    session.cancel_loading();
    ASSERT_TRUE(wait_until([&] { return !session.load_status().busy; }));
    EXPECT_EQ(fs::path(session.scene()->path).filename(), "ball.toml");
    EXPECT_TRUE(session.load_status().problems.empty());
    EXPECT_TRUE(shows_what_it_should(session));
}

} // namespace
} // namespace glint::viewer
