// explain: what it writes, and that its page says in a browser what its JSON says.

#include "cli_test.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <sstream>

namespace glint::test {
namespace {

using nlohmann::json;

/// A mirror, tinted Fresnel glass around a matte ball, a pane and two lights: every term there is.
constexpr const char* cabinet = R"(version = 1
[camera]
eye = [0.3, -6, 1.2]
look_at = [0, 0, 0.4]
[render]
size = [60, 40]
spp = 1
background = [0.1, 0.2, 0.3]
[whitted]
max_depth = 4
clamp = true
[material.floor]
color = [0.8, 0.7, 0.5]
highlight = 0.4
shininess = 20
reflectivity = 0.3
[material.tinted]
color = [0.2, 0.3, 0.4]
highlight = 0.5
transparency = 0.8
reflectivity = 0.1
absorption = [0.3, 0.1, 0.5]
fresnel = true
[material.pane]
diffuse = 0.2
transparency = 0.7
[material.lamp]
diffuse = 0
emission = [0.5, 0.4, 0.1]
[[plane]]
normal = [0, 0, 1]
offset = -0.8
material = "floor"
[[sphere]]
name = "glass"
center = [-0.6, 0, 0.3]
radius = 1
material = "tinted"
[[sphere]]
center = [-0.5, 0.2, 0.3]
radius = 0.3
material = "lamp"
[[triangle]]
vertices = [[0.4, -1.5, -0.7], [1.9, -1.2, -0.7], [1.1, -1.3, 1.5]]
material = "pane"
[[light]]
type = "ambient"
color = [0.1, 0.1, 0.12]
[[light]]
type = "point"
position = [2, -4, 5]
intensity = 40
[[light]]
type = "spot"
position = [-3, -3, 4]
direction = [3, 3, -4]
angle = 20
blend = 0.5
intensity = 30
)";

class Explain : public CliTest {
  public:
    Explain() { write("cabinet.toml", cabinet); }
};

TEST_F(Explain, ColoursTerminalsOnly) {
    EXPECT_EQ(glint("explain good.toml --pixel 8,6").out.find('\x1b'), std::string::npos);
    EXPECT_NE(glint("explain good.toml --pixel 8,6 --color always").out.find('\x1b'), std::string::npos);
}

TEST_F(Explain, TellsWhereShadowRaysBegin) {
    const std::string line = "explain cabinet.toml --pixel 30,20 --spp 1";
    const std::string text = glint(line + " --steps").out;
    const auto count = [&text](const std::string& words) {
        std::size_t found = 0;
        for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1))
            ++found;
        return found;
    };
    std::size_t rays = 0;
    const json document = json::parse(glint(line + " --format json").out);
    for (const json& ray : document["samples"][0]["rays"])
        for (const json& light : ray["lights"]) rays += light["shadow_ray"].is_null() ? 0 : 1;
    EXPECT_GT(rays, 0u);
    EXPECT_EQ(count("shadow ray from ("), rays);
}

std::size_t line_count(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

TEST_F(Explain, ShowsATreeWithALineForEachRayThatMatters) {
    const std::string line = "explain cabinet.toml --pixel 22,18";
    const Outcome tree = glint(line);
    EXPECT_EQ(tree.exit, 0);
    const json rays = json::parse(glint(line + " --format json").out)["samples"][0]["rays"];
    EXPECT_LT(line_count(tree.out), rays.size() + 6);
    for (const char* word : {"  0  100.0 %  primary → sphere \"glass\" (cabinet.toml:34:1) at ",
                             "├─ reflected → background", "└─ refracted → "})
        EXPECT_NE(tree.out.find(word), std::string::npos) << word << "\n" << tree.out;
    EXPECT_NE(tree.err.find("--ray N"), std::string::npos) << tree.err;
    const std::string faint = glint(line + " -D material.floor.reflectivity=0.001").out;
    EXPECT_NE(faint.find("└─ + 1 ray below 0.1 %\n"), std::string::npos) << faint;

    const std::string ray = glint(line + " --ray 0").out;
    EXPECT_NE(ray.find("light arriving"), std::string::npos) << ray;
    const std::string steps = glint(line + " --steps").out;
    EXPECT_GT(line_count(steps), 10 * line_count(tree.out));
    EXPECT_NE(steps.find("point light.1 (cabinet.toml:"), std::string::npos) << steps;
}

TEST_F(Explain, TellsWhereRaysOfLittleWeightAreLeftOut) {
    const std::string tree = glint("explain cabinet.toml --pixel 22,18 -D whitted.min_weight=0.5").out;
    EXPECT_NE(tree.find(", 1 branch below min_weight left out: ("), std::string::npos) << tree;
}

TEST_F(Explain, RefusesRaysAndSamplesThatDoNotExist) {
    const std::string line = "explain cabinet.toml --pixel 30,20 --spp 3 ";
    const Outcome sample = glint(line + "--sample 3");
    EXPECT_EQ(sample.exit, 2);
    EXPECT_NE(sample.err.find("there is no sample 3"), std::string::npos) << sample.err;
    EXPECT_NE(sample.err.find("has 3, numbered from 0"), std::string::npos) << sample.err;
    EXPECT_EQ(glint(line + "--ray 999").exit, 2);
    EXPECT_EQ(glint(line + "--steps --format json").exit, 2);
}

TEST_F(Explain, ChoosesTheFormatByTheExtension) {
    const std::string line = "explain cabinet.toml --pixel 30,20 -o ";
    for (const auto& [name, begin] :
         {std::pair("a.json", "{\"scene\""), std::pair("a.svg", "<svg "),
          std::pair("a.html", "<!doctype html>"), std::pair("a.txt", "pixel 30,20")}) {
        EXPECT_EQ(glint(line + name).exit, 0) << name;
        EXPECT_TRUE(content(name).starts_with(begin)) << name << "\n" << content(name).substr(0, 80);
    }
    ASSERT_EQ(glint(line + "b.json --format text").exit, 0);
    EXPECT_TRUE(content("b.json").starts_with("pixel 30,20"));
}

TEST_F(Explain, NumbersAsKeyPathsDo) {
    const json found = json::parse(glint("explain cabinet.toml --pixel 30,39 --format json").out);
    const json& ray = found["samples"][0]["rays"][0];
    EXPECT_EQ(ray["hit"]["label"], "plane.0");
    EXPECT_EQ(ray["hit"]["object"], 0);
    EXPECT_EQ(ray["hit"]["where"], "cabinet.toml:30:1");
    EXPECT_EQ(ray["lights"][0]["label"], "point light.1");
    EXPECT_EQ(ray["lights"][0]["light"], 1);
    EXPECT_EQ(ray["lights"][0]["where"], "cabinet.toml:49:1");
}

TEST_F(Explain, TellsOfEverySample) {
    const Outcome outcome = glint("explain cabinet.toml --pixel 30,20 --spp 3");
    for (const char* word : {"sample 0 ", "sample 1 ", "sample 2 ", "samples", "the rays of sample 0\n"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
    EXPECT_NE(
        glint("explain cabinet.toml --pixel 30,20 --spp 3 --sample 2").out.find("the rays of sample 2\n"),
        std::string::npos);
    EXPECT_EQ(
        json::parse(glint("explain cabinet.toml --pixel 30,20 --spp 3 --format json").out)["samples"].size(),
        3u);
}

TEST_F(Explain, DrawsATree) {
    EXPECT_EQ(glint("explain cabinet.toml --pixel 22,18 --format svg -o tree.svg").exit, 0);
    const std::string svg = content("tree.svg");
    EXPECT_EQ(svg.rfind("<svg xmlns=", 0), 0u);
    for (const char* word :
         {"pixel 22,18 of cabinet.toml", "primary ray", "refracted ray", "sphere &quot;glass&quot;"})
        EXPECT_NE(svg.find(word), std::string::npos) << word;
}

TEST_F(Explain, PagesStayBelowTenMegabytes) {
    ASSERT_EQ(glint("explain cabinet.toml --format html --size 640x360 --spp 1 -o page.html").exit, 0);
    EXPECT_LT(content("page.html").size(), 10'000'000u);
}

TEST_F(Explain, SaysWhoseNumbersItShows) {
    const std::string line = "explain cabinet.toml --pixel 22,18";
    EXPECT_NE(glint(line).out.find("computed on the CPU"), std::string::npos);
    EXPECT_NE(glint(line + " --format svg").out.find("computed on the CPU"), std::string::npos);
    const json found = json::parse(glint(line + " --format json").out);
    EXPECT_EQ(found["backend"], "cpu");
    EXPECT_TRUE(found["gpu"].is_null());
}

TEST_F(Explain, TellsHowFarTheGpuIs) {
    GLINT_NEEDS_DEVICE();
    const std::string line = "explain cabinet.toml --pixel 22,18 --spp 3 --backend gpu";
    const json found = json::parse(glint(line + " --format json").out);
    EXPECT_FALSE(found["gpu"]["device"].get<std::string>().empty());
    ASSERT_EQ(glint("cabinet.toml --spp 3 --backend gpu --crop 22,18,1,1 -o pixel.pfm").exit, 0);
    const std::string pixel = content("pixel.pfm");
    for (std::size_t c = 0; c < 3; ++c) {
        const auto cpu = found["color"][c].get<float>();
        const auto gpu = found["gpu"]["color"][c].get<float>();
        float rendered = 0;
        std::memcpy(&rendered, pixel.data() + pixel.size() - 12 + 4 * c, sizeof rendered);
        EXPECT_EQ(gpu, rendered) << "the pixel of the GPU's picture";
        EXPECT_EQ(found["gpu"]["difference"][c].get<float>(), gpu - cpu);
        EXPECT_NEAR(gpu, cpu, 1.0 / 255);
    }
    for (const char* format : {"text", "svg"})
        EXPECT_NE(glint(line + " --format " + format).out.find("it is ("), std::string::npos) << format;
    ASSERT_EQ(glint("explain cabinet.toml --spp 3 --backend gpu --format html --grid 8x6 -o page.html").exit,
              0);
    EXPECT_NE(content("page.html").find(" pixels are off by more than 1/255"), std::string::npos);
}

TEST_F(Explain, TheGpuMustBeThereToBeComparedWith) {
    const std::string line = "explain cabinet.toml --pixel 22,18 --format json --backend ";
    const Outcome gpu = glint(line + "gpu", without_devices());
    EXPECT_EQ(gpu.exit, 7);
    EXPECT_NE(gpu.err.find("no GPU"), std::string::npos) << gpu.err;
    EXPECT_EQ(gpu.out, "");
    const Outcome either = glint(line + "auto", without_devices());
    EXPECT_EQ(either.exit, 0);
    EXPECT_NE(either.err.find("\non the CPU: "), std::string::npos) << either.err;
    EXPECT_TRUE(json::parse(either.out)["gpu"].is_null());
}

std::string browser() {
    std::istringstream folders(std::getenv("PATH") ? std::getenv("PATH") : "");
    for (std::string folder; std::getline(folders, folder, ':');)
        for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
            if (std::filesystem::exists(folder + "/" + name)) return folder + "/" + name;
    return {};
}

/// Moves over every place of the page, switches each layer off and on, and leaves what was shown in the
/// document.
constexpr const char* visitor = R"(<pre id="found"></pre><script>
const refused = [];
document.addEventListener('securitypolicyviolation', e => refused.push(e.blockedURI));
const told = (list, at) => Object.fromEntries(list.map(s => page.steps[s[0]][0]).map(s => [s, at(s)]));
ready.then(() => {
  const first = { pixel: [shown.x, shown.y], pinned };
  pinned = false;
  const found = [], r = $('canvas').getBoundingClientRect();
  for (let row = 0; row < page.rows; ++row) for (let column = 0; column < page.columns; ++column) {
    $('picture').dispatchEvent(new MouseEvent('mousemove', { bubbles: true,
      clientX: r.left + r.width * (column + 0.5) / page.columns, clientY: r.top + r.height * (row + 0.5) / page.rows }));
    const layers = {};
    for (const name of names) if ($('layer-' + name)) {
      $('layer-' + name).click(); layers[name] = sum_shown(shown); $('layer-' + name).click(); }
    found.push({ pixel: [shown.x, shown.y], color: shown.color, sum: sum_shown(shown), layers,
      first: found.length === 0 ? first : null, terms: Object.fromEntries(names.map((n, i) => [n, shown.terms[i]])), text: $('pixel').textContent,
      boxes: document.querySelectorAll('.ray').length,
      rays: shown.rays.map(ray => ({ kind: ray.shape.kind, label: ray.shape.label, steps: told(ray.shape.steps, ray.at),
        lights: ray.lights.map(l => ({ label: l.shape.label, steps: told(l.shape.steps, l.at) })) })) });
  }
  const asked = performance.getEntriesByType('resource').map(e => e.name).filter(n => !n.startsWith('data:') && !n.startsWith('blob:'));
  $('found').textContent = btoa(unescape(encodeURIComponent(JSON.stringify({ found, asked, refused }))));
});
</script>)";

std::string from_base64(const std::string& text) {
    std::string out;
    unsigned word = 0;
    int bits = 0;
    for (const char c : text) {
        const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        const std::size_t digit = digits.find(c);
        if (digit == std::string::npos) break;
        word = (word << 6 | static_cast<unsigned>(digit)) & 0xffffffu;
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        out += static_cast<char>(word >> bits & 255u);
    }
    return out;
}

bool same(const json& a, const json& b) {
    if (a.is_array()) return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
    if (a.is_null() || b.is_null()) return a == b;
    return a.get<float>() == b.get<float>();
}

void expect_steps(const json& shown, const json& printed, const std::string& where) {
    EXPECT_EQ(shown.size(), printed.size()) << where;
    for (const json& step : printed) {
        const std::string symbol = step["symbol"];
        ASSERT_TRUE(shown.contains(symbol)) << where << ": " << symbol;
        EXPECT_TRUE(same(shown[symbol], step["result"]))
            << where << ": " << step << " shows " << shown[symbol];
    }
}

class Page : public Explain {
  protected:
    /// What the browser shows of the page of a scene, after a visit to all its pixels.
    json visited(const std::string& line) const {
        EXPECT_EQ(glint("explain " + line + " --format html -o page.html").exit, 0);
        std::string page = content("page.html");
        EXPECT_EQ(page.find("http:"), std::string::npos);
        EXPECT_EQ(page.find("https:"), std::string::npos);
        write("visit.html", page.replace(page.rfind("</body>"), 0, visitor));
        const Outcome outcome =
            run_program({browser(), "--headless", "--no-sandbox", "--disable-gpu",
                         "--disable-background-networking", "--user-data-dir=" + path("profile"),
                         "--virtual-time-budget=20000", "--dump-dom", "file://" + path("visit.html")},
                        {});
        const std::string mark = "<pre id=\"found\">";
        const std::size_t at = outcome.out.find(mark);
        EXPECT_NE(at, std::string::npos) << outcome.err;
        const std::string text =
            from_base64(outcome.out.substr(std::min(at, outcome.out.size()) + mark.size()));
        EXPECT_NE(text, "") << outcome.err;
        return text.empty() ? json::object() : json::parse(text);
    }

    void expect_as_json(const json& place, const std::string& scene) const {
        const std::string x = std::to_string(place["pixel"][0].get<int>());
        const std::string y = std::to_string(place["pixel"][1].get<int>());
        const json printed =
            json::parse(glint("explain " + scene + " --pixel " + x + "," + y + " --format json").out);
        EXPECT_TRUE(same(place["color"], printed["color"]));
        EXPECT_TRUE(same(place["sum"], printed["color"])) << "all layers on";
        EXPECT_NE(place["text"].get<std::string>().find("pixel " + x + "," + y), std::string::npos);
        for (const auto& [name, term] : printed["terms"].items())
            EXPECT_TRUE(same(place["terms"][name], term)) << name;
        const json& rays = printed["samples"][0]["rays"];
        ASSERT_EQ(place["rays"].size(), rays.size());
        EXPECT_EQ(place["boxes"], rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const std::string where = "pixel " + x + "," + y + ", ray " + std::to_string(i);
            EXPECT_EQ(place["rays"][i]["kind"], rays[i]["kind"]);
            expect_steps(place["rays"][i]["steps"], rays[i]["steps"], where);
            for (std::size_t k = 0; k < rays[i]["lights"].size(); ++k) {
                const json& light = place["rays"][i]["lights"][k];
                EXPECT_EQ(light["label"], rays[i]["lights"][k]["label"]);
                expect_steps(light["steps"], rays[i]["lights"][k]["steps"],
                             where + ", " + light["label"].get<std::string>());
            }
        }
    }

    /// With a layer off, the others add up in their order.
    static void expect_layers(const json& place) {
        for (const auto& [name, sum] : place["layers"].items()) {
            std::vector<float> expected(3, 0.0f);
            bool first = true;
            for (const char* other :
                 {"ambient", "diffuse", "highlight", "clamp", "reflection", "transmission", "emission"}) {
                if (name == other) continue;
                for (std::size_t i = 0; i < 3; ++i) {
                    const float term = place["terms"][other][i].get<float>();
                    expected[i] = first ? term : expected[i] + term;
                }
                first = false;
            }
            EXPECT_TRUE(same(sum, json(expected))) << name << " off";
        }
    }
};

TEST_F(Page, ShowsTheNumbersOfTheJsonWithoutANetwork) {
    if (browser().empty()) GTEST_SKIP() << "no chromium here: the page was not opened";
    const std::string scene = "cabinet.toml --spp 2";
    const json visit = visited(scene + " --grid 7x5");
    ASSERT_EQ(visit["found"].size(), 35u);
    for (const json& place : visit["found"]) {
        expect_as_json(place, scene);
        expect_layers(place);
    }
    EXPECT_EQ(visit["asked"], json::array()) << "no request";
    EXPECT_EQ(visit["refused"], json::array());
}

TEST_F(Page, OpensAtThePixel) {
    if (browser().empty()) GTEST_SKIP() << "no chromium here: the page was not opened";
    const std::string scene = "cabinet.toml --spp 1";
    const json visit = visited(scene + " --grid 7x5 --pixel 31,22");
    const json& first = visit["found"][0]["first"];
    EXPECT_EQ(first["pixel"], (json{31, 22}));
    EXPECT_EQ(first["pinned"], true);
    for (const json& place : visit["found"])
        if (place["pixel"] == first["pixel"]) {
            const std::string json_of = glint("explain " + scene + " --pixel 31,22 --format json").out;
            EXPECT_TRUE(same(place["color"], json::parse(json_of)["color"]));
            return;
        }
    FAIL() << "the pixel is on no place of the page";
}

} // namespace
} // namespace glint::test
