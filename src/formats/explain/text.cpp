// The ray tree of a pixel as text.

#include "scene/text.h"
#include "formats/explain/formula.h"
#include "glint/error.h"
#include "glint/explanation_files.h"

#include <algorithm>

namespace glint {

using formats::number_text;
using formats::Scope;

namespace {

constexpr int digits = formats::readable_digits;
constexpr std::size_t longest_line = 100;

/// Terminal escape sequences, or empty strings.
struct Colors {
    explicit Colors(bool on)
        : strong(on ? "\x1b[1m" : ""), name(on ? "\x1b[36m" : ""), value(on ? "\x1b[32m" : ""),
          faint(on ? "\x1b[2m" : ""), plain(on ? "\x1b[0m" : "") {}
    const char* strong;
    const char* name;
    const char* value;
    const char* faint;
    const char* plain;
};

std::string text_of(const Quantity& q) { return quantity_text(q, digits); }

/// Width in characters, not bytes.
std::size_t width(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::ranges::count_if(text, scene::continues_utf8));
}

std::string angle(float degrees) { return number_text(degrees, 4) + "°"; }

class TextTree {
  public:
    TextTree(const Explanation& explanation, bool color) : explanation_(explanation), c_(color) {}

    std::string write() {
        const Explanation& e = explanation_;
        const std::string size = std::to_string(e.width) + "×" + std::to_string(e.height);
        line(c_.strong + std::string("pixel ") + std::to_string(e.x) + "," + std::to_string(e.y) + c_.plain +
             " of " + size + " = " + c_.value + text_of(e.color) + c_.plain +
             " (linear red, green, blue; computed on the CPU)");
        if (e.gpu) line("  " + other_pixel_text(e, *e.gpu));
        line("  " + e.rule + (e.samples.size() > 1 ? " (" + e.filter + " filter)" : ""));
        line("  = " + terms_text(e.terms));
        const std::string origin = formats::origin_text(e);
        if (!origin.empty()) line("  " + origin);
        for (std::size_t i = 0; i < e.samples.size(); ++i) {
            if (e.samples.size() > 1) write_sample(e.samples[i], i);
            write_ray(e.samples[i], 0, "", "");
        }
        return std::move(text_);
    }

  private:
    void line(const std::string& text) { text_ += text + "\n"; }

    /// The non-zero terms: "ambient (…) + reflection (…)".
    static std::string terms_text(const std::array<glm::vec3, term_count>& terms) {
        std::string text;
        for (int i = 0; i < term_count; ++i) {
            const glm::vec3& term = terms[static_cast<std::size_t>(i)];
            if (term == glm::vec3(0.0f)) continue;
            text += (text.empty() ? "" : " + ") + std::string(term_name(static_cast<Term>(i))) + " " +
                    text_of(term);
        }
        return text.empty() ? "0" : text;
    }

    void write_sample(const ExplainedSample& s, std::size_t index) {
        line("");
        line(c_.strong + std::string("sample ") + std::to_string(index + 1) + c_.plain + " at (" +
             number_text(s.dx, digits) + ", " + number_text(s.dy, digits) +
             ") pixels from the centre, weight " + number_text(s.weight, digits) +
             (s.counts ? "" : ", left out") + " = " + c_.value + text_of(s.radiance) + c_.plain);
    }

    void write_ray(const ExplainedSample& sample, std::size_t index, const std::string& head,
                   const std::string& body) {
        const ExplainedRay& ray = sample.rays[index];
        const bool branches = ray.reflected >= 0 || ray.refracted >= 0;
        const std::string inner = body + (branches ? "│ " : "  ");
        line(head + c_.strong + ray_kind_name(ray.kind) + " ray" + c_.plain + " brings " + c_.value +
             text_of(ray.radiance) + c_.plain + ", weight in the sample " + text_of(ray.weight));
        write_path(ray, inner);
        for (const ExplainedLight& light : ray.lights) write_light(ray, light, inner);
        write_steps(Scope(ray), ray.steps, inner);
        line(inner + ray.why);
        if (branches) line(body + "│");
        if (ray.reflected >= 0) write_child(sample, ray.reflected, body, ray.refracted < 0);
        if (ray.refracted >= 0) write_child(sample, ray.refracted, body, true);
    }

    void write_child(const ExplainedSample& sample, int index, const std::string& body, bool last) {
        write_ray(sample, static_cast<std::size_t>(index), body + (last ? "└─ " : "├─ "),
                  body + (last ? "   " : "│  "));
    }

    void write_path(const ExplainedRay& ray, const std::string& inner) {
        line(inner + "from " + text_of(ray.origin) + " along " + text_of(ray.direction));
        if (!ray.inside.empty()) line(inner + "inside " + printable(scene::listed(ray.inside, ", within ")));
        for (const std::string& label : ray.passed_over)
            line(inner + "passes over " + printable(label) + ": hidden inside a solid that owns the space");
        if (!ray.hit) return;
        line(inner + "hits " + c_.strong + printable(ray.label) + c_.plain + " (material " +
             printable(ray.material) + ") from " + (ray.entering ? "outside" : "inside") + ", distance " +
             number_text(ray.distance, digits));
        if (ray.crosses) line(inner + bending(ray));
        write_given(ray.given, inner);
    }

    static std::string bending(const ExplainedRay& ray) {
        std::string text = "index " + number_text(ray.index_before, digits) + " to " +
                           number_text(ray.index_after, digits) + ": from " + angle(ray.degrees_before);
        text += ray.total_reflection ? " total reflection" : " to " + angle(ray.degrees_after);
        if (ray.index_after < ray.index_before) text += ", critical angle " + angle(ray.critical_degrees);
        return text;
    }

    /// Writes given quantities, several per line.
    void write_given(const std::vector<Step>& given, const std::string& inner) {
        std::string row;
        for (const Step& step : given) {
            const std::string item = step.symbol + " = " + text_of(step.result);
            if (!row.empty() && width(row) + width(item) + 3 > longest_line) {
                line(inner + "  " + row);
                row.clear();
            }
            row += (row.empty() ? "" : ",  ") + item;
        }
        if (!row.empty()) line(inner + "  " + row);
    }

    void write_light(const ExplainedRay& ray, const ExplainedLight& light, const std::string& inner) {
        line(inner + c_.strong + printable(light.label) + c_.plain + ": distance " +
             number_text(light.distance, digits) + ", n·l = " + number_text(light.cosine, digits) + " (" +
             angle(light.degrees) + "), " +
             (light.arriving == glm::vec3(0.0f) ? "nothing arrives"
                                                : "gets through: " + number_text(light.shadow, digits)));
        if (light.asked)
            line(inner + "  shadow ray from " + text_of(light.shadow_origin) + " along " +
                 text_of(light.direction));
        for (const Blocker& b : light.blockers)
            line(inner + "  blocked at " + number_text(b.distance, digits) + " by " + printable(b.label) +
                 " (material " + printable(b.material) + "), τ = " + number_text(b.transparency, digits) +
                 (b.passed_over ? ", passed over" : ""));
        write_steps(Scope(ray, &light), light.steps, inner);
    }

    void write_steps(const Scope& scope, const std::vector<Step>& steps, const std::string& inner) {
        for (const Step& step : steps)
            if (!step.formula.empty()) write_step(scope, step, inner);
    }

    /// Writes "D = E ⊙ c · k_d · s = … = …" on as many lines as needed.
    void write_step(const Scope& scope, const Step& step, const std::string& inner) {
        const std::string numbers = scope.filled_in(step);
        const std::string result = text_of(step.result);
        // A formula that is just a number equals its result.
        const std::string formula = step.formula == result ? "" : " = " + step.formula;
        const std::string left = step.symbol + formula;
        const std::string aside =
            std::string(step.meaning) + (*step.section ? " [" + std::string(step.section) + "]" : "");
        const std::string colored = c_.name + step.symbol + c_.plain + formula;
        const std::string value = c_.value + result + c_.plain;
        const std::string middle = numbers.empty() ? "" : " = " + numbers;
        const bool short_enough =
            width(left) + width(middle) + width(result) + width(aside) + 8 <= longest_line;
        if (short_enough) {
            line(inner + "  " + colored + middle + " = " + value + "   " + c_.faint + aside + c_.plain);
        } else {
            line(inner + "  " + colored + "   " + c_.faint + aside + c_.plain);
            if (!middle.empty()) line(inner + "     " + middle.substr(1));
            line(inner + "     = " + value);
        }
        if (*step.note) line(inner + "     " + c_.faint + "(" + step.note + ")" + c_.plain);
    }

    const Explanation& explanation_;
    const Colors c_;
    std::string text_;
};

} // namespace

std::string explanation_text(const Explanation& explanation, bool color) {
    return TextTree(explanation, color).write();
}

} // namespace glint
