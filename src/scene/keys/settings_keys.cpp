// [camera], [render] and the settings of the integrators.

#include "scene/keys/bind.h"
#include "scene/keys/tables.h"

namespace glint::scene::keys {
namespace {

/// Sets the direction, after the eye was read. It is written as `direction`.
KeyRow look_at() {
    KeySpec spec{.key = "look_at", .type = KeyType::point};
    spec.set = [](const KeyOwner& owner, const KeyValue& value) {
        auto& camera = *owner.as<CameraDescription>();
        camera.direction = std::get<Vec3>(value) - camera.eye;
    };
    return KeyRow(std::move(spec)).unit("scene units").range(coordinate).required().or_else("direction");
}

KeyRow picture_size() {
    KeySpec spec{.key = "size", .type = KeyType::size};
    spec.get = [](const KeyOwner& owner) -> KeyValue {
        const auto& settings = *owner.as<const RenderSettings>();
        return std::array{settings.width, settings.height};
    };
    spec.set = [](const KeyOwner& owner, const KeyValue& value) {
        auto& settings = *owner.as<RenderSettings>();
        settings.width = std::get<std::array<int, 2>>(value)[0];
        settings.height = std::get<std::array<int, 2>>(value)[1];
    };
    spec.initial = []() -> KeyValue { return std::array{RenderSettings{}.width, RenderSettings{}.height}; };
    return KeyRow(std::move(spec)).unit("pixels").range(between(1, picture_side_limit));
}

} // namespace

TableSpec camera_table() {
    using C = CameraDescription;
    return {.name = "camera",
            .help = "A pinhole camera. Without this table everything finite is framed.",
            .keys = {
                point<&C::eye>("eye").required().help("where the camera is"),
                look_at().help("the point in the middle of the picture"),
                direction<&C::direction>("direction")
                    .instead_of("look_at")
                    .help("where the camera looks, instead of `look_at`"),
                direction<&C::up>("up").help("what points up in the picture; not parallel to the view"),
                number<&C::fov>("fov")
                    .unit("degrees")
                    .range({.low = 0, .high = 180, .low_open = true, .high_open = true})
                    .typical(1, 150)
                    .help("full angle of view"),
                choice<&C::fov_axis>("fov_axis").help("the side of the picture that `fov` spans"),
            }};
}

TableSpec render_table() {
    using R = RenderSettings;
    return {
        .name = "render",
        .help = "The picture. Flags of the command line override these.",
        .keys = {
            picture_size().help("width and height; at most 2^30 pixels"),
            integer_or_auto<&R::spp>("spp")
                .range(between(1, sample_limit))
                .typical(1, 64)
                .help("samples per pixel; 1 is the pixel's centre; `\"auto\"`: 1, and 8 (or `max_spp`) where "
                      "neighbours differ; 64 of paths, 4 of `ambient-occlusion`"),
            integer<&R::max_spp>("max_spp")
                .range(between(0, sample_limit))
                .typical(0, 64)
                .help("samples of each pixel that differs from a neighbour, if more than `spp`"),
            integer<&R::seed>("seed").range(at_least_0).help("of the random numbers"),
            choice<&R::integrator>("integrator").help("the light model"),
            choice<&R::filter>("filter").help(
                "of the pixels; radius in pixels: box 0.5, tent 1, gaussian 1.5, mitchell 2 (its negative "
                "lobes count from 16 samples on)"),
            color<&R::background>("background").not_in_metadata().help("what rays see that hit nothing"),
        }};
}

TableSpec whitted_table() {
    using W = WhittedSettings;
    return {
        .name = "whitted",
        .help = "The recursive light model.",
        .keys = {
            integer<&W::max_depth>("max_depth")
                .range(between(0, 1000))
                .typical(0, 16)
                .help("bounces after the first hit"),
            number<&W::min_weight>("min_weight")
                .range(share)
                .typical(0, 0.01)
                .help("rays that carry a smaller share of a sample's light are not followed; 0: all are"),
            choice<&W::shadows>("shadows").help("whether light shines through transparent objects"),
            boolean<&W::clamp>("clamp").help("limit each light's diffuse term, and then the local sum, to 1"),
            choice<&W::energy>("energy").help(
                "`\"balanced\"` scales the local light by 1 − ρ − τ and needs ρ + τ ≤ 1; `\"report\"`, "
                "written down, says that materials may give more light than they get"),
            choice<&W::highlight_model>("highlight_model")
                .help("by the half-way vector, or by the mirror direction"),
            number<&W::index>("index").range(above_0).limits(divisor).typical(1, 2).not_in_metadata().help(
                "of refraction, of what surrounds everything"),
        }};
}

TableSpec path_table() {
    using P = PathSettings;
    return {
        .name = "path",
        .help = "All of light, by paths: integrators `\"path\"`, `\"path-simple\"` and `\"direct\"`.",
        .keys = {
            integer<&P::max_depth>("max_depth")
                .range(between(0, 1000))
                .typical(0, 64)
                .help("bounces after the first hit"),
            integer<&P::max_diffuse_bounces>("max_diffuse_bounces")
                .range(between(0, 1000))
                .typical(0, 16)
                .help("of these, bounces that are not by mirrors or smooth glass; `\"direct\"` has none"),
            integer<&P::roulette_depth>("roulette_depth")
                .range(between(1, 1000))
                .typical(1, 16)
                .help("the first bounce that may end a path at random, the more likely the less light it "
                      "carries; what goes on weighs more"),
            choice<&P::light_sampling>("light_sampling")
                .help("how lights are chosen: alike, by their power, or by what arrives from them"),
            number<&P::clamp_indirect>("clamp_indirect")
                .range(at_least_0)
                .limits(single_precision)
                .typical(0, 10)
                .help("largest radiance of a sample's indirect light: less noise, and less light; 0: as it "
                      "is"),
            choice<&P::shadows>("shadows").help(
                "`\"exact\"`: light through solid glass arrives by paths; `\"transmissive\"`: it shines "
                "straight through, as in Whitted's model"),
        }};
}

TableSpec ambient_occlusion_table() {
    using A = AmbientOcclusionSettings;
    return {.name = "ambient_occlusion",
            .help = "How open the surroundings of surfaces are, without lights.",
            .keys = {
                bound<std::optional<double>, &A::distance>("distance", KeyType::number_or_auto)
                    .unit("scene units")
                    .range(length)
                    .help("how near what darkens a surface must be; `auto`: a tenth of the diagonal of "
                          "everything finite"),
                boolean<&A::colored>("colored").help("multiply by the colours of the materials"),
            }};
}

} // namespace glint::scene::keys
