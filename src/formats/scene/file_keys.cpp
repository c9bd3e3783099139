#include "formats/scene/file_keys.h"

#include "scene/keys/bind.h"

namespace glint {

template <>
inline constexpr NamesUpTo<ColorValues::linear> enum_names<ColorValues>{"srgb", "linear"};
template <>
inline constexpr NamesUpTo<Interpolation::step> enum_names<Interpolation>{"linear", "smooth", "step"};

namespace {

constexpr NumberRange frame_number{.low = -1e6, .high = 1e6};

/// Read by TrackReader: their form is that of another key.
keys::KeyRow values() { return keys::KeyRow({.key = "values", .type = KeyType::values}); }

} // namespace

TableSpec top_table() {
    using namespace keys;
    return {.name = "",
            .form = TableForm::root,
            .help = "Before the first table.",
            .keys = {
                integer<&FileTop::version>("version").help("of this format; there is no other yet"),
                choice<&FileTop::color_values>("color_values")
                    .help("how colours given by name or `#` become light: decoded from sRGB, or plain "
                          "numbers / 255"),
            }};
}

TableSpec transform_table() {
    using namespace keys;
    using E = TransformEntry;
    return {.name = "transform",
            .form = TableForm::entry,
            .help = "Each entry holds one of these. Rotations and scalings are about the world's origin.",
            .keys = {
                point<&E::translate>("translate").no_default(),
                direction<&E::rotate>("rotate").no_default().help("the axis; goes with `angle`"),
                number<&E::angle>("angle")
                    .unit("degrees")
                    .range(coordinate)
                    .no_default()
                    .help("goes with `rotate`; counter-clockwise looking against the axis"),
                scale<&E::scale>("scale").no_default().help("negative mirrors"),
                bound<Mat4, &E::matrix>("matrix", KeyType::matrix)
                    .no_default()
                    .help("affine and regular: the last row is 0, 0, 0, 1"),
            }};
}

TableSpec animation_table() {
    using namespace keys;
    using A = AnimationTable;
    return {.name = "animation",
            .help = "What frames there are. `--frames` of the command line chooses among them.",
            .keys = {
                bound<std::array<int, 2>, &A::frames>("frames", KeyType::frame_range)
                    .unit("frames")
                    .range(frame_number)
                    .no_default()
                    .help("the first and the last; without it from 0 to the last keyframe"),
                number<&A::fps>("fps")
                    .unit("frames per second")
                    .range({.low = 0, .high = 1000, .low_open = true})
                    .help("how fast they are to be shown"),
            }};
}

TableSpec animate_table() {
    using namespace keys;
    using A = AnimateTable;
    return {
        .name = "animate",
        .form = TableForm::list,
        .help =
            "One value of the scene that moves from keyframe to keyframe. A picture without `--frames` shows "
            "the scene as its other tables say.",
        .keys = {
            text<&A::key>("key", KeyType::key_path)
                .required()
                .help("what moves, named as for `-D`: `\"camera.eye\"`, `\"mesh.cat.transform.0.angle\"`"),
            bound<std::vector<double>, &A::frames>("frames", KeyType::frames)
                .unit("frames")
                .range(frame_number)
                .required()
                .help("the keyframes"),
            values().required().help(
                "what the key has at each of them; colours by name may stand beside numbers"),
            choice<&A::interpolation>("interpolation")
                .help("between keyframes: at even speed; without jumps of speed and without overshooting; "
                      "not at all. What has no values in between (`true`, names, files) steps"),
            boolean<&A::loop>("loop").help(
                "start again at the last keyframe; without it the first and the last value hold"),
        }};
}

} // namespace glint
