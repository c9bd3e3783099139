// [material.NAME].

#include "scene/keys/bind.h"
#include "scene/keys/tables.h"

namespace glint::scene::keys {

TableSpec material_table() {
    using M = Material;
    return {.name = "material",
            .form = TableForm::named,
            .help = "What surfaces look like. Objects name it.",
            .keys = {
                color<&M::color>("color").help("c"),
                factor<&M::ambient>("ambient").help("k_a, share of the ambient light"),
                factor<&M::diffuse>("diffuse").help("k_d, share of the light that arrives"),
                factor<&M::highlight>("highlight").help("k, strength of the highlight"),
                factor<&M::shininess>("shininess")
                    .typical(1, 1000)
                    .logarithmic()
                    .help("m, the highlight's exponent"),
                factor<&M::reflectivity>("reflectivity")
                    .help("ρ, weight of the mirror image; above 1 gives more light than it gets, and warns"),
                number<&M::transparency>("transparency")
                    .range(share)
                    .help("τ, weight of what is seen through it"),
                number<&M::index>("index").range(above_0).limits(divisor).typical(1, 2.5).help(
                    "η of refraction, used where τ > 0"),
                color<&M::absorption>("absorption", KeyType::rgb)
                    .unit("per scene unit")
                    .help("σ, inside solids: light fades as e^(−σ · distance)"),
                boolean<&M::fresnel>("fresnel").help(
                    "share ρ + τ between mirror and refraction by Fresnel's equations"),
                color<&M::emission>("emission").help("light of its own"),
            }};
}

} // namespace glint::scene::keys
