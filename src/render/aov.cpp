// AOVs: their kinds and names, and pictures of them for the eye.

#include "render/aov.h"

#include "math/vec.h"
#include "scene/scene_data.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::rendering {
namespace {

/// Steps to the first hit that are shown white.
constexpr float max_steps = 400;

/// Maps the three numbers of each pixel to a colour.
template <class Show>
Image mapped(const Image& numbers, const Show& show) {
    Image image(numbers.width, numbers.height);
    for (std::size_t i = 0; i < numbers.pixels.size(); i += 3) {
        const float* n = numbers.pixels.data() + i;
        const vec3 color = show(vec3(n[0], n[1], n[2]));
        for (int channel = 0; channel < 3; ++channel)
            image.pixels[i + static_cast<std::size_t>(channel)] = color[channel];
    }
    return image;
}

/// The distance from the eye to the middle of all finite objects; without any, to the origin.
float middle_distance(const Scene& scene) {
    const Bounds bounds = scene.data().world.bounds();
    const dvec3 middle = bounds.empty() ? dvec3(0.0) : (dvec3(bounds.lo) + dvec3(bounds.hi)) * 0.5;
    const double distance = glm::length(middle - scene.data().description.camera->eye);
    return distance > 0 ? static_cast<float>(distance) : 1.0f;
}

/// Ambient lights are not counted: nothing hides them.
float light_count(const Scene& scene) {
    return static_cast<float>(std::max<std::size_t>(1, scene.data().lights.size()));
}

Image cost_in_colours(const Image& numbers) {
    // The root shows differences among few steps and among many.
    const Image steps = mapped(numbers, [](const vec3& n) { return vec3(std::sqrt(n.x + n.y), 0.0f, 0.0f); });
    return difference_heat(steps, Image(numbers.width, numbers.height), std::sqrt(max_steps));
}

} // namespace

bool is_light(Aov aov) { return aov < Aov::shadows || aov > Aov::cost; }

std::optional<int> term_of(Aov aov, Integrator integrator) {
    const std::vector<std::string> names = term_names(integrator);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == aov_name(aov)) return static_cast<int>(i);
    return std::nullopt;
}

} // namespace glint::rendering

namespace glint {

const char* aov_name(Aov aov) {
    static constexpr std::array first_hits{"shadows", "normal", "depth", "cost"};
    const auto from = [aov](Aov first) {
        return static_cast<std::size_t>(aov) - static_cast<std::size_t>(first);
    };
    if (aov == Aov::final) return "final";
    if (aov < Aov::shadows) return enum_names<Term>[from(Aov::ambient)].data();
    if (aov <= Aov::cost) return first_hits[from(Aov::shadows)];
    return enum_names<PathTerm>[from(Aov::direct_diffuse)].data();
}

bool has_aov(Integrator integrator, Aov aov) {
    return aov == Aov::final || !rendering::is_light(aov) || rendering::term_of(aov, integrator);
}

std::vector<std::string> term_names(Integrator integrator) {
    switch (integrator) {
    case Integrator::whitted:
        return {enum_names<Term>.begin(), enum_names<Term>.end()};
    case Integrator::path:
    case Integrator::direct:
        return {enum_names<PathTerm>.begin(), enum_names<PathTerm>.end()};
    case Integrator::path_simple:
    case Integrator::ambient_occlusion:
        break;
    }
    return {};
}

bool is_visible(Aov aov) { return aov == Aov::final || (rendering::is_light(aov) && aov != Aov::clamp); }

Image visible(const Image& numbers, Aov aov, const Scene& scene) {
    switch (aov) {
    case Aov::clamp:
        return rendering::mapped(numbers, [](const vec3& n) { return -n; });
    case Aov::shadows:
        return rendering::mapped(
            numbers, [all = rendering::light_count(scene)](const vec3& n) { return vec3(1.0f) - n / all; });
    case Aov::normal:
        return rendering::mapped(numbers,
                                 [](const vec3& n) { return n == vec3(0.0f) ? n : n * 0.5f + vec3(0.5f); });
    case Aov::depth:
        return rendering::mapped(numbers, [middle = rendering::middle_distance(scene)](const vec3& n) {
            const float x = n.x / middle;
            return vec3(1.0f / (1.0f + x * x));
        });
    case Aov::cost:
        return rendering::cost_in_colours(numbers);
    default:
        return numbers;
    }
}

} // namespace glint
