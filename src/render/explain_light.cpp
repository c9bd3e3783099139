// Explains one light at a hit.

#include "render/explain_parts.h"

#include "math/trig.h"
#include "shading/whitted.shared.h"

namespace glint::rendering {
namespace {

/// The position of the light, and how much of it arrives.
class Arrival {
  public:
    Arrival(const LightRecord& light, const RayNode& node, const LightNode& record, ExplainedLight& out)
        : light_(light), node_(node), record_(record), out_(out), n_(node.shading_normal * node.lit_side),
          n_g_(node.geometric_normal * node.lit_side) {}

    void explain() {
        const bool has_position = light_.kind != light_directional;
        step(
            {"I", "", light_.strength, "light", has_position ? "colour · intensity" : "colour · irradiance"});
        has_position ? find_position() : find_direction();
        if (has_position && !(record_.distance > 0.0f)) return at_the_light();
        find_angle();
        if (light_.kind == light_spot) find_falloff();
        arrive();
    }

  private:
    void step(Step s) { out_.steps.push_back(std::move(s)); }

    void find_position() {
        const vec3 way = light_.position - node_.position;
        r_squared_ = dot(way, way);
        step({"x", "", light_.position, "light", "where the light stands"});
        step({"r²", "(x − p)·(x − p)", r_squared_, "light", "squared distance", "2.2"});
        step({"r", "√(r²)", record_.distance, "light", "distance", "2.2"});
        if (record_.distance > 0.0f)
            step({"l", "(x − p) / r", record_.direction, "light", "direction to the light", "2.2"});
    }

    void find_direction() {
        step({"l", "", record_.direction, "light", "direction to the light", "",
              "ours: a directional light shines along one direction everywhere; it has no distance"});
    }

    void at_the_light() {
        step({"E", "0", record_.arriving, "light", "light arriving", "",
              "the point lies in the light itself"});
    }

    void find_angle() {
        const char* n = "n·l";
        if (node_.lit_side < 0.0f) {
            n = "n′·l";
            step({"n′", "−n", n_, "light", "normal that lights find", "",
                  "facing = \"stored\": the mesh is lit as its winding has it, through its back"});
        }
        out_.degrees = static_cast<float>(acos_degrees(dot(n_, record_.direction)));
        step({"θ", std::string("arccos(") + n + ")", out_.degrees, "light", "angle to the normal, degrees"});
        const bool above = dot(n_g_, record_.direction) > 0.0f;
        const std::string clamped = std::string("max(0, ") + n + ")";
        step({"cosθ", above ? clamped : "0", record_.cosine, "light", "share that falls on the surface",
              "2.2",
              above ? "the report does not clamp n·l at 0; its pictures do"
                    : "the light stands below the geometric horizon, n_g·l ≤ 0: nothing arrives, no shadow "
                      "ray"});
    }

    void find_falloff() {
        const float cosine = -dot(record_.direction, light_.direction);
        falloff_ = spot_falloff(cosine, light_.cos_outer, light_.cos_inner);
        step({"a", "", light_.direction, "light", "axis of the spot"});
        step({"cosα", "−(l·a)", cosine, "light", "cosine of the angle from the axis"});
        step({"cosα₁", "", light_.cos_inner, "light", "of the inner cone"});
        step({"cosα₂", "", light_.cos_outer, "light", "of the outer cone"});
        if (cosine >= light_.cos_inner || cosine <= light_.cos_outer) {
            const bool inside = cosine >= light_.cos_inner;
            return step({"f", inside ? "1" : "0", falloff_, "light", "falloff of the spot", "",
                         inside ? "inside the inner cone" : "outside the outer cone"});
        }
        const float u = spot_ramp(cosine, light_.cos_outer, light_.cos_inner);
        step({"u", "(cosα − cosα₂) / (cosα₁ − cosα₂)", u, "light", "way from the outer to the inner cone"});
        step({"f", "u² · (3 − 2 · u)", falloff_, "light", "falloff of the spot", "",
              "ours: the report has no spots"});
    }

    void arrive() {
        if (light_.kind == light_directional)
            return step({"E", "I · cosθ", record_.arriving, "light", "light arriving"});
        out_.attenuation = falloff_ / r_squared_;
        const bool spot = light_.kind == light_spot;
        step({"q", spot ? "f / r²" : "1 / r²", out_.attenuation, "light", "attenuation", "2.2"});
        step({"E", spot ? "I · (cosθ / r²) · f" : "I · (cosθ / r²)", record_.arriving, "light",
              "light arriving", "2.2"});
    }

    const LightRecord& light_;
    const RayNode& node_;
    const LightNode& record_;
    ExplainedLight& out_;
    const vec3 n_;
    const vec3 n_g_;
    float r_squared_ = 0;
    float falloff_ = 1;
};

/// The shadow ray, and the light that the surface reflects.
class Shown {
  public:
    Shown(const ExplainedScene& scene, const RayNode& node, const LightNode& record, ExplainedLight& out)
        : scene_(scene), material_(scene.material(node.hit.object)), node_(node), record_(record), out_(out) {
    }

    void explain() {
        if (record_.arriving == vec3(0.0f)) return;
        name_blockers();
        weigh_shadow();
        if (material_.diffuse > 0.0f) show_diffuse();
        if (material_.highlight > 0.0f) show_highlight();
    }

  private:
    void step(Step s) { out_.steps.push_back(std::move(s)); }
    bool opaque() const { return scene_.modes.opaque_shadows != 0; }
    /// Have the surfaces on the way a colour?
    bool tinted() const { return record_.passing != vec3(record_.shadow); }
    const char* times() const { return tinted() ? " ⊙ " : " · "; }

    void name_blockers() {
        const float length = sqrt(dot(record_.shadow_direction, record_.shadow_direction));
        for (Blocker& b : out_.blockers) {
            b.number = scene_.numbers[b.object];
            b.label = scene_.label(b.object);
            b.material = scene_.material_name(b.object);
            b.distance = b.distance * length;
            b.share = b.passed_over ? 1.0f : shadow_transmittance(scene_.modes, b.transparency);
        }
    }

    void weigh_shadow() {
        const char* note = "nothing stands between";
        std::string formula = "1";
        if (!out_.asked) {
            note = "no shadow ray: the surface shows neither diffuse light nor highlight";
        } else if (!out_.blockers.empty()) {
            formula = product_of_blockers();
            note = opaque() ? "shadows = \"opaque\": glass casts full shadows, as in the report's pictures"
                            : "shadow through glass: not bent, not absorbed, not reflected; the model omits "
                              "caustics";
            if (out_.shadow == 0.0f && !opaque()) note = "something opaque stands between";
        }
        step({"s", std::move(formula), tinted() ? Quantity(record_.passing) : Quantity(record_.shadow),
              "shadow", "share that gets through", "2.1", note});
    }

    /// Gives the blockers' shares as τ₁, τ₂ … and returns what multiplies them.
    std::string product_of_blockers() {
        std::string formula;
        for (std::size_t i = 0; i < out_.blockers.size(); ++i) {
            const Blocker& b = out_.blockers[i];
            if (b.passed_over) continue;
            const std::string symbol = numbered("τ", i + 1);
            const vec3& tint = scene_.material(b.object).transmitted_tint;
            step({symbol, "", tint == vec3(1.0f) ? Quantity(b.share) : Quantity(tint * b.share), "shadow",
                  "what a surface on the way lets through"});
            formula += (formula.empty() ? "" : times()) + symbol;
        }
        return formula.empty() ? "1" : formula;
    }

    void show_diffuse() {
        const vec3 whole = diffuse_term(record_.arriving, node_.color, material_.diffuse) * record_.passing;
        const bool clamp = scene_.settings.clamp;
        step({clamp ? "D′" : "D", std::string("E ⊙ c · k_d") + times() + "s", whole, "diffuse",
              clamp ? "diffuse light before the clamp" : "diffuse light", "2.2",
              "the report prints sums of colours; its pictures show products"});
        if (clamp)
            step({"D", "min(1, D′)", record_.diffuse, "diffuse", "diffuse light after the clamp", "",
                  "clamp = true: as the report's program, 1 a channel for each light"});
    }

    void show_highlight() {
        const vec3 n = node_.shading_normal * node_.lit_side;
        const std::string normal = node_.lit_side < 0.0f ? "n′" : "n";
        const vec3 v = -node_.direction;
        const vec3 l = record_.direction;
        const float cosine = highlight_cosine(scene_.modes, n, l, v);
        if (scene_.modes.highlight == highlight_blinn) {
            const bool opposite = !(dot(l + v, l + v) > 0.0f);
            step({"cosδ", opposite ? "0" : normal + "·(l + v) / |l + v|", cosine, "highlight",
                  "n·h, h the halfway vector", "2.5"});
        } else {
            step({"R_l", normal + " · (2 · (" + normal + "·l)) − l", mirror_direction(l, n), "highlight",
                  "mirror direction of the light", "2.5"});
            step({"cosδ", "v·R_l", cosine, "highlight", "v·R, Phong's cosine", "2.5"});
        }
        const float lobe = lobe_of(cosine, material_.shininess);
        step(
            {"lobe", "min(1, max(0, cosδ))^m", lobe, "highlight", "how near to the mirror direction", "2.5"});
        const bool metal = material_.reflected_tint != vec3(1.0f);
        step({"H", std::string(metal ? "E ⊙ t_R · (k · lobe)" : "E · (k · lobe)") + times() + "s",
              record_.highlight, "highlight", "highlight", "2.5",
              metal ? "metals tint it"
                    : "the report's formula has neither n·l nor 1/r², its pictures have both; the light's "
                      "colour, not the material's"});
    }

    const ExplainedScene& scene_;
    const MaterialRecord& material_;
    const RayNode& node_;
    const LightNode& record_;
    ExplainedLight& out_;
};

} // namespace

ExplainedLight explain_light(const ExplainedScene& scene, const RayNode& node, std::size_t index) {
    const LightRecord& light = scene.scene.lights[index];
    const LightNode& record = node.lights[index];
    ExplainedLight out;
    static_cast<TracedLight&>(out) = record;
    out.light = scene.light_numbers[index];
    out.label = light_label(scene.scene.description, out.light);
    out.where = scene.scene.description.lights[out.light].where;
    Arrival(light, node, record, out).explain();
    Shown(scene, node, record, out).explain();
    return out;
}

} // namespace glint::rendering
