// Explains the rays of one sample.

#include "render/explain_parts.h"

#include "glint/scene.h"
#include "shading/light_gain.h"
#include "shading/whitted.shared.h"

#include <algorithm>

namespace glint {

using trace::Hit;
} // namespace glint

namespace glint::rendering {

namespace {

/// One ray: its hit, local terms and branches, and their sum.
class RayWorking {
  public:
    RayWorking(const ExplainedScene& scene, const RayTree& tree, const RayNode& node, ExplainedRay& out)
        : scene_(scene), tree_(tree), node_(node), out_(out) {}

    void explain() {
        copy_path();
        give({"W", "", out_.weight, "weight", "this ray's weight in the sample"});
        give({"d", "", node_.direction, "ray", "direction of the ray"});
        if (!node_.hit) return missed();
        copy_hit();
        give_surface();
        for (std::size_t i = 0; i < node_.lights.size(); ++i)
            out_.lights.push_back(explain_light(scene_, node_, i));
        sum_lights();
        if (clamps() && !local_.empty()) clamp();
        absorb();
        end_local_terms();
        if (node_.goes_on()) explain_bounce(scene_, tree_, node_, out_);
        emit();
        add_up();
        weigh_gain();
    }

    /// Its origin, its end and its radiance.
    void copy_path() {
        static_cast<TracedRay&>(out_) = node_;
        out_.terms = node_.terms.value;
        for (const std::uint32_t object : node_.interiors) out_.inside.push_back(scene_.label(object));
        for (const Hit& hit : node_.passed_over) out_.passed_over.push_back(scene_.label(hit.object));
        out_.why = reason();
    }

  private:
    void give(Step s) { out_.given.push_back(std::move(s)); }
    void step(Step s) { out_.steps.push_back(std::move(s)); }
    const MaterialRecord& material() const { return scene_.material(node_.hit.object); }
    bool clamps() const { return scene_.settings.clamp; }
    bool absorbs() const { return node_.transmittance != vec3(1.0f); }

    std::string reason() const {
        switch (node_.end) {
        case RayEnd::bounced:
            return "goes on" + branch_left_out();
        case RayEnd::matte:
            return "ends: the surface neither reflects nor transmits";
        case RayEnd::depth_limit:
            return "ends at the depth limit, max_depth = " + std::to_string(scene_.settings.max_depth) +
                   ": its local light counts whole";
        case RayEnd::background:
            return "ends: nothing was hit, the background shows";
        case RayEnd::absorbed:
            return "ends: it never leaves " + scene_.label(node_.interiors.front()) +
                   ", so nothing comes back";
        case RayEnd::min_weight:
            return "ends: what would go on has a weight below min_weight, and is left out";
        }
        return "";
    }

    /// Names the one of two branches that was left out, if one was.
    std::string branch_left_out() const {
        if (node_.left_out == 0) return "";
        return std::string("; the ") + (node_.reflected < 0 ? "mirror" : "refracted") +
               " ray has a weight below min_weight, and is left out";
    }

    void missed() {
        if (node_.end == RayEnd::absorbed)
            return step({"L", "0", node_.radiance, "radiance", "what comes back", "",
                         "ours: what never leaves a solid brings nothing, not even the background"});
        give({"B", "", scene_.scene.background, "emission", "background"});
        step({"emission", "B", node_.terms[Term::emission], "emission", "the background counts as emission"});
        step({"L", "emission", node_.radiance, "radiance", "what comes back"});
    }

    void copy_hit() {
        out_.hit = true;
        out_.object = node_.hit.object;
        out_.label = scene_.label(node_.hit.object);
        out_.number = scene_.numbers[node_.hit.object];
        out_.where = scene_.scene.description.objects[node_.hit.object].where;
        out_.material = scene_.material_name(node_.hit.object);
        out_.distance = node_.hit.t;
    }

    void give_surface() {
        const MaterialRecord& m = material();
        give({"t", "", node_.hit.t, "ray", "length of the way"});
        give({"p", "", node_.position, "hit", "the point that is hit"});
        give({"n_g", "", node_.geometric_normal, "hit", "geometric normal, toward the viewer"});
        const bool flat = node_.shading_normal == node_.geometric_normal;
        give({"n", flat ? "n_g" : "", node_.shading_normal, "hit", "shading normal, on the same side"});
        give({"v", "−d", -node_.direction, "hit", "direction to the viewer"});
        give({"c", "", node_.color, "material", "colour"});
        give({"k_a", "", m.ambient, "material", "ambient coefficient"});
        give({"k_d", "", m.diffuse, "material", "diffuse coefficient"});
        if (m.highlight > 0.0f) {
            give({"k", "", m.highlight, "material", "strength of the highlight"});
            give({"m", "", m.shininess, "material", "exponent of the highlight"});
        }
        give({"ρ", "", m.reflectivity, "material", "reflectivity"});
        give({"τ", "", m.transparency, "material", "transparency"});
        if (m.reflected_tint != vec3(1.0f))
            give({"t_R", "", m.reflected_tint, "material", "tint of what is reflected"});
        give({"A", "", scene_.scene.ambient, "ambient", "sum of the ambient lights"});
    }

    void sum_lights() {
        const MaterialRecord& m = material();
        LocalTerms whole{};
        whole.ambient = ambient_term(scene_.scene.ambient, node_.color, m.ambient);
        for (const ExplainedLight& light : out_.lights) {
            whole.diffuse = whole.diffuse + light.diffuse;
            whole.highlight = whole.highlight + light.highlight;
        }
        limited_ = limited_terms(scene_.modes, whole);
        if (m.ambient > 0.0f)
            add_local("a", limited("A ⊙ c · k_a", whole.ambient, limited_.ambient), limited_.ambient,
                      "ambient", "ambient light", "2.2",
                      "ambient stands for indirect light, which the model omits; the report prints a sum");
        if (m.diffuse > 0.0f)
            add_local("ΣD", sum("D", "diffuse", &ExplainedLight::diffuse), limited_.diffuse, "diffuse",
                      "diffuse light of all lights");
        if (m.highlight > 0.0f) {
            const std::string formula = sum("H", "highlight", &ExplainedLight::highlight);
            add_local("ΣH", limited(formula, whole.highlight, limited_.highlight), limited_.highlight,
                      "highlight", "highlights of all lights");
        }
    }

    /// The formula, limited to the range that the clamp can take back if it was.
    static std::string limited(const std::string& formula, const vec3& before, const vec3& after) {
        return after == before ? formula : "min(4194304, " + formula + ")";
    }

    void add_local(const char* symbol, std::string formula, const vec3& value, const char* topic,
                   const char* meaning, const char* section = "", const char* note = "") {
        step({symbol, std::move(formula), value, topic, meaning, section, note});
        join(local_, symbol);
    }

    static void join(std::string& sum, const char* term) {
        sum += (sum.empty() ? "" : " + ") + std::string(term);
    }

    /// Adds a line for what each light gives; returns the formula of the sum.
    std::string sum(const char* part, const char* topic, vec3 ExplainedLight::*value) {
        std::string formula;
        for (const ExplainedLight& light : out_.lights) {
            const std::string name = numbered(part, light.light);
            step({name, "", light.*value, topic, "what this light gives"});
            join(formula, name.c_str());
        }
        return formula.empty() ? "0" : formula;
    }

    void clamp() {
        const vec3 before = local_sum(limited_);
        step({"S₀", local_, before, "clamp", "local light before the clamp"});
        step({"S", "min(1, S₀)", limit_to_one(before), "clamp", "local light after the clamp", "",
              "clamp = true: as the report's program, 1 a channel"});
        step({"C", "S − S₀", limited_.clamp, "clamp", "what the clamp takes"});
    }

    void absorb() {
        if (!absorbs()) return;
        give({"σ", "", scene_.material(node_.interiors.front()).absorption, "absorption",
              "absorption a unit of length, in the solid around the ray"});
        step({"β", "e^(−σ · t)", node_.transmittance, "absorption",
              "what is left after the way (Beer, Lambert)", "", "ours: the report's glass does not absorb"});
    }

    void end_local_terms() {
        if (local_.empty()) return;
        weigh_local();
        const MaterialRecord& m = material();
        if (m.ambient > 0.0f) term("ambient", "a", "ambient light that counts", Term::ambient, true);
        if (m.diffuse > 0.0f) term("diffuse", "ΣD", "diffuse light that counts", Term::diffuse, true);
        if (m.highlight > 0.0f) term("highlight", "ΣH", "highlight that counts", Term::highlight, true);
        if (clamps()) term("clamp", "C", "what the clamp takes of it", Term::clamp, true);
    }

    void weigh_local() {
        if (!node_.goes_on()) {
            const char* note =
                node_.end == RayEnd::depth_limit ? "at the depth limit the local light counts whole" : "";
            return step({"w", "1", node_.local_weight, "weight", "weight of the local light", "2.1", note});
        }
        const bool balanced = scene_.settings.energy == Energy::balanced;
        step({"w", balanced ? "max(0, (1 − τ) − ρ)" : "1 − τ", node_.local_weight, "weight",
              "weight of the local light", "2.1",
              balanced ? "energy = \"balanced\": no more light leaves than arrives"
                       : "as the report's pictures: local light is not scaled by 1 − ρ"});
    }

    void term(const char* symbol, std::string formula, const char* meaning, Term which, bool weighted) {
        if (weighted) formula += " · w";
        if (absorbs()) formula += " ⊙ β";
        step({symbol, std::move(formula), node_.terms[which], symbol, meaning});
        join(sum_, symbol);
    }

    void emit() {
        if (node_.reflected >= 0) join(sum_, "reflection");
        if (node_.refracted >= 0) join(sum_, "transmission");
        const vec3 emission = emitted(material(), node_.entering);
        if (emission == vec3(0.0f)) return;
        give({"M", "", emission, "material", "emission"});
        term("emission", "M", "the surface's own light", Term::emission, false);
    }

    void add_up() {
        step({"L", sum_.empty() ? "0" : sum_, node_.radiance, "radiance", "what comes back along the ray",
              "2.1"});
    }

    void weigh_gain() {
        const MaterialRecord& m = material();
        const bool balanced = scene_.settings.energy == Energy::balanced;
        const float brightest = std::max({node_.color.x, node_.color.y, node_.color.z});
        out_.gain = shading::light_gain(brightest, m.diffuse, m.reflectivity, m.transparency, balanced);
        step({"gain", std::string(balanced ? "max(0, (1 − τ) − ρ)" : "(1 − τ)") + " · max(c) · k_d + ρ + τ",
              out_.gain, "gain", "light that can leave for each light that arrives", "",
              out_.gain > 1.0000001f
                  ? "above 1: more light leaves than arrives; energy = \"balanced\" prevents it"
                  : ""});
    }

    const ExplainedScene& scene_;
    const RayTree& tree_;
    const RayNode& node_;
    ExplainedRay& out_;
    LocalTerms limited_{};
    std::string local_; ///< the local terms there are
    std::string sum_;   ///< all terms there are
};

} // namespace

std::string numbered(const char* symbol, std::size_t number) {
    static constexpr const char* digits[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string subscript = digits[number % 10];
    while (number /= 10) subscript = digits[number % 10] + subscript;
    return symbol + subscript;
}

ExplainedScene::ExplainedScene(const scene::SceneData& scene_data)
    : scene(scene_data), settings(scene_data.description.whitted), modes(scene::whitted_modes(settings)),
      numbers(object_numbers(scene_data.description)) {
    const std::vector<Light>& lights = scene_data.description.lights;
    for (std::uint32_t i = 0; i < lights.size(); ++i)
        if (!std::holds_alternative<AmbientLight>(lights[i].kind)) light_numbers.push_back(i);
}

const std::string& ExplainedScene::material_name(std::uint32_t object) const {
    return scene.description.materials[scene.objects[object].material].name;
}

std::vector<ExplainedRay> explain_tree(const ExplainedScene& scene, const RayTree& tree, float min_weight,
                                       const CancelFlag* cancel) {
    std::vector<ExplainedRay> rays(tree.nodes.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        stop_if_cancelled(cancel);
        const RayNode& node = tree.nodes[i];
        // Parents precede their children.
        if (node.parent >= 0) {
            const auto parent = static_cast<std::size_t>(node.parent);
            const RayNode& from = tree.nodes[parent];
            rays[i].weight = rays[parent].weight * from.transmittance * branch_weight(from, node.kind);
        }
        RayWorking working(scene, tree, node, rays[i]);
        const vec3& w = rays[i].weight;
        max(w.x, max(w.y, w.z)) < min_weight ? working.copy_path() : working.explain();
    }
    return rays;
}

} // namespace glint::rendering
