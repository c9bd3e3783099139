#include "cli_test.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace glint::test {
namespace fs = std::filesystem;
namespace {

constexpr const char* scene = R"(version = 1
[camera]
eye = [0, -5, 0]
look_at = [0, 0, 0]
[render]
size = [16, 12]
spp = 1
[material.white]
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "white"
[[light]]
type = "point"
position = [0, -5, 5]
intensity = 30
)";

constexpr const char* dark = R"(version = 1
[render]
size = [16, 12]
[material.white]
[[sphere]]
center = [0, 0, 0]
radius = 1
material = "white"
)";

constexpr const char* bad = R"(version = 1
[material.white]
[[sphere]]
center = [0, 0, 0]
radius = -1
material = "whyte"
)";

constexpr const char* tetrahedron = R"(ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 4
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
)";

} // namespace

CliTest::CliTest() {
    write("good.toml", scene);
    write("dark.toml", dark);
    write("bad.toml", bad);
    std::string slow = scene;
    slow.replace(slow.find("[16, 12]"), 8, "[1024, 1024]").replace(slow.find("spp = 1"), 7, "spp = 4000");
    write("long.toml", slow);
    write("mesh.ply", tetrahedron);
    write("garbage.png", "not a picture");
    fs::create_directory(path("empty"));
}

Outcome CliTest::glint(const std::string& line, Setting setting) const {
    setting.folder = folder_.path().string();
    return run_glint(words_of(line), setting);
}

std::string CliTest::content(const std::string& name) const {
    std::ifstream file(path(name), std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

void CliTest::write_pfm(const std::string& name, int width, int height, float value) const {
    std::ofstream file(path(name), std::ios::binary);
    file << "PF\n" << width << " " << height << "\n-1.0\n";
    for (int i = 0; i < width * height * 3; ++i)
        file.write(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string CliTest::listing() const {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder_.path()))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " ") + name;
    return text;
}

Setting CliTest::without_devices() {
    Setting setting;
    setting.environment = {"__EGL_VENDOR_LIBRARY_FILENAMES=none"};
    return setting;
}

bool CliTest::has_device(const Setting& setting) const {
    return glint("info --devices", setting).out.find("usable          yes") != std::string::npos;
}

} // namespace glint::test
