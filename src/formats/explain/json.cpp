// Explanations as JSON. Names are stable: docs/explain.md lists them.

#include "formats/explain/formula.h"
#include "formats/explain/markup.h"
#include "glint/explanation_files.h"
#include "scene/text.h"

namespace glint {

using formats::json_number;
using formats::Scope;

namespace {

std::string json_vector(const glm::vec3& v) {
    return "[" + json_number(v.x) + ", " + json_number(v.y) + ", " + json_number(v.z) + "]";
}

std::string json_quantity(const Quantity& q) {
    return q.vector ? json_vector(q.value) : json_number(q.value.x);
}

std::string json_index(int index) { return index < 0 ? "null" : std::to_string(index); }
const char* json_bool(bool value) { return value ? "true" : "false"; }

/// Writes the members of an object; values are JSON already.
class Members {
  public:
    Members& add(const char* name, const std::string& value) {
        text_ += (text_.empty() ? "" : ", ") + ("\"" + std::string(name) + "\": ") + value;
        return *this;
    }
    Members& words(const char* name, const std::string& text) { return add(name, formats::json_text(text)); }
    /// Omitted if empty.
    Members& perhaps(const char* name, const std::string& text) {
        return text.empty() ? *this : words(name, text);
    }
    std::string object() const { return "{" + text_ + "}"; }

  private:
    std::string text_;
};

/// Joins elements, one per line, indented.
std::string lines(const std::vector<std::string>& elements, int indent) {
    if (elements.empty()) return "[]";
    const std::string space(static_cast<std::size_t>(indent), ' ');
    std::string text = "[";
    for (const std::string& element : elements) text += (text.size() > 1 ? ",\n " : "\n ") + space + element;
    return text + "\n" + space + "]";
}

std::string json_terms(const std::array<glm::vec3, term_count>& terms) {
    Members members;
    for (int i = 0; i < term_count; ++i)
        members.add(term_name(static_cast<Term>(i)), json_vector(terms[static_cast<std::size_t>(i)]));
    return members.object();
}

std::string json_step(const Scope& scope, const Step& step) {
    Members members;
    members.words("symbol", step.symbol).words("topic", step.topic).words("meaning", step.meaning);
    members.perhaps("section", step.section);
    if (!step.formula.empty()) {
        Members values;
        for (const Step* named : scope.named_in(step.formula))
            values.add(named->symbol.c_str(), json_quantity(named->result));
        members.words("formula", step.formula).add("values", values.object());
    }
    return members.add("result", json_quantity(step.result)).perhaps("note", step.note).object();
}

std::string json_steps(const Scope& scope, const std::vector<const std::vector<Step>*>& lists, int indent) {
    std::vector<std::string> elements;
    for (const std::vector<Step>* list : lists)
        for (const Step& step : *list) elements.push_back(json_step(scope, step));
    return lines(elements, indent);
}

std::string json_blocker(const Blocker& b) {
    return Members()
        .add("object", std::to_string(b.number))
        .words("label", b.label)
        .words("material", b.material)
        .add("distance", json_number(b.distance))
        .add("transparency", json_number(b.transparency))
        .add("share", json_number(b.share))
        .add("passed_over", json_bool(b.passed_over))
        .object();
}

/// Where it is written; null for what comes from no file.
std::string json_place(const Location& where) {
    return where.line > 0 ? formats::json_text(to_string(where)) : "null";
}

std::string json_light(const ExplainedRay& ray, const ExplainedLight& light) {
    std::vector<std::string> blockers;
    for (const Blocker& b : light.blockers) blockers.push_back(json_blocker(b));
    Members members;
    members.add("light", std::to_string(light.light)).words("label", light.label);
    members.add("where", json_place(light.where));
    members.add("direction", json_vector(light.direction)).add("distance", json_number(light.distance));
    members.add("cosine", json_number(light.cosine)).add("angle", json_number(light.degrees));
    members.add("attenuation", json_number(light.attenuation)).add("arriving", json_vector(light.arriving));
    members.add("shadow_ray", light.asked ? json_vector(light.shadow_origin) : "null");
    members.add("blockers", lines(blockers, 6)).add("shadow", json_number(light.shadow));
    members.add("diffuse", json_vector(light.diffuse)).add("highlight", json_vector(light.highlight));
    members.add("steps", json_steps(Scope(ray, &light), {&light.steps}, 6));
    return members.object();
}

std::string json_hit(const ExplainedRay& ray) {
    if (!ray.hit) return "null";
    return Members()
        .add("object", std::to_string(ray.number))
        .words("label", ray.label)
        .add("where", json_place(ray.where))
        .words("material", ray.material)
        .words("side", ray.entering ? "outside" : "inside")
        .add("distance", json_number(ray.distance))
        .add("position", json_vector(ray.position))
        .add("geometric_normal", json_vector(ray.geometric_normal))
        .add("shading_normal", json_vector(ray.shading_normal))
        .add("color", json_vector(ray.color))
        .add("gain", json_number(ray.gain))
        .object();
}

std::string json_refraction(const ExplainedRay& ray) {
    if (!ray.crosses) return "null";
    return Members()
        .add("index_before", json_number(ray.index_before))
        .add("index_after", json_number(ray.index_after))
        .add("angle_before", json_number(ray.degrees_before))
        .add("angle_after", ray.total_reflection ? "null" : json_number(ray.degrees_after))
        .add("critical_angle", ray.critical_degrees < 90 ? json_number(ray.critical_degrees) : "null")
        .add("total_reflection", json_bool(ray.total_reflection))
        .object();
}

std::string json_ray(const ExplainedRay& ray) {
    std::vector<std::string> lights;
    for (const ExplainedLight& light : ray.lights) lights.push_back(json_light(ray, light));
    Members members;
    members.words("kind", ray_kind_name(ray.kind)).add("depth", std::to_string(ray.depth));
    members.add("parent", json_index(ray.parent)).add("reflected", json_index(ray.reflected));
    members.add("refracted", json_index(ray.refracted));
    members.add("origin", json_vector(ray.origin)).add("direction", json_vector(ray.direction));
    members.add("weight", json_vector(ray.weight)).add("inside", formats::json_list(ray.inside));
    members.add("passed_over", formats::json_list(ray.passed_over)).add("hit", json_hit(ray));
    members.add("refraction", json_refraction(ray)).words("end", ray_end_name(ray.end)).words("why", ray.why);
    members.add("transmittance", json_vector(ray.transmittance));
    members.add("lights", lines(lights, 4));
    members.add("steps", json_steps(Scope(ray), {&ray.given, &ray.steps}, 4));
    members.add("terms", json_terms(ray.terms)).add("radiance", json_vector(ray.radiance));
    return members.object();
}

std::string json_sample(const ExplainedSample& s) {
    std::vector<std::string> rays;
    for (const ExplainedRay& ray : s.rays) rays.push_back(json_ray(ray));
    Members members;
    members.add("offset", "[" + json_number(s.dx) + ", " + json_number(s.dy) + "]");
    members.add("weight", json_number(s.weight)).add("counts", json_bool(s.counts));
    members.add("terms", json_terms(s.terms)).add("radiance", json_vector(s.radiance));
    return members.add("rays", lines(rays, 2)).object();
}

std::string json_gpu(const Explanation& e) {
    if (!e.gpu) return "null";
    return Members()
        .words("device", e.gpu->device)
        .add("color", json_vector(e.gpu->color))
        .add("difference", json_vector(e.gpu->color - e.color))
        .object();
}

} // namespace

std::string explanation_json(const Explanation& e) {
    std::vector<std::string> samples;
    for (const ExplainedSample& sample : e.samples) samples.push_back(json_sample(sample));
    Members members;
    members.words("scene", e.scene);
    members.add("pixel", "[" + std::to_string(e.x) + ", " + std::to_string(e.y) + "]");
    members.add("size", "[" + std::to_string(e.width) + ", " + std::to_string(e.height) + "]");
    members.add("relative_to", "[" + scene::show(e.origin) + "]");
    members.words("filter", e.filter).words("rule", e.rule).words("backend", "cpu");
    members.add("color", json_vector(e.color)).add("gpu", json_gpu(e));
    members.add("terms", json_terms(e.terms)).add("samples", lines(samples, 0));
    return members.object() + "\n";
}

} // namespace glint
