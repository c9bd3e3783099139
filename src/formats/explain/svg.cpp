// The ray tree of a pixel as SVG: rays from left to right, one column per bounce.

#include "formats/explain/branch.h"
#include "formats/explain/formula.h"
#include "formats/explain/markup.h"
#include "glint/explanation_files.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace glint {

using formats::number_text;

namespace {

constexpr int shown_digits = 3;
constexpr double box_width = 350;
constexpr double column = 470;
constexpr double line_height = 19;
constexpr double box_gap = 18;
constexpr double margin = 24;
/// Rays with less weight are counted but not drawn.
constexpr float min_weight = 1.0f / 1000;

/// Terms and rays below 1/1000 of the darkest 8-bit step are omitted.
constexpr float too_dark_to_see = 1e-7f;

float largest(const glm::vec3& v) { return std::max({v.x, v.y, v.z}); }

std::string seen_text(const glm::vec3& v) {
    return largest(glm::abs(v)) < too_dark_to_see ? "0" : quantity_text(v, shown_digits);
}

/// SVG requires an ASCII minus sign.
std::string coordinate(double x) {
    const std::string text = number_text(static_cast<float>(std::abs(std::round(x * 10) / 10)), 7);
    return x < 0 ? "-" + text : text;
}

std::string angle_label(float degrees) { return number_text(degrees, 3) + "°"; }

struct TextLine {
    std::string text;
    const char* style = ""; ///< CSS class
    bool swatch = false;
    glm::vec3 color{0.0f};
};

/// The box of a ray.
struct Box {
    std::vector<TextLine> lines;
    std::vector<std::size_t> children; ///< children that are drawn
    double y = 0;                      ///< top
    double height() const { return line_height * static_cast<double>(lines.size()) + 18; }
    double middle() const { return y + height() / 2; }
};

std::string light_text(const ExplainedLight& light) {
    std::string text = light.label + ": ";
    if (light.arriving == glm::vec3(0.0f)) return text + angle_label(light.degrees) + ", nothing arrives";
    text += angle_label(light.degrees);
    if (!light.asked) return text + ", of no effect";
    if (light.blockers.empty()) return text + ", arrives whole";
    const Blocker& first = light.blockers.front();
    if (light.shadow == 0.0f) return text + ", in the shadow of " + first.label;
    return text + ", " + number_text(light.shadow, 3) + " through " + first.label +
           (light.blockers.size() > 1 ? " …" : "");
}

std::string refraction_text(const ExplainedRay& ray) {
    const std::string indices = number_text(ray.index_before, 4) + " → " + number_text(ray.index_after, 4);
    if (ray.total_reflection)
        return "index " + indices + ": total reflection, " + angle_label(ray.degrees_before) + " > " +
               angle_label(ray.critical_degrees);
    return "index " + indices + ": " + angle_label(ray.degrees_before) + " → " +
           angle_label(ray.degrees_after);
}

class SvgTree {
  public:
    explicit SvgTree(const Explanation& explanation) : explanation_(explanation) {}

    std::string write() {
        double y = margin + 76;
        for (std::size_t i = 0; i < explanation_.samples.size(); ++i) {
            const ExplainedSample& sample = explanation_.samples[i];
            if (explanation_.samples.size() > 1) {
                sample_title(sample, i, y + 14);
                y += 30;
            }
            lay_out(sample, y);
            draw(sample);
            y += 2 * box_gap;
        }
        return framed(y);
    }

  private:
    void lay_out(const ExplainedSample& sample, double& y) {
        boxes_.assign(sample.rays.size(), {});
        // Children follow their parents, so going backward completes branches first.
        for (std::size_t i = sample.rays.size(); i-- > 0;) fill(sample, i);
        stack(sample, 0, y);
    }

    void fill(const ExplainedSample& sample, std::size_t index) {
        const ExplainedRay& ray = sample.rays[index];
        Box& box = boxes_[index];
        box.lines.push_back({std::string(ray_kind_name(ray.kind)) + " ray = " + seen_text(ray.radiance),
                             "head", true, ray.radiance});
        if (ray.hit) {
            const std::string side = ray.entering ? "" : ", from inside";
            box.lines.push_back({ray.label + " (" + ray.material + ")" + side + ", distance " +
                                     number_text(ray.distance, shown_digits),
                                 "what"});
        }
        if (!ray.inside.empty()) box.lines.push_back({"inside " + ray.inside.front(), "faint"});
        if (ray.crosses) box.lines.push_back({refraction_text(ray), "faint"});
        for (const ExplainedLight& light : ray.lights) box.lines.push_back({light_text(light), "light"});
        add_terms(ray, box);
        int left_out = 0;
        for (const int child : {ray.reflected, ray.refracted}) {
            if (child < 0) continue;
            const auto i = static_cast<std::size_t>(child);
            if (largest(sample.rays[i].weight) >= min_weight)
                box.children.push_back(i);
            else
                left_out += formats::rays_in_branch(sample, i);
        }
        if (ray.end != RayEnd::bounced) box.lines.push_back({ray.why, "faint"});
        if (left_out > 0)
            box.lines.push_back(
                {"+ " + std::to_string(left_out) + " of weight below 0.001, not drawn", "faint"});
        if (!ray.lights.empty() && ray.gain > 1.0000001f)
            box.lines.push_back(
                {"gain " + number_text(ray.gain, 3) + ": more light leaves than arrives", "warn"});
    }

    static void add_terms(const ExplainedRay& ray, Box& box) {
        for (int i = 0; i < term_count; ++i) {
            const glm::vec3& term = ray.terms[static_cast<std::size_t>(i)];
            if (largest(glm::abs(term)) < too_dark_to_see) continue;
            const auto which = static_cast<Term>(i);
            const glm::vec3 shown = which == Term::clamp ? -term : term;
            box.lines.push_back({std::string(term_name(which)) + " " + quantity_text(term, shown_digits),
                                 "term", true, shown});
        }
    }

    /// Places boxes from the leaves on: a parent is centred beside its children.
    void stack(const ExplainedSample& sample, std::size_t index, double& y) {
        Box& box = boxes_[index];
        const double top = y;
        for (const std::size_t child : box.children) stack(sample, child, y);
        columns_ = std::max(columns_, sample.rays[index].depth + 1);
        if (box.children.empty()) {
            box.y = y;
            y += box.height() + box_gap;
            return;
        }
        const double middle =
            (boxes_[box.children.front()].middle() + boxes_[box.children.back()].middle()) / 2;
        box.y = std::max(top, middle - box.height() / 2);
        y = std::max(y, box.y + box.height() + box_gap);
    }

    void draw(const ExplainedSample& sample) {
        draw_edges(sample, 0);
        draw_boxes(sample, 0);
    }

    void draw_edges(const ExplainedSample& sample, std::size_t index) {
        const ExplainedRay& ray = sample.rays[index];
        for (const std::size_t child : boxes_[index].children) {
            const bool mirror = static_cast<int>(child) == ray.reflected;
            const double x0 = left(ray.depth) + box_width;
            const double x1 = left(ray.depth + 1);
            const double y0 = boxes_[index].middle();
            const double y1 = boxes_[child].middle();
            const double bend = x0 + (x1 - x0) * 0.4;
            const double wide = 1.5 + 6 * std::min(1.0f, largest(sample.rays[child].weight));
            body_ += "<path class=\"" + std::string(mirror ? "mirror" : "glass") + "\" stroke-width=\"" +
                     coordinate(wide) + "\" d=\"M" + coordinate(x0) + " " + coordinate(y0) + " C" +
                     coordinate(bend) + " " + coordinate(y0) + " " + coordinate(bend - 10) + " " +
                     coordinate(y1) + " " + coordinate(x1) + " " + coordinate(y1) + "\"/>\n";
            text(x1 - 8, y1 - 6 - wide / 2, weight_text(ray, mirror),
                 mirror ? "edge mirror-ink" : "edge glass-ink");
            draw_edges(sample, child);
        }
    }

    /// Weight of a branch, such as "0.1 ×".
    static std::string weight_text(const ExplainedRay& ray, bool mirror) {
        for (const Step& step : ray.steps)
            if (step.symbol == (mirror ? "w_R" : "w_T")) return number_text(step.result.value.x, 3) + " ×";
        return "";
    }

    void draw_boxes(const ExplainedSample& sample, std::size_t index) {
        const Box& box = boxes_[index];
        const double x = left(sample.rays[index].depth);
        body_ += "<rect class=\"box\" x=\"" + coordinate(x) + "\" y=\"" + coordinate(box.y) + "\" width=\"" +
                 coordinate(box_width) + "\" height=\"" + coordinate(box.height()) + "\" rx=\"7\"/>\n";
        double y = box.y + 22;
        for (const TextLine& line : box.lines) {
            if (line.swatch) swatch(x + 12, y - 11, 13, line.color);
            text(x + (line.swatch ? 32 : 12), y, formats::cut(line.text, 49), line.style);
            y += line_height;
        }
        for (const std::size_t child : box.children) draw_boxes(sample, child);
    }

    static double left(int depth) { return margin + column * depth; }

    void text(double x, double y, const std::string& words, const std::string& style) {
        body_ += "<text class=\"" + style + "\" x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\">" +
                 formats::escape_markup(words) + "</text>\n";
    }

    void swatch(double x, double y, double size, const glm::vec3& color) {
        body_ += "<rect class=\"swatch\" x=\"" + coordinate(x) + "\" y=\"" + coordinate(y) + "\" width=\"" +
                 coordinate(size) + "\" height=\"" + coordinate(size) + "\" rx=\"2\" fill=\"" +
                 formats::web_color(color) + "\"/>\n";
    }

    void sample_title(const ExplainedSample& s, std::size_t index, double y) {
        swatch(margin, y - 12, 14, s.radiance);
        text(margin + 22, y,
             "sample " + std::to_string(index) + " at (" + number_text(s.dx, 3) + ", " +
                 number_text(s.dy, 3) + "), weight " + number_text(s.weight, 1) +
                 (s.counts ? "" : ", left out") + " = " + quantity_text(s.radiance, shown_digits),
             "what");
    }

    std::string framed(double height) {
        const Explanation& e = explanation_;
        const double width = std::max(900.0, left(columns_ - 1) + box_width + margin);
        std::string head = body_;
        body_.clear();
        swatch(margin, margin, 56, e.color);
        const std::string scene = e.scene.empty() ? "" : " of " + e.scene;
        text(margin + 72, margin + 20, "pixel " + std::to_string(e.x) + "," + std::to_string(e.y) + scene,
             "title");
        text(margin + 72, margin + 43,
             "= " + quantity_text(e.color, shown_digits) +
                 ", linear red, green, blue, computed on the CPU; " + e.rule +
                 (e.gpu ? "; " + other_pixel_text(e, *e.gpu, shown_digits) : ""),
             "what");
        legend(margin + 72, margin + 62);
        return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + coordinate(width) + "\" height=\"" +
               coordinate(height) + "\" viewBox=\"0 0 " + coordinate(width) + " " + coordinate(height) +
               "\">\n" + style() + "<rect class=\"paper\" width=\"100%\" height=\"100%\"/>\n" + body_ + head +
               "</svg>\n";
    }

    void legend(double x, double y) {
        text(x, y, "mirror rays", "small mirror-ink");
        text(x + 84, y, "refracted rays", "small glass-ink");
        text(x + 184, y,
             "wide lines: much of the light; each box is a ray, its colour what comes back along it",
             "small faint");
    }

    static std::string style() {
        return "<style>\n"
               "text { font: 13px 'DejaVu Sans', 'Segoe UI', 'Helvetica Neue', Arial, sans-serif; fill: "
               "#1d2530 }\n"
               ".paper { fill: #f6f4ef }\n"
               ".box { fill: #fff; stroke: #c9c4b8 }\n"
               ".swatch { stroke: #00000055; stroke-width: 0.7 }\n"
               ".title { font-size: 21px; font-weight: bold }\n"
               ".head { font-weight: bold }\n"
               ".faint { fill: #6d7380 }\n"
               ".small { font-size: 12px }\n"
               ".light { fill: #8a5a00 }\n"
               ".warn { fill: #b3261e }\n"
               ".mirror, .glass { fill: none; stroke-linecap: round }\n"
               ".mirror { stroke: #2f6fd0 }\n"
               ".glass { stroke: #1f9a7a }\n"
               ".mirror-ink { fill: #2f6fd0 }\n"
               ".glass-ink { fill: #1f9a7a }\n"
               ".edge { text-anchor: end; font-weight: bold; paint-order: stroke; stroke: #f6f4ef;\n"
               "  stroke-width: 4px }\n"
               "</style>\n";
    }

    const Explanation& explanation_;
    std::vector<Box> boxes_;
    int columns_ = 1;
    std::string body_;
};

} // namespace

std::string explanation_svg(const Explanation& explanation) { return SvgTree(explanation).write(); }

} // namespace glint
