// What programs read of an explanation holds: formulas, sums, links.

#include "formula.h"
#include "gallery.h"
#include "scene_kit.h"

#include "glint/explain.h"
#include "glint/explanation_files.h"
#include "glint/scene.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>

namespace glint::rendering {
namespace {

using namespace kit;
using nlohmann::json;
using test::Number;

Number number_of(const json& value) {
    if (value.is_array())
        return {{value[0].get<float>(), value[1].get<float>(), value[2].get<float>()}, true};
    return {glm::vec3(value.is_null() ? std::numeric_limits<float>::infinity() : value.get<float>()), false};
}

/// Relative where there is something to relate to; a vector's channels each.
bool agree(const Number& a, const Number& b) {
    for (int i = 0; i < 3; ++i) {
        if (a.v[i] == b.v[i]) continue;
        if (!(std::abs(a.v[i] - b.v[i]) <= 1e-6f * std::max(std::abs(a.v[i]), std::abs(b.v[i]))))
            return false;
    }
    return true;
}

class JsonOf : public testing::TestWithParam<Exhibit> {
  protected:
    /// Calls check(document) for pixels all over the picture.
    template <class Check>
    void for_pixels(int count, const Check& check) {
        SceneDescription description = GetParam().scene;
        description.render.width = 160;
        description.render.height = 120;
        description.render.spp = 2;
        const Scene scene = build_scene(description);
        Explainer explainer(scene);
        for (int i = 0; i < count; ++i) {
            const Explanation e = explainer.pixel((i * 67 + 13) % 160, (i * 89 + 7) % 120);
            check(json::parse(explanation_json(e)), e);
        }
    }
};

INSTANTIATE_TEST_SUITE_P(Gallery, JsonOf, testing::ValuesIn(gallery()),
                         [](const auto& exhibit) { return exhibit.param.name; });

/// Evaluates every formula; returns how many there were.
int check_formulas(const json& steps) {
    int count = 0;
    for (const json& step : steps) {
        if (!step.contains("formula")) continue;
        std::map<std::string, Number> values;
        for (const auto& [symbol, value] : step["values"].items()) values[symbol] = number_of(value);
        const std::string formula = step["formula"];
        const Number printed = number_of(step["result"]);
        const Number again = test::evaluate(formula, values);
        EXPECT_TRUE(agree(printed, again))
            << step.dump(2) << "\nevaluated: " << again.v.x << ", " << again.v.y << ", " << again.v.z;
        ++count;
    }
    return count;
}

TEST_P(JsonOf, EveryFormulaGivesItsResult) {
    int formulas = 0;
    for_pixels(40, [&](const json& document, const Explanation&) {
        for (const json& sample : document["samples"])
            for (const json& ray : sample["rays"]) {
                formulas += check_formulas(ray["steps"]);
                for (const json& light : ray["lights"]) formulas += check_formulas(light["steps"]);
            }
    });
    EXPECT_GT(formulas, 500);
}

TEST_P(JsonOf, NineDigitsReadBackTheSameFloats) {
    for_pixels(10, [](const json& document, const Explanation& e) {
        EXPECT_EQ(number_of(document["color"]).v, e.color);
        for (std::size_t i = 0; i < e.samples.size(); ++i) {
            const json& sample = document["samples"][i];
            EXPECT_EQ(number_of(sample["radiance"]).v, e.samples[i].radiance);
            for (std::size_t k = 0; k < e.samples[i].rays.size(); ++k) {
                const ExplainedRay& ray = e.samples[i].rays[k];
                EXPECT_EQ(number_of(sample["rays"][k]["radiance"]).v, ray.radiance);
                EXPECT_EQ(number_of(sample["rays"][k]["direction"]).v, ray.direction);
                EXPECT_EQ(number_of(sample["rays"][k]["weight"]).v, ray.weight);
            }
        }
    });
}

/// The result of a step; fails where there is none.
glm::vec3 result_of(const std::vector<Step>& steps, const std::string& symbol) {
    for (const Step& step : steps)
        if (step.symbol == symbol)
            return step.result.vector ? step.result.value : glm::vec3(step.result.value.x);
    ADD_FAILURE() << "no step " << symbol;
    return glm::vec3(0.0f);
}

TEST_P(JsonOf, StepsLeadFromRayToRay) {
    for_pixels(25, [](const json&, const Explanation& e) {
        for (const ExplainedSample& sample : e.samples)
            for (const ExplainedRay& ray : sample.rays) {
                EXPECT_EQ(result_of(ray.steps, "L"), ray.radiance);
                for (const int child : {ray.reflected, ray.refracted}) {
                    if (child < 0) continue;
                    const bool mirror = child == ray.reflected;
                    const ExplainedRay& next = sample.rays.at(static_cast<std::size_t>(child));
                    EXPECT_EQ(result_of(ray.steps, mirror ? "R" : "T"), next.direction);
                    EXPECT_EQ(result_of(ray.steps, mirror ? "W_R" : "W_T"), next.weight);
                    EXPECT_EQ(result_of(ray.steps, mirror ? "L_R" : "L_T"), next.radiance);
                }
            }
    });
}

} // namespace
} // namespace glint::rendering
