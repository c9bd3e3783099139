// Packing the data of the page.

#include "formats/explain/page.h"

#include "formats/explain/markup.h"
#include "scene/text.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <new>
#include <string_view>

namespace glint::formats {
namespace {

/// Beyond this number, constants are stored per ray.
constexpr std::size_t max_constants = 2048;

/// Whether the numbers of a step are properties of the scene rather than of the hit.
bool belongs_to_scene(std::string_view topic) {
    for (const std::string_view one :
         {"material", "light", "ambient", "emission", "absorption", "refraction", "shadow"})
        if (topic == one) return true;
    return false;
}

/// The subscript of a symbol such as "D₁₂".
int subscript(std::string_view symbol) {
    int number = 0;
    for (std::size_t i = 0; i + 2 < symbol.size(); ++i)
        if (symbol.substr(i, 2) == "\xe2\x82")
            number = 10 * number + (static_cast<unsigned char>(symbol[i + 2]) - 0x80);
    return number;
}

void add_word(std::string& out, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(word >> shift & 255u);
}

/// Groups bytes by significance, which compresses better.
void add_planes(std::string& out, const std::vector<std::uint32_t>& words) {
    for (int shift = 0; shift < 32; shift += 8)
        for (const std::uint32_t word : words) out += static_cast<char>(word >> shift & 255u);
}

std::string deflated(const std::string& bytes) {
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::string out(size, '\0');
    const int code =
        compress2(reinterpret_cast<Bytef*>(out.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                  static_cast<uLong>(bytes.size()), 6);
    if (code != Z_OK) throw std::bad_alloc();
    out.resize(size);
    return out;
}

void add_vector(std::vector<std::uint32_t>& words, const glm::vec3& v) {
    for (int i = 0; i < 3; ++i) words.push_back(std::bit_cast<std::uint32_t>(v[i]));
}

} // namespace

void PageData::add(const Explanation& explanation) {
    const ExplainedSample& sample = explanation.samples.front();
    PixelRecord pixel;
    pixel.first_ray = rays_.size();
    pixel.rays = sample.rays.size();
    pixel.sums[0] = explanation.color;
    std::copy(explanation.terms.begin(), explanation.terms.end(), pixel.sums.begin() + 1);
    pixels_.push_back(pixel);
    for (const ExplainedRay& ray : sample.rays) {
        Ray out;
        out.parent = ray.parent;
        out.reflected = ray.reflected;
        out.refracted = ray.refracted;
        out.radiance = ray.radiance;
        // A branch requires its parent, so its weight is at most the parent's.
        out.weight = std::max({ray.weight.x, ray.weight.y, ray.weight.z});
        if (ray.parent >= 0)
            out.weight =
                std::min(out.weight, rays_[pixel.first_ray + static_cast<std::size_t>(ray.parent)].weight);
        out.first = numbers_.size();
        // Without steps there is nothing to show.
        out.complete = !ray.steps.empty();
        if (out.complete) out.shape = shape_of(ray);
        complete_ += out.complete ? 1 : 0;
        rays_.push_back(out);
    }
}

std::uint32_t PageData::shape_of(const ExplainedRay& ray) {
    const std::size_t before = numbers_.size();
    std::string shape = "{\"kind\":" + json_text(ray_kind_name(ray.kind)) +
                        ",\"end\":" + json_text(ray_end_name(ray.end)) + ",\"why\":" + json_text(ray.why) +
                        ",\"label\":" + json_text(ray.label) + ",\"material\":" + json_text(ray.material) +
                        ",\"side\":" + json_text(ray.entering ? "outside" : "inside") +
                        ",\"inside\":" + json_list(ray.inside) +
                        ",\"passed_over\":" + json_list(ray.passed_over) +
                        ",\"steps\":" + steps_of(ray, {&ray.given, &ray.steps}) + ",\"lights\":[";
    for (const ExplainedLight& light : ray.lights)
        shape += (&light == &ray.lights.front() ? "" : ",") + light_of(ray, light);
    const auto size = static_cast<std::uint32_t>(numbers_.size() - before);
    shape += "],\"size\":" + std::to_string(size) + "}";
    const auto [found, is_new] =
        shape_numbers_.try_emplace(shape, static_cast<std::uint32_t>(shapes_.size()));
    if (is_new) {
        shapes_.push_back(shape);
        sizes_.push_back(size);
    }
    return found->second;
}

std::string PageData::light_of(const ExplainedRay& ray, const ExplainedLight& light) {
    std::string blockers;
    for (const Blocker& b : light.blockers) {
        numbers_.push_back(b.distance);
        blockers += (blockers.empty() ? "[" : ",[") + json_text(b.label) + "," + json_text(b.material) + "," +
                    (b.passed_over ? "1]" : "0]");
    }
    return "{\"label\":" + json_text(light.label) + ",\"blockers\":[" + blockers +
           "],\"steps\":" + steps_of(ray, {&light.steps}) + "}";
}

std::string PageData::steps_of(const ExplainedRay& ray, const std::vector<const std::vector<Step>*>& lists) {
    std::string out;
    for (const std::vector<Step>* list : lists)
        for (const Step& step : *list)
            out += (out.empty() ? "[" : ",[") + step_number(step) + source_of(ray, step) + "]";
    return "[" + out + "]";
}

/// Source of the result for the page: ",SOURCE[,NUMBER]"; empty if the page evaluates the formula.
std::string PageData::source_of(const ExplainedRay& ray, const Step& step) {
    const auto source = [](Source s) { return "," + std::to_string(static_cast<int>(s)); };
    if (!step.formula.empty() && step.formula.find('^') == std::string::npos) return "";
    const std::string& symbol = step.symbol;
    const bool inherited = ray.parent >= 0 && (symbol == "d" || symbol == "W");
    if (inherited || symbol == "L_R" || symbol == "L_T") return source(Source::link);
    const std::string_view topic = step.topic;
    if (step.formula.empty() && (topic == "diffuse" || topic == "highlight")) {
        // Results of lights are known.
        for (std::size_t i = 0; i < ray.lights.size(); ++i)
            if (static_cast<int>(ray.lights[i].light) == subscript(symbol))
                return source(Source::link) + "," + std::to_string(i);
    }
    if (step.formula.empty() && belongs_to_scene(topic)) {
        const int number = constant_number(step.result);
        if (number >= 0) return source(Source::constant) + "," + std::to_string(number);
    }
    store(step.result);
    return source(Source::stored);
}

std::string PageData::step_number(const Step& step) {
    const std::string text = "[" + json_text(step.symbol) + "," + json_text(step.formula) + "," +
                             (step.result.vector ? "1," : "0,") + json_text(step.meaning) + "," +
                             json_text(step.section) + "," + json_text(step.note) + "]";
    const auto [found, is_new] = step_numbers_.try_emplace(text, steps_.size());
    if (is_new) steps_.push_back(text);
    return std::to_string(found->second);
}

int PageData::constant_number(const Quantity& q) {
    const std::string text = q.vector ? "[" + json_number(q.value.x) + "," + json_number(q.value.y) + "," +
                                            json_number(q.value.z) + "]"
                                      : json_number(q.value.x);
    const auto found = constant_numbers_.find(text);
    if (found != constant_numbers_.end()) return found->second;
    if (constants_.size() >= max_constants) return -1;
    constants_.push_back(text);
    return constant_numbers_[text] = static_cast<int>(constants_.size()) - 1;
}

void PageData::store(const Quantity& q) {
    numbers_.push_back(q.value.x);
    if (!q.vector) return;
    numbers_.push_back(q.value.y);
    numbers_.push_back(q.value.z);
}

/// Selects rays: all primary ones, then those with the largest weights.
std::vector<bool> PageData::heaviest(std::size_t count) const {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < rays_.size(); ++i)
        if (rays_[i].complete) order.push_back(i);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if ((rays_[a].parent < 0) != (rays_[b].parent < 0)) return rays_[a].parent < 0;
        return rays_[a].weight > rays_[b].weight;
    });
    std::vector<bool> kept(rays_.size(), false);
    for (std::size_t i = 0; i < order.size() && (i < count || rays_[order[i]].parent < 0); ++i)
        kept[order[i]] = true;
    return kept;
}

std::string PageData::json(const std::string& head) const {
    return head + "\"steps\":[" + scene::listed(steps_, ",") + "],\"constants\":[" +
           scene::listed(constants_, ",") + "],\"shapes\":[" + scene::listed(shapes_, ",") + "]}";
}

std::string PageData::packed(const std::string& head, std::size_t count) const {
    const std::vector<bool> kept = heaviest(count);
    std::vector<std::uint32_t> whole;
    std::vector<std::uint32_t> numbers;
    for (const PixelRecord& pixel : pixels_) {
        const std::size_t header = whole.size();
        whole.push_back(0);
        for (const glm::vec3& sum : pixel.sums) add_vector(numbers, sum);
        std::vector<std::uint32_t> index_of(pixel.rays, 0); // from 1; 0: omitted
        // Position at which the nearest kept ancestor counts omitted rays.
        std::vector<std::size_t> slot(pixel.rays, 0);
        for (std::size_t i = 0; i < pixel.rays; ++i) {
            const Ray& ray = rays_[pixel.first_ray + i];
            const auto parent = static_cast<std::size_t>(std::max(ray.parent, 0));
            if (!kept[pixel.first_ray + i]) {
                slot[i] = slot[parent];
                ++whole[slot[i]];
                continue;
            }
            const auto is_left_out = [&](std::int32_t child) {
                return child >= 0 && !kept[pixel.first_ray + static_cast<std::size_t>(child)];
            };
            index_of[i] = ++whole[header];
            slot[i] = whole.size() + 3;
            whole.insert(whole.end(),
                         {ray.shape, ray.parent < 0 ? 0 : index_of[parent],
                          (is_left_out(ray.reflected) ? 1u : 0u) | (is_left_out(ray.refracted) ? 2u : 0u),
                          0u});
            for (std::size_t k = 0; k < sizes_[ray.shape]; ++k)
                numbers.push_back(std::bit_cast<std::uint32_t>(numbers_[ray.first + k]));
            for (const std::int32_t child : {ray.reflected, ray.refracted})
                if (is_left_out(child))
                    add_vector(numbers, rays_[pixel.first_ray + static_cast<std::size_t>(child)].radiance);
        }
    }
    const std::string text = json(head);
    std::string bytes;
    for (const std::size_t size : {text.size(), whole.size(), numbers.size()})
        add_word(bytes, static_cast<std::uint32_t>(size));
    bytes += text;
    add_planes(bytes, whole);
    add_planes(bytes, numbers);
    return deflated(bytes);
}

} // namespace glint::formats
