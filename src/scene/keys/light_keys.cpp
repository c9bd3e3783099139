// [[light]]: a key names the member of each type of light that has it.

#include "scene/keys/bind.h"
#include "scene/keys/tables.h"

#include <numbers>

namespace glint::scene::keys {
namespace {

using Kind = decltype(Light::kind);

template <std::size_t... index>
Kind default_kind(std::size_t type, std::index_sequence<index...>) {
    Kind kind;
    ((type == index ? void(kind.emplace<index>()) : void()), ...);
    return kind;
}

/// Which light it is. Read first: the other keys belong to the alternative that it chooses.
KeyRow type_of_light() {
    KeySpec spec{.key = "type", .type = KeyType::choice};
    spec.choices = light_names;
    spec.get = [](const KeyOwner& owner) -> KeyValue {
        return Choice{owner.as<const Light>()->kind.index()};
    };
    spec.set = [](const KeyOwner& owner, const KeyValue& value) {
        constexpr auto all = std::make_index_sequence<light_names.size()>();
        Light& light = *owner.as<Light>();
        const std::size_t type = std::get<Choice>(value).index;
        if (light.kind.index() != type) light.kind = default_kind(type, all);
    };
    return KeyRow(std::move(spec)).required();
}

/// In W/sr: Whitted's terms are π times the radiance convention. It is written as `intensity`.
template <auto... intensities>
KeyRow radiant_intensity() {
    KeySpec spec = number<intensities...>("radiant_intensity");
    spec.get = nullptr;
    spec.set = [](const KeyOwner& owner, const KeyValue& value) {
        set<intensities...>(owner, std::get<double>(value) / std::numbers::pi);
    };
    return KeyRow(std::move(spec));
}

} // namespace

TableSpec light_table() {
    using P = PointLight;
    using D = DirectionalLight;
    using S = SpotLight;
    return {
        .name = "light",
        .form = TableForm::list,
        .selector = "type",
        .help = "Lights add up in their order.",
        .keys = {
            type_of_light(),
            text<&Light::name>("name").help("to be named by `-D`; unique among lights"),
            point<&P::position, &S::position>("position").required(),
            direction<&D::direction, &S::direction>("direction").required().help("the way the light travels"),
            number<&S::angle>("angle")
                .unit("degrees")
                .range({.low = 0, .high = 90, .low_open = true})
                .typical(1, 90)
                .help("half angle of the cone"),
            number<&S::blend>("blend").range(share).help(
                "soft share of the cone: full light within angle · (1 − blend)"),
            color<&AmbientLight::color>("color").help("the ambient light itself"),
            color<&P::color, &D::color, &S::color>("color"),
            factor<&P::intensity, &S::intensity>("intensity")
                .or_else("radiant_intensity")
                .help("a white matte surface facing it at distance 1 shows 1.0"),
            radiant_intensity<&P::intensity, &S::intensity>()
                .unit("W/sr")
                .range(at_least_0)
                .limits(between(0, float_limit * std::numbers::pi))
                .instead_of("intensity")
                .help("`intensity` · π, instead of it"),
            factor<&D::irradiance>("irradiance").help("a white matte surface facing it shows 1.0"),
        }};
}

} // namespace glint::scene::keys
