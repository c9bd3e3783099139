// Scene files on disk: meshes, the fence around a scene's folder, bare meshes, what is no scene.

#include "scene_support.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace glint::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
    "end_header\n0 0 0\n1 0 0\n0 1 2\n3 0 1 2\n";

std::string mesh_scene(const std::string& file) {
    return "[material.m]\n[[mesh]]\nname = \"cat\"\nfile = \"" + file + "\"\nmaterial = \"m\"\n";
}

std::vector<Diagnostic> load_errors(const std::string& path, const LoadOptions& options = {}) {
    try {
        load_scene(path, options);
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::input);
        return error.diagnostics();
    }
    return {};
}

LoadOptions overriding(std::vector<Override> overrides) {
    LoadOptions options;
    options.overrides = std::move(overrides);
    return options;
}

const MeshShape& mesh_of(const LoadedScene& scene, std::size_t i = 0) {
    return std::get<MeshShape>(scene.description.objects.at(i).shape);
}

TEST(SceneFiles, MeshesAreRelativeToTheScene) {
    const TemporaryFolder folder;
    folder.write("meshes/a.ply", triangle_ply);
    const auto scene = load_scene(folder.write("a.toml", mesh_scene("meshes/a.ply")));
    ASSERT_TRUE(mesh_of(scene).data);
    EXPECT_EQ(mesh_of(scene).data->triangles.size(), 1u);
    EXPECT_EQ(mesh_of(scene).file, "meshes/a.ply");
}

TEST(SceneFiles, AFileNamedTwiceIsReadOnce) {
    const TemporaryFolder folder;
    folder.write("a.ply", triangle_ply);
    const auto scene = load_scene(folder.write(
        "a.toml", mesh_scene("a.ply") + "[[mesh]]\nfile = \"./x/../a.ply\"\nscale = 2\nmaterial = \"m\"\n"));
    EXPECT_EQ(mesh_of(scene, 0).data, mesh_of(scene, 1).data);
}

TEST(SceneFiles, AMissingMeshNamesItsPlaceAndTheCure) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.toml", mesh_scene("cat.ply"));
    const auto errors = load_errors(path);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].location, (Location{path, 4, 8, {}}));
    EXPECT_EQ(errors[0].message, "mesh file \"" + folder.at("cat.ply") + "\" does not exist");
    EXPECT_EQ(errors[0].hint, "say where it is with -D mesh.cat.file=…");
}

TEST(SceneFiles, MissingMeshesAreReportedWithAllElse) {
    const TemporaryFolder folder;
    const auto errors =
        load_errors(folder.write("a.toml", mesh_scene("cat.ply") + "[whitted]\nclamp = 1\n[[mesh]]\nfile = "
                                                                   "\"dog.ply\"\nmaterial = \"x\"\n"));
    ASSERT_EQ(errors.size(), 4u);
    EXPECT_EQ(errors[0].location.line, 4);
    EXPECT_EQ(errors[1].location.line, 7);
    EXPECT_EQ(errors[2].location.line, 9);
    EXPECT_EQ(errors[2].hint, "say where it is with -D mesh.1.file=…");
    EXPECT_EQ(errors[3].location.line, 10);
}

TEST(SceneFiles, AFolderIsNoMesh) {
    const TemporaryFolder folder;
    folder.write("cat.ply/a", "");
    const auto errors = load_errors(folder.write("a.toml", mesh_scene("cat.ply")));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_NE(errors[0].message.find("is a folder"), std::string::npos);
}

TEST(SceneFiles, AFifoIsNoMeshAndIsNotWaitedFor) {
    const TemporaryFolder folder;
    const std::string fifo = folder.at("cat.ply");
    ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
    const auto errors = load_errors(folder.write("a.toml", mesh_scene("cat.ply")));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].location.line, 4);
    EXPECT_NE(errors[0].message.find("is a FIFO"), std::string::npos);
    const auto bare = load_errors(fifo);
    ASSERT_EQ(bare.size(), 1u);
    EXPECT_NE(bare[0].message.find("is a FIFO"), std::string::npos);
    LoadOptions open;
    open.allow_outside = true;
    EXPECT_NE(
        load_errors(folder.write("b.toml", mesh_scene("/dev/null")), open).at(0).message.find("is a device"),
        std::string::npos);
}

TEST(SceneFiles, ABrokenMeshNamesItsOwnPlaceAndTheScenes) {
    const TemporaryFolder folder;
    folder.write("cat.ply", "ply\nformat ascii 1.0\nelement vertex many\n");
    const std::string path = folder.write("a.toml", mesh_scene("cat.ply"));
    const auto errors = load_errors(path);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].location.file, folder.at("cat.ply"));
    EXPECT_EQ(errors[0].location.line, 3);
    EXPECT_NE(errors[0].hint.find("the mesh is named at " + path + ":4:8"), std::string::npos)
        << errors[0].hint;
}

TEST(SceneFiles, MeshesBeyondTheLimitsAreRefused) {
    const TemporaryFolder folder;
    folder.write("a.ply", triangle_ply);
    const std::string path = folder.write("a.toml", mesh_scene("a.ply") + "scale = 0.9e12\n");
    const auto errors = load_errors(path);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].message, "\"cat\" reaches beyond 10^12 scene units");
    EXPECT_EQ(errors[0].location.line, 4);
    const auto moved = load_errors(folder.write(
        "b.toml",
        mesh_scene("a.ply") + "scale = 1e6\n[[instance]]\nmesh = \"cat\"\ntransform = [{ scale = 1e6 }]\n"));
    ASSERT_EQ(moved.size(), 1u);
    EXPECT_EQ(moved[0].location.line, 8);
}

TEST(SceneFiles, NamesOfASceneStayInItsFolder) {
    const TemporaryFolder folder;
    folder.write("out.ply", triangle_ply);
    folder.write("scenes2/out.ply", triangle_ply);
    fs::create_directories(folder.at("scenes"));
    fs::create_symlink(folder.at("out.ply"), folder.at("scenes/link.ply"));
    fs::create_directory_symlink(folder.at("scenes2"), folder.at("scenes/up"));
    for (const std::string& file :
         {std::string("../out.ply"), folder.at("out.ply"), std::string("link.ply"), std::string("up/out.ply"),
          std::string("../scenes2/out.ply"), std::string("x/../../out.ply"), std::string("/etc/passwd"),
          std::string("..")}) {
        SCOPED_TRACE(file);
        const std::string path = folder.write("scenes/a.toml", mesh_scene(file));
        const auto errors = load_errors(path);
        ASSERT_EQ(errors.size(), 1u);
        EXPECT_NE(errors[0].message.find("lies outside the scene's folder"), std::string::npos);
        EXPECT_NE(errors[0].hint.find("--allow-outside"), std::string::npos);
        EXPECT_EQ(errors[0].location.line, 4);
    }
    LoadOptions open;
    open.allow_outside = true;
    EXPECT_TRUE(mesh_of(load_scene(folder.write("scenes/a.toml", mesh_scene("../out.ply")), open)).data);
    EXPECT_TRUE(mesh_of(load_scene(folder.write("scenes/a.toml", mesh_scene("up/out.ply")), open)).data);
}

TEST(SceneFiles, NamesInsideTheFolderMayTakeDetours) {
    const TemporaryFolder folder;
    folder.write("scenes/in/out.ply", triangle_ply);
    fs::create_directory_symlink(folder.at("scenes/in"), folder.at("scenes/link"));
    for (const std::string& file : {std::string("in/../in/out.ply"), std::string("link/out.ply"),
                                    std::string("../scenes/in/out.ply"), folder.at("scenes/in/out.ply")})
        EXPECT_TRUE(mesh_of(load_scene(folder.write("scenes/a.toml", mesh_scene(file)))).data) << file;
}

TEST(SceneFiles, NamesOfTheCommandLineAreTrustedAndRelativeToTheWorkingDirectory) {
    const TemporaryFolder folder;
    const std::string path = folder.write("scenes/a.toml", mesh_scene("missing.ply"));
    const std::string mesh = fs::relative(folder.write("other/b.ply", triangle_ply)).string();
    EXPECT_TRUE(mesh_of(load_scene(path, overriding({"mesh.cat.file=" + mesh}))).data);
    const auto errors = load_errors(path, overriding({"mesh.cat.file=no-such.ply"}));
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].location.file, "-D mesh.cat.file=no-such.ply");
    EXPECT_EQ(errors[0].message, "mesh file \"no-such.ply\" does not exist");
}

TEST(SceneFiles, MeshesAreLeftAloneOnRequest) {
    LoadOptions options;
    options.load_meshes = false;
    const TemporaryFolder folder;
    EXPECT_FALSE(mesh_of(load_scene(folder.write("a.toml", mesh_scene("cat.ply")), options)).data);
}

TEST(SceneFiles, ABareMeshIsStaged) {
    const TemporaryFolder folder;
    for (const char* name : {"a.ply", "a.PLY", "mesh", "mesh.dat"}) {
        SCOPED_TRACE(name);
        const LoadedScene scene = load_scene(folder.write(name, triangle_ply));
        EXPECT_FALSE(scene.description.objects.empty());
        EXPECT_FALSE(scene.description.lights.empty());
        ASSERT_EQ(scene.notes.size(), 1u);
        EXPECT_TRUE(scene.notes[0].starts_with("up axis: ")) << scene.notes[0];
        EXPECT_NE(scene.notes[0].find("(guessed from the shape); change it with --up "), std::string::npos);
    }
    LoadOptions options;
    options.up = Axis::y;
    EXPECT_TRUE(load_scene(folder.at("a.ply"), options).notes.empty());
}

TEST(SceneFiles, ABareMeshStandsOnNoFloorOnRequest) {
    const TemporaryFolder folder;
    const std::string path = folder.write("cat.ply", triangle_ply);
    LoadOptions alone;
    alone.floor = false;
    EXPECT_EQ(load_scene(path).description.objects.size(), 2u);
    EXPECT_EQ(load_scene(path, alone).description.objects.size(), 1u);
}

TEST(SceneFiles, ABareMeshTakesOverridesOfSettings) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.ply", triangle_ply);
    const auto plain = load_scene(path).description;
    const auto d = load_scene(path, overriding({"render.spp=1", "whitted.max_depth=2", "camera.fov=20",
                                                "material.floor.color=red"}))
                       .description;
    EXPECT_EQ(d.render.spp, 1);
    EXPECT_EQ(d.render.width, plain.render.width);
    EXPECT_EQ(d.whitted.max_depth, 2);
    ASSERT_FALSE(d.camera) << "framed with that field of view";
    EXPECT_EQ(fit_camera(d).fov, 20);
    EXPECT_EQ(d.materials.size(), plain.materials.size());
    EXPECT_EQ(d.objects.size(), plain.objects.size());
    EXPECT_EQ(d.lights.size(), plain.lights.size());

    const auto wrong = load_errors(path, overriding({"render.sppp=3", "material.clya.index=1"}));
    ASSERT_EQ(wrong.size(), 2u);
    EXPECT_EQ(wrong[0].hint, "did you mean \"spp\"?");
    EXPECT_EQ(wrong[1].hint, "did you mean \"clay\"?");
    const auto absent = load_errors(path, overriding({"sphere.0.radius=1"}));
    ASSERT_EQ(absent.size(), 1u);
    EXPECT_EQ(absent[0].message, "a bare mesh has no [[sphere]] to change");
    EXPECT_EQ(absent[0].location.file, "-D sphere.0.radius=1");
}

TEST(SceneFiles, OverridesReachABareMeshAndItsStage) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.ply", triangle_ply);
    const auto plain = load_scene(path).description;
    const auto d = load_scene(path, overriding({"mesh.0.normals=smooth", "mesh.mesh.crease_angle=40",
                                                "light.1.intensity=7", "plane.floor.visible=false"}))
                       .description;
    const auto& mesh = std::get<MeshShape>(d.objects[0].shape);
    EXPECT_EQ(mesh.normals, NormalsMode::smooth);
    EXPECT_EQ(mesh.crease_angle, 40);
    EXPECT_FALSE(d.objects[1].visible);
    EXPECT_EQ(std::get<PointLight>(d.lights[1].kind).intensity, 7);
    EXPECT_EQ(std::get<PointLight>(d.lights[1].kind).position,
              std::get<PointLight>(plain.lights[1].kind).position)
        << "the rest stays";
    // The floor lies below the mesh as it then is.
    const auto large = load_scene(path, overriding({"mesh.0.scale=10"})).description;
    const auto offset = [](const SceneDescription& s) {
        return std::get<PlaneShape>(s.objects[1].shape).offset;
    };
    EXPECT_NEAR(offset(large), 10 * offset(plain), 1e-9);
    EXPECT_THROW(load_scene(path, overriding({"mesh.0.file=b.ply"})), Error);
}

TEST(SceneFiles, WhatIsNoSceneIsRefusedInWords) {
    const TemporaryFolder folder;
    const auto message = [&](const std::string& path) {
        const auto errors = load_errors(path);
        EXPECT_EQ(errors.size(), 1u);
        EXPECT_EQ(errors.at(0).location.file, path);
        return errors.at(0).message + " / " + errors.at(0).hint;
    };
    EXPECT_EQ(message(folder.at("none.toml")),
              "the file does not exist / a scene (.toml) or a mesh (.ply) was expected");
    fs::create_directories(folder.at("folder.toml"));
    EXPECT_EQ(message(folder.at("folder.toml")),
              "this is a folder / a scene (.toml) or a mesh (.ply) was expected");
    EXPECT_EQ(message(folder.write("a.obj", "v 0 0 0\n")),
              "meshes of type .obj cannot be read / convert it to PLY");
    EXPECT_EQ(message(folder.write("a.XYZ", "0 0 0\n")),
              "point clouds of type .xyz cannot be read / convert it to PLY");
    EXPECT_EQ(message(folder.write("a.pcd", "# .PCD v.7\n")),
              "point clouds of type .pcd cannot be read / convert it to PLY");
    EXPECT_EQ(message(folder.write("a.step", "ISO-10303-21;\n")),
              "solid models of type .step cannot be read / export it as PLY");
    EXPECT_EQ(message(folder.write("a.lz4", "\x04\x22\x4d\x18")),
              "compressed files of type .lz4 cannot be read / decompress it first");
    EXPECT_EQ(message(folder.write("a.png", std::string("\x89PNG\r\n\x1a\n\0\0\0", 11))),
              "a zero byte: this is not a text file / expected a scene file (TOML) or a PLY mesh");
    EXPECT_NE(message(folder.write("b.ply", "[camera]\n")), "");
    EXPECT_EQ(message(folder.write("a.ply.gz", "\x1f\x8b\x08")),
              "the file is compressed with gzip / decompress it first: gunzip -k");
    EXPECT_EQ(message(folder.write("c.ply", std::string("\xfd"
                                                        "7zXZ\0",
                                                        6))),
              "the file is compressed with xz / decompress it first: unxz -k");
    EXPECT_EQ(message(folder.write("a.zst", "\x28\xb5\x2f\xfd")),
              "the file is compressed with zstd / decompress it first: unzstd -k");
}

TEST(SceneFiles, AnUnreadableFileIsRefused) {
    if (geteuid() == 0) GTEST_SKIP() << "root reads every file";
    const TemporaryFolder folder;
    const std::string path = folder.write("a.toml", "");
    fs::permissions(path, fs::perms::none);
    const auto errors = load_errors(path);
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_NE(errors[0].message.find("cannot read the file"), std::string::npos);
}

TEST(SceneFiles, AnEmptyFileOfAnyNameIsAnEmptyScene) {
    const TemporaryFolder folder;
    EXPECT_TRUE(load_scene(folder.write("empty", "")).description.objects.empty());
}

/// While it lives, standard input is this file or folder.
class StandardInput {
  public:
    explicit StandardInput(const std::string& path) : before_(::dup(STDIN_FILENO)) {
        const int file = ::open(path.c_str(), O_RDONLY);
        ::dup2(file, STDIN_FILENO);
        ::close(file);
    }
    ~StandardInput() {
        ::dup2(before_, STDIN_FILENO);
        ::close(before_);
    }
    StandardInput(const StandardInput&) = delete;
    StandardInput& operator=(const StandardInput&) = delete;

  private:
    int before_;
};

TEST(SceneFiles, StandardInputIsRead) {
    const TemporaryFolder folder;
    {
        const StandardInput input(folder.write("a.toml", "[whitted]\nmax_depth = 3\n"));
        EXPECT_EQ(load_scene("-").description.whitted.max_depth, 3);
    }
    const StandardInput input(folder.write("b.toml", "[whitted]\nmax_depth = -3\n"));
    const auto errors = load_errors("-");
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].location, (Location{"<stdin>", 2, 13, {}}));
}

TEST(SceneFiles, AFolderOnStandardInputIsRefused) {
    const StandardInput input("/");
    const auto errors = load_errors("-");
    ASSERT_EQ(errors.size(), 1u);
    EXPECT_EQ(errors[0].location.file, "<stdin>");
    EXPECT_NE(errors[0].message.find("Is a directory"), std::string::npos);
}

} // namespace
} // namespace glint::test
