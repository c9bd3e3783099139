// [material.NAME].

#include "scene/keys/bind.h"
#include "scene/keys/tables.h"

namespace glint::scene::keys {
namespace {

using M = Material;
using Model = MaterialModel;

// Defaults that depend on the model.

constexpr double plastic_roughness = 0.2;
constexpr double principled_roughness = 0.5;

Vec3 default_color(Model model) { return model == Model::dielectric ? Vec3(1) : M{}.color; }

double default_roughness(Model model) {
    if (model == Model::plastic) return plastic_roughness;
    return model == Model::principled ? principled_roughness : M{}.roughness;
}

/// What had the default of the old model gets that of the new one. Read before the other keys.
void choose_model(const KeyOwner& owner, const KeyValue& value) {
    M& m = *owner.as<M>();
    const Model before = m.model;
    assign(m.model, value);
    if (m.color == default_color(before)) m.color = default_color(m.model);
    if (m.roughness == default_roughness(before)) m.roughness = default_roughness(m.model);
}

KeyRow model() {
    KeySpec spec = choice<&M::model>("model");
    spec.set = choose_model;
    return KeyRow(std::move(spec));
}

/// A conductor has a colour or a metal.
KeyRow color_of_conductor() {
    KeySpec spec = color<&M::color>("color");
    spec.get = [](const KeyOwner& owner) -> KeyValue {
        const M& m = *owner.as<const M>();
        return m.metal ? KeyValue() : m.color;
    };
    return KeyRow(std::move(spec));
}

KeyRow metal() {
    KeySpec spec{.key = "metal", .type = KeyType::choice};
    spec.choices = enum_names<Metal>;
    spec.get = [](const KeyOwner& owner) -> KeyValue {
        const M& m = *owner.as<const M>();
        return m.metal ? key_value(*m.metal) : KeyValue();
    };
    spec.set = [](const KeyOwner& owner, const KeyValue& value) {
        assign(owner.as<M>()->metal.emplace(), value);
    };
    return KeyRow(std::move(spec));
}

KeyRow roughness() {
    return number<&M::roughness>("roughness")
        .range(share)
        .help("r; the microfacets' α is r²; below 0.01 it is smooth");
}

using Keys = std::vector<KeySpec>;

constexpr auto whitted = Model::whitted, diffuse = Model::diffuse, conductor = Model::conductor,
               dielectric = Model::dielectric, plastic = Model::plastic, principled = Model::principled;

Keys colors() {
    return {
        color<&M::color>("color").only({whitted, diffuse, plastic, principled}).help("c"),
        color_of_conductor()
            .only({conductor})
            .or_else("metal")
            .help("reflectance at normal incidence, or name a `metal`"),
        metal()
            .only({conductor})
            .instead_of("color")
            .help("a metal whose index of refraction was measured (light-model.md)"),
        color<&M::color>("color")
            .only({dielectric})
            .initially([]() -> KeyValue { return default_color(dielectric); })
            .help("multiplies light each time that it is refracted; on thin sheets once"),
    };
}

/// Of the report's model.
Keys coefficients() {
    return {
        factor<&M::ambient>("ambient").help("k_a, share of the ambient light; for Whitted's light model"),
        factor<&M::diffuse>("diffuse").only({whitted}).help("k_d, share of the light that arrives"),
        factor<&M::highlight>("highlight").only({whitted}).help("k, strength of the highlight"),
        factor<&M::shininess>("shininess")
            .only({whitted})
            .typical(1, 1000)
            .logarithmic()
            .help("m, the highlight's exponent"),
        factor<&M::reflectivity>("reflectivity")
            .only({whitted})
            .help("ρ, weight of the mirror image; above 1 gives more light than it gets, and warns"),
        number<&M::transparency>("transparency")
            .only({whitted})
            .range(share)
            .help("τ, weight of what is seen through it"),
    };
}

Keys media() {
    return {
        number<&M::index>("index")
            .only({whitted, dielectric, plastic, principled})
            .range(above_0)
            .limits(divisor)
            .typical(1, 2.5)
            .help("η of refraction; `whitted` uses it where τ > 0"),
        color<&M::absorption>("absorption", KeyType::rgb)
            .only({whitted, dielectric, principled})
            .unit("per scene unit")
            .help("σ, inside solids: light fades as e^(−σ · distance)"),
        boolean<&M::fresnel>("fresnel").only({whitted}).help(
            "share ρ + τ between mirror and refraction by Fresnel's equations"),
    };
}

Keys roughnesses() {
    return {
        roughness().only({conductor, dielectric}),
        roughness().only({plastic}).initially([]() -> KeyValue { return plastic_roughness; }),
        roughness().only({principled}).initially([]() -> KeyValue { return principled_roughness; }),
    };
}

KeyRow share_of_principled(KeyRow&& row) { return std::move(row).only({principled}).range(share); }

Keys principled_keys() {
    return {
        share_of_principled(number<&M::metallic>("metallic")).help("1: a metal of this colour"),
        share_of_principled(number<&M::transmission>("transmission"))
            .help("share of the light below the surface that goes through rather than being diffused"),
        share_of_principled(number<&M::clearcoat>("clearcoat")).help("strength of a coat of lacquer"),
        share_of_principled(number<&M::clearcoat_roughness>("clearcoat_roughness")),
        share_of_principled(number<&M::sheen>("sheen")).help("strength of the sheen of cloth"),
        color<&M::sheen_color>("sheen_color").only({principled}),
        share_of_principled(number<&M::sheen_roughness>("sheen_roughness")),
        share_of_principled(number<&M::specular>("specular"))
            .help("strength of the reflection of what is not metallic"),
        color<&M::specular_color>("specular_color")
            .only({principled})
            .help("tints that reflection at normal incidence"),
    };
}

Keys common() {
    return {
        color<&M::emission>("emission").help("light of its own: radiance that leaves the surface"),
        choice<&M::emission_sides>("emission_sides")
            .help("front: from the side of the normal alone, outward of solids"),
        number<&M::opacity>("opacity").range(share).help(
            "the share of the surface that is there, the rest lets light through; drawn opaque by `whitted`"),
    };
}

} // namespace

TableSpec material_table() {
    TableSpec table{.name = "material",
                    .form = TableForm::named,
                    .selector = "model",
                    .help = "What surfaces look like. Objects name it. Both light models read every `model`.",
                    .keys = {model().help("what the other keys mean")}};
    for (const Keys& keys : {colors(), coefficients(), media(), roughnesses(), principled_keys(), common()})
        table.keys.insert(table.keys.end(), keys.begin(), keys.end());
    return table;
}

} // namespace glint::scene::keys
