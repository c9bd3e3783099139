// The ray tree of a pixel as text.

#include "scene/text.h"
#include "formats/explain/branch.h"
#include "formats/explain/formula.h"
#include "glint/error.h"
#include "glint/explanation_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace glint {

using formats::number_text;
using formats::Scope;

namespace {

constexpr int digits = formats::readable_digits;
constexpr std::size_t longest_line = 100;
/// Branches that bring less of the sample's light are counted.
constexpr float min_share = 1.0f / 1000;

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

/// The largest channel.
float brightness(const glm::vec3& light) {
    return std::max({std::abs(light.x), std::abs(light.y), std::abs(light.z)});
}

class TextTree {
  public:
    TextTree(const Explanation& explanation, const ExplanationTextOptions& options)
        : explanation_(explanation), options_(options), c_(options.color) {
        require_index("sample", options.sample, explanation.samples.size(), "the pixel");
        if (options.ray) require_index("ray", *options.ray, sample().rays.size(), "the sample");
    }

    std::string write() {
        write_pixel();
        if (explanation_.samples.size() > 1) write_samples();
        if (options_.ray)
            write_ray_alone(sample().rays[static_cast<std::size_t>(*options_.ray)]);
        else if (options_.steps)
            write_ray(0, "", "");
        else
            write_tree();
        return std::move(text_);
    }

  private:
    static void require_index(const std::string& what, int index, std::size_t count, const char* owner) {
        if (index >= 0 && static_cast<std::size_t>(index) < count) return;
        throw Error(ErrorKind::usage, "there is no " + what + " " + std::to_string(index),
                    std::string(owner) + " has " + std::to_string(count) + ", numbered from 0");
    }

    void line(const std::string& text) { text_ += text + "\n"; }
    const ExplainedSample& sample() const {
        return explanation_.samples[static_cast<std::size_t>(options_.sample)];
    }

    void write_pixel() {
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
    }

    /// The first samples, one per line.
    void write_samples() {
        constexpr std::size_t most = 16;
        const std::size_t count = explanation_.samples.size();
        for (std::size_t i = 0; i < std::min(count, most); ++i) write_sample(explanation_.samples[i], i);
        if (count > most) line("… and " + std::to_string(count - most) + " more");
        line(c_.strong + std::string("the rays of sample ") + std::to_string(options_.sample) + c_.plain);
    }

    void write_tree() {
        line("ray   share of the light");
        write_branch(0, "", "");
    }

    /// The part of the sample's light that comes along a ray; where the sample is black, of its weight.
    float share(const ExplainedRay& ray) const {
        const float all = brightness(sample().radiance);
        return all > 0 ? brightness(ray.weight * ray.radiance) / all : brightness(ray.weight);
    }

    void write_branch(std::size_t index, const std::string& head, const std::string& body) {
        const ExplainedRay& ray = sample().rays[index];
        char columns[48];
        std::snprintf(columns, sizeof columns, "%3zu %6.1f %%  ", index, 100 * double(share(ray)));
        line(columns + head + c_.strong + ray_kind_name(ray.kind) + c_.plain + " → " + target(ray) + ": " +
             c_.value + quantity_text(ray.radiance, 4) + c_.plain);
        std::vector<std::size_t> shown;
        int left_out = 0;
        for (const int child : {ray.reflected, ray.refracted}) {
            if (child < 0) continue;
            const auto i = static_cast<std::size_t>(child);
            if (share(sample().rays[i]) < min_share)
                left_out += formats::rays_in_branch(sample(), i);
            else
                shown.push_back(i);
        }
        for (const std::size_t child : shown) {
            const bool last = child == shown.back() && left_out == 0;
            write_branch(child, body + (last ? "└─ " : "├─ "), body + (last ? "   " : "│  "));
        }
        if (left_out > 0)
            line(std::string(14, ' ') + body + c_.faint + "└─ + " + std::to_string(left_out) +
                 (left_out == 1 ? " ray" : " rays") + " below 0.1 %" + c_.plain);
    }

    /// What a ray meets: "sphere.0 (ball.toml:3:1) at 2.4, from inside".
    static std::string target(const ExplainedRay& ray) {
        if (ray.end == RayEnd::absorbed) return "nothing, " + printable(ray.why);
        if (!ray.hit) return "background";
        return printable(ray.label) + place(ray.where) + " at " + number_text(ray.distance, 4) +
               (ray.entering ? "" : ", from inside") + (ray.total_reflection ? ", total reflection" : "") +
               (ray.end == RayEnd::depth_limit ? ", depth limit" : "") + left_out(ray.left_out);
    }

    static std::string left_out(int branches) {
        if (branches == 0) return "";
        return ", " + std::to_string(branches) + (branches == 1 ? " branch" : " branches") +
               " below min_weight left out";
    }

    /// Where something is written, in parentheses; empty for what comes from no file.
    static std::string place(const Location& where) {
        return where.line > 0 ? " (" + printable(to_string(where)) + ")" : "";
    }

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
        line(c_.strong + std::string("sample ") + std::to_string(index) + c_.plain + " at (" +
             number_text(s.dx, digits) + ", " + number_text(s.dy, digits) +
             ") pixels from the centre, weight " + number_text(s.weight, digits) +
             (s.counts ? "" : ", left out") + " = " + c_.value + text_of(s.radiance) + c_.plain);
    }

    /// A branch with every step.
    void write_ray(std::size_t index, const std::string& head, const std::string& body) {
        const ExplainedRay& ray = sample().rays[index];
        const bool branches = ray.reflected >= 0 || ray.refracted >= 0;
        const std::string inner = body + (branches ? "│ " : "  ");
        line(head + title(ray));
        write_steps_of(ray, inner);
        if (branches) line(body + "│");
        if (ray.reflected >= 0) write_child(ray.reflected, body, ray.refracted < 0);
        if (ray.refracted >= 0) write_child(ray.refracted, body, true);
    }

    void write_child(int index, const std::string& body, bool last) {
        write_ray(static_cast<std::size_t>(index), body + (last ? "└─ " : "├─ "),
                  body + (last ? "   " : "│  "));
    }

    std::string title(const ExplainedRay& ray) const {
        return c_.strong + std::string(ray_kind_name(ray.kind)) + " ray" + c_.plain + " brings " + c_.value +
               text_of(ray.radiance) + c_.plain + ", weight in the sample " + text_of(ray.weight);
    }

    void write_ray_alone(const ExplainedRay& ray) {
        line(title(ray));
        write_steps_of(ray, "  ");
    }

    void write_steps_of(const ExplainedRay& ray, const std::string& inner) {
        write_path(ray, inner);
        for (const ExplainedLight& light : ray.lights) write_light(ray, light, inner);
        write_steps(Scope(ray), ray.steps, inner);
        line(inner + ray.why);
    }

    void write_path(const ExplainedRay& ray, const std::string& inner) {
        line(inner + "from " + text_of(ray.origin) + " along " + text_of(ray.direction));
        if (!ray.inside.empty()) line(inner + "inside " + printable(scene::listed(ray.inside, ", within ")));
        for (const std::string& label : ray.passed_over)
            line(inner + "passes over " + printable(label) + ": hidden inside a solid that owns the space");
        if (!ray.hit) return;
        line(inner + "hits " + c_.strong + printable(ray.label) + c_.plain + place(ray.where) +
             ", material " + printable(ray.material) + ", from " + (ray.entering ? "outside" : "inside") +
             ", distance " + number_text(ray.distance, digits));
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
        line(inner + c_.strong + printable(light.label) + c_.plain + place(light.where) + ": distance " +
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
    const ExplanationTextOptions& options_;
    const Colors c_;
    std::string text_;
};

} // namespace

std::string explanation_text(const Explanation& explanation, const ExplanationTextOptions& options) {
    return TextTree(explanation, options).write();
}

} // namespace glint
