// Explains mirror and refracted rays.

#include "render/explain_parts.h"

#include "math/trig.h"
#include "shading/whitted.shared.h"

namespace glint::rendering {
namespace {

const char* const wrong_side = "the smooth normal would send the ray through the surface: the geometric one "
                               "serves instead";

class BounceSteps {
  public:
    BounceSteps(const ExplainedScene& scene, const RayTree& tree, const RayNode& node, ExplainedRay& out)
        : material_(scene.material(node.hit.object)), tree_(tree), node_(node), out_(out),
          v_(-node.direction), solid_(scene.scene.objects[node.hit.object].solid),
          refraction_(node.refraction) {}

    void explain() {
        if (material_.transparency > 0.0f && solid_) refraction();
        if (material_.transparency > 0.0f && !solid_) pane();
        weights();
        if (node_.reflected >= 0) mirror();
        branch(true);
        branch(false);
    }

  private:
    void step(Step s) { out_.steps.push_back(std::move(s)); }
    const RayNode& child(int index) const { return tree_.nodes[static_cast<std::size_t>(index)]; }
    bool fresnel() const {
        return (material_.flags & material_fresnel) != 0 && solid_ && !node_.total_reflection;
    }

    /// Snell's law, with the angles on both sides.
    void refraction() {
        const float n_1 = node_.index_before;
        const float n_2 = node_.index_after;
        const bool by_shading_normal = refraction_.n == node_.shading_normal;
        const std::string n = by_shading_normal ? "n" : "n_g";
        step({"n₁", "", n_1, "refraction", "index of refraction before", "2.4"});
        step({"n₂", "", n_2, "refraction", "index of refraction behind", "2.4"});
        step({"η", "n₁ / n₂", refraction_.eta, "refraction", "ratio of the indices", "2.4"});
        step({"cosθ₁", n + "·v", refraction_.cosine, "refraction", "angle before, as its cosine", "2.4",
              by_shading_normal ? "" : wrong_side});
        angles();
        step({"Δ", "1 − η² · max(0, 1 − cosθ₁²)", refraction_.discriminant, "refraction",
              "what stands under the root", "2.4",
              node_.total_reflection ? "below 0: no refracted ray, all of the light goes back inside" : ""});
        if (node_.refracted >= 0) direction(n);
        if (fresnel()) reflectance();
    }

    void angles() {
        const float sine_1 = sqrt(max(0.0f, 1.0f - refraction_.cosine * refraction_.cosine));
        const float sine_2 = refraction_.eta * sine_1;
        out_.crosses = true;
        out_.degrees_before = static_cast<float>(acos_degrees(refraction_.cosine));
        out_.degrees_after = node_.total_reflection ? 90.0f : static_cast<float>(asin_degrees(sine_2));
        step({"θ₁", "arccos(cosθ₁)", out_.degrees_before, "refraction", "angle before, degrees"});
        step({"sinθ₁", "√(max(0, 1 − cosθ₁²))", sine_1, "refraction", "its sine"});
        step({"sinθ₂", "η · sinθ₁", sine_2, "refraction", "Snell: n₁ sin θ₁ = n₂ sin θ₂", "2.4",
              node_.total_reflection ? "above 1: there is no such angle" : ""});
        const float left = node_.index_before * sine_1;
        step({"n₁sinθ₁", "n₁ · sinθ₁", left, "refraction", "one side of Snell's law"});
        step({"n₂sinθ₂", "n₂ · sinθ₂", node_.index_after * sine_2, "refraction", "the other side"});
        if (!node_.total_reflection)
            step({"θ₂", "arcsin(sinθ₂)", out_.degrees_after, "refraction", "angle behind, degrees"});
        if (node_.index_after < node_.index_before) {
            out_.critical_degrees = static_cast<float>(asin_degrees(node_.index_after / node_.index_before));
            step({"θ_c", "arcsin(n₂ / n₁)", out_.critical_degrees, "refraction",
                  "critical angle, degrees: beyond it the reflection is total"});
        }
    }

    void direction(const std::string& n) {
        const vec3& t = child(node_.refracted).direction;
        if (refraction_.eta == 1.0f)
            return step({"T", "−v", t, "refraction", "refracted direction", "2.4", "equal indices"});
        step({"T", "normalize(" + n + " · (η · (" + n + "·v) − √(Δ)) − v · η)", t, "refraction",
              "refracted direction", "2.4"});
    }

    void reflectance() {
        const float c_1 = refraction_.cosine;
        const float c_2 = sqrt(refraction_.discriminant);
        const float n_1 = node_.index_before;
        const float n_2 = node_.index_after;
        const char* ours = "ours: the report has no Fresnel; Born and Wolf, section 1.5.2";
        step({"cosθ₂", "√(Δ)", c_2, "refraction", "angle behind, as its cosine"});
        step({"r_s", "(n₁ · cosθ₁ − n₂ · cosθ₂) / (n₁ · cosθ₁ + n₂ · cosθ₂)", fresnel_s(c_1, c_2, n_1, n_2),
              "refraction", "light swinging across the plane of incidence"});
        step({"r_p", "(n₂ · cosθ₁ − n₁ · cosθ₂) / (n₂ · cosθ₁ + n₁ · cosθ₂)", fresnel_p(c_1, c_2, n_1, n_2),
              "refraction", "and within it"});
        step({"F", "0.5 · (r_s² + r_p²)", fresnel_reflectance(c_1, c_2, n_1, n_2), "refraction",
              "Fresnel: the share that is reflected", "", ours});
    }

    void pane() {
        step({"T", "−v", child_direction(), "refraction", "direction behind the pane", "",
              "a thin pane, not a solid: straight on, without Snell's law"});
    }
    vec3 child_direction() const {
        return node_.refracted >= 0 ? child(node_.refracted).direction : node_.direction;
    }

    /// The weights of the branches.
    void weights() {
        const char* reflected = "ρ";
        const char* refracted = "τ";
        const char* note = "";
        if (node_.total_reflection) {
            reflected = "ρ + τ";
            note = "total reflection: one mirror ray carries both shares";
        } else if (fresnel()) {
            reflected = "(ρ + τ) · F";
            refracted = "(ρ + τ) · (1 − F)";
            note = "fresnel = true: ρ + τ is shared by Fresnel's equations";
        }
        if (node_.reflected_weight > 0.0f)
            step(weighted({"w_R", reflected, node_.reflected_weight, "reflection", "weight of the mirror ray",
                           "2.3", note},
                          "t_R", node_.reflected_tint));
        if (node_.refracted_weight > 0.0f && node_.refracted_tint != vec3(1.0f))
            step({"t_T", "", node_.refracted_tint, "material", "tint of what is transmitted"});
        if (node_.refracted_weight > 0.0f)
            step(weighted({"w_T", refracted, node_.refracted_weight, "transmission",
                           "weight of the refracted ray", "2.4", note},
                          "t_T", node_.refracted_tint));
    }

    /// A weight by channel, where the material tints what it reflects or transmits.
    static Step weighted(Step s, const std::string& tint_symbol, const vec3& tint) {
        if (tint == vec3(1.0f)) return s;
        s.result = tint * s.result.value.x;
        const bool is_sum = s.formula.find(' ') != std::string::npos;
        s.formula = tint_symbol + " · " + (is_sum ? "(" + s.formula + ")" : s.formula);
        return s;
    }

    void mirror() {
        const vec3& direction = child(node_.reflected).direction;
        const bool shading = normalize(mirror_direction(v_, node_.shading_normal)) == direction;
        const std::string n = shading ? "n" : "n_g";
        step({"R", "normalize(" + n + " · (2 · (" + n + "·v)) − v)", direction, "reflection",
              "mirror direction", "2.3", shading ? "" : wrong_side});
    }

    /// The light of a branch, if it was followed, and the weight of its ray in the sample.
    void branch(bool mirror) {
        const int index = mirror ? node_.reflected : node_.refracted;
        const float share = mirror ? node_.reflected_weight : node_.refracted_weight;
        if (!(share > 0.0f)) return;
        const vec3& tint = mirror ? node_.reflected_tint : node_.refracted_tint;
        const std::string times = tint == vec3(1.0f) ? " · " : " ⊙ ";
        const char* weight = mirror ? "w_R" : "w_T";
        const std::string absorbed = node_.transmittance != vec3(1.0f) ? " ⊙ β" : "";
        if (index >= 0) {
            const char* topic = mirror ? "reflection" : "transmission";
            const char* light = mirror ? "L_R" : "L_T";
            step({light, "", child(index).radiance, topic,
                  mirror ? "what the mirror ray brings" : "what the refracted ray brings"});
            step({topic, light + times + weight + absorbed,
                  node_.terms[mirror ? Term::reflection : Term::transmission], topic,
                  mirror ? "light by way of the mirror ray" : "light by way of the refracted ray",
                  mirror ? "2.3" : "2.4"});
        }
        step({mirror ? "W_R" : "W_T", "W" + absorbed + times + weight,
              out_.weight * node_.transmittance *
                  branch_weight(node_, mirror ? RayKind::reflected : RayKind::refracted),
              "weight",
              mirror ? "the mirror ray's weight in the sample" : "the refracted ray's weight in the sample",
              "", index >= 0 ? "" : "below min_weight: this ray is left out"});
    }

    const MaterialRecord& material_;
    const RayTree& tree_;
    const RayNode& node_;
    ExplainedRay& out_;
    const vec3 v_;
    const bool solid_;
    const Refraction& refraction_;
};

} // namespace

void explain_bounce(const ExplainedScene& scene, const RayTree& tree, const RayNode& node,
                    ExplainedRay& ray) {
    BounceSteps(scene, tree, node, ray).explain();
}

} // namespace glint::rendering
