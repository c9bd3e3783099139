#include "scene/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace glint::scene {
namespace {

float sine_of(float cosine) { return std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)); }

/// cos(max(0, a − b)) for angles in 0 … π.
float cos_beyond(float cos_a, float sin_a, float cos_b, float sin_b) {
    return cos_a > cos_b ? 1.0f : cos_a * cos_b + sin_a * sin_b;
}

/// sin(max(0, a − b)).
float sin_beyond(float cos_a, float sin_a, float cos_b, float sin_b) {
    return cos_a > cos_b ? 0.0f : sin_a * cos_b - cos_a * sin_b;
}

/// cos of the angle between an axis and the far side of a cone; −1 beyond a half turn.
float cos_of_far_side(const vec3& axis, const LightBounds& cone) {
    const float to_axis = std::clamp(glm::dot(axis, cone.axis), -1.0f, 1.0f);
    const float sine = sine_of(to_axis), cone_sine = sine_of(cone.cos_cone);
    // a + b > π where cos a < −cos b.
    return to_axis < -cone.cos_cone ? -1.0f : to_axis * cone.cos_cone - sine * cone_sine;
}

LightBounds united(const LightBounds& a, LightBounds b) {
    LightBounds both;
    both.box = a.box;
    both.box.grow(b.box);
    both.both_sides = a.both_sides || b.both_sides;
    both.power = a.power + b.power;
    // Of what emits on both sides the axis may be turned around.
    if (both.both_sides && glm::dot(a.axis, b.axis) < 0) b.axis = -b.axis;
    const vec3 sum = a.axis + b.axis;
    const float size = glm::length(sum);
    both.axis = size > 1e-3f ? sum / size : a.axis;
    both.cos_cone = std::min(cos_of_far_side(both.axis, a), cos_of_far_side(both.axis, b));
    return both;
}

vec3 middle(const Bounds& box) { return (box.lo + box.hi) * 0.5f; }

} // namespace

// ── Building ──

/// Splits lights where power × area × spread of the normals is least, among bins along the longest axis.
struct LightTree::Builder {
    static constexpr std::size_t bins = 12;
    static constexpr int max_depth = 63; // of the way to a light, which is a bit for each step

    struct Bin {
        Bounds box;
        vec3 axes{0.0f};
        float power = 0;
        std::size_t count = 0;

        void add(const Bin& other) {
            box.grow(other.box);
            axes = axes + other.axes;
            power += other.power;
            count += other.count;
        }
        float cost() const {
            const vec3 e = box.hi - box.lo;
            const float size = e.x * e.y + e.y * e.z + e.z * e.x + glm::dot(e, e) * 0.01f;
            const float aligned = glm::length(axes) / static_cast<float>(count);
            return power * size * (1.25f - aligned);
        }
    };

    LightTree& tree;
    std::span<const LightBounds> lights;

    /// Adds the node of a range of lights and all below it.
    void add(std::span<std::uint32_t> range, std::uint64_t turns, int depth) {
        const std::size_t number = tree.nodes_.size();
        tree.nodes_.emplace_back();
        if (range.size() == 1) {
            tree.nodes_[number].light = range[0];
            tree.turns_[range[0]] = turns;
            tree.depth_[range[0]] = static_cast<std::uint8_t>(depth);
            return finish(number, lights[range[0]]);
        }
        const std::size_t split = split_of(range, depth);
        add(range.first(split), turns, depth + 1);
        const std::size_t right = tree.nodes_.size();
        add(range.subspan(split), turns | std::uint64_t{1} << depth, depth + 1);
        tree.nodes_[number].right = static_cast<std::uint32_t>(right);
        finish(number, united(tree.nodes_[number + 1].bounds, tree.nodes_[right].bounds));
    }

    void finish(std::size_t number, const LightBounds& bounds) {
        tree.nodes_[number].bounds = bounds;
        tree.nodes_[number].sin_cone = sine_of(bounds.cos_cone);
    }

    /// Orders the range so that the left child gets the first ones; returns how many.
    std::size_t split_of(std::span<std::uint32_t> range, int depth) {
        Bounds middles;
        for (const std::uint32_t light : range) middles.grow(middle(lights[light].box));
        const vec3 extent = middles.hi - middles.lo;
        int axis = extent.y > extent.x ? 1 : 0;
        if (extent.z > extent[axis]) axis = 2;
        // Halves cannot become deeper than their number has bits.
        if (!(extent[axis] > 0) || depth > max_depth - 32) return range.size() / 2;
        const auto bin_of = [&](std::uint32_t light) {
            const float at = (middle(lights[light].box)[axis] - middles.lo[axis]) / extent[axis];
            return std::min(bins - 1, static_cast<std::size_t>(at * static_cast<float>(bins)));
        };
        const std::size_t last = best_bin(range, bin_of);
        const auto end = std::stable_partition(range.begin(), range.end(),
                                               [&](std::uint32_t light) { return bin_of(light) <= last; });
        return static_cast<std::size_t>(end - range.begin());
    }

    /// The last bin of the left child.
    template <class BinOf>
    std::size_t best_bin(std::span<const std::uint32_t> range, const BinOf& bin_of) const {
        std::array<Bin, bins> all{}, from_right{};
        const vec3 sense = lights[range[0]].axis;
        for (const std::uint32_t light : range) {
            const LightBounds& l = lights[light];
            const bool turned = l.both_sides && glm::dot(l.axis, sense) < 0;
            all[bin_of(light)].add({l.box, turned ? -l.axis : l.axis, l.power, 1});
        }
        from_right[bins - 1] = all[bins - 1];
        for (std::size_t i = bins - 1; i-- > 0;) {
            from_right[i] = all[i];
            from_right[i].add(from_right[i + 1]);
        }
        std::size_t best = 0;
        float least = std::numeric_limits<float>::infinity();
        Bin left;
        for (std::size_t i = 0; i + 1 < bins; ++i) {
            left.add(all[i]);
            if (left.count == 0 || from_right[i + 1].count == 0) continue;
            const float cost = left.cost() + from_right[i + 1].cost();
            if (cost < least) {
                least = cost;
                best = i;
            }
        }
        return best;
    }
};

LightTree::LightTree(std::span<const LightBounds> lights)
    : turns_(lights.size(), 0), depth_(lights.size(), 255) {
    std::vector<std::uint32_t> chosen;
    for (std::size_t i = 0; i < lights.size(); ++i)
        if (lights[i].power > 0) chosen.push_back(static_cast<std::uint32_t>(i));
    if (chosen.empty()) return;
    nodes_.reserve(2 * chosen.size());
    Builder{*this, lights}.add(chosen, 0, 0);
}

// ── Choosing ──

/// An estimate of the light that arrives: power · cos at the emitters · cos at the receiver / distance², with
/// the best angles that the bounds allow.
float LightTree::importance(const Node& node, const LightReceiver& at) {
    const LightBounds& b = node.bounds;
    const vec3 half = (b.box.hi - b.box.lo) * 0.5f;
    const vec3 to = middle(b.box) - at.p;
    const float radius_squared = glm::dot(half, half);
    const float squared = glm::dot(to, to);
    const float distance_squared = std::max(squared, radius_squared);
    constexpr float most = 1e30f; // so that sums are finite
    const float strength = std::min(b.power / std::max(distance_squared, 1e-30f), most);
    if (!(squared > radius_squared)) return strength; // p may be between them
    const vec3 direction = to / std::sqrt(squared);
    // The cone in which the box is seen.
    const float sin_box = std::sqrt(radius_squared / squared), cos_box = sine_of(sin_box);

    float cosine = -glm::dot(b.axis, direction);
    if (b.both_sides) cosine = std::abs(cosine);
    const float sine = sine_of(cosine);
    const float cos_off_cone = cos_beyond(cosine, sine, b.cos_cone, node.sin_cone);
    const float sin_off_cone = sin_beyond(cosine, sine, b.cos_cone, node.sin_cone);
    const float leaving = cos_beyond(cos_off_cone, sin_off_cone, cos_box, sin_box);

    float facing = glm::dot(at.n, direction);
    if (at.both_sides) facing = std::abs(facing);
    const float arriving = cos_beyond(facing, sine_of(facing), cos_box, sin_box);
    return strength * std::max(0.0f, leaving) * std::max(0.0f, arriving);
}

/// The probability of the left child; below 0 if no light arrives from either.
float LightTree::share_of_left(std::size_t node, const LightReceiver& at) const {
    const float left = importance(nodes_[node + 1], at), right = importance(nodes_[nodes_[node].right], at);
    return left + right > 0 ? left / (left + right) : -1.0f;
}

ChosenLight LightTree::choose(const LightReceiver& at, float u) const {
    ChosenLight chosen;
    float probability = 1;
    for (std::size_t node = 0; !nodes_.empty();) {
        if (nodes_[node].right == 0) {
            chosen.light = nodes_[node].light;
            chosen.probability = probability;
            break;
        }
        const float left = share_of_left(node, at);
        if (left < 0) break;
        const bool goes_left = u < left;
        const float share = goes_left ? left : 1.0f - left;
        u = goes_left ? u / share : (u - left) / share;
        probability *= share;
        node = goes_left ? node + 1 : nodes_[node].right;
    }
    return chosen;
}

float LightTree::probability(std::uint32_t light, const LightReceiver& at) const {
    if (depth_[light] == 255) return 0;
    float probability = 1;
    std::size_t node = 0;
    for (int depth = 0; depth < depth_[light]; ++depth) {
        const float left = share_of_left(node, at);
        if (left < 0) return 0;
        const bool goes_left = (turns_[light] >> depth & 1U) == 0;
        probability *= goes_left ? left : 1.0f - left;
        node = goes_left ? node + 1 : nodes_[node].right;
    }
    return probability;
}

} // namespace glint::scene
