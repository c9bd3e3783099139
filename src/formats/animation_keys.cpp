#include "formats/animation_keys.h"

namespace glint {
namespace {

constexpr Range frame_number{.low = -1e6, .high = 1e6};

} // namespace

TableSpec animation_table() {
    return {.name = "animation",
            .help = "What frames there are. `--frames` of the command line chooses among them.",
            .keys = {
                {.key = "frames",
                 .type = KeyType::frame_range,
                 .unit = "frames",
                 .range = frame_number,
                 .help = "the first and the last; without it from 0 to the last keyframe"},
                {.key = "fps",
                 .fallback = "24",
                 .unit = "frames per second",
                 .range = {.low = 0, .high = 1000, .low_open = true},
                 .help = "how fast they are to be shown"},
            }};
}

TableSpec animate_table() {
    return {
        .name = "animate",
        .form = TableForm::list,
        .help =
            "One value of the scene that moves from keyframe to keyframe. A picture without `--frames` shows "
            "the scene as its other tables say.",
        .keys = {
            {.key = "key",
             .type = KeyType::key_path,
             .required = true,
             .help = "what moves, named as for `-D`: `\"camera.eye\"`, `\"mesh.cat.transform.0.angle\"`"},
            {.key = "frames",
             .type = KeyType::frames,
             .unit = "frames",
             .range = frame_number,
             .required = true,
             .help = "the keyframes"},
            {.key = "values",
             .type = KeyType::values,
             .required = true,
             .help = "what the key has at each of them; colours by name may stand beside numbers"},
            {.key = "interpolation",
             .type = KeyType::choice,
             .fallback = "\"linear\"",
             .choices = "linear smooth step",
             .help =
                 "between keyframes: at even speed; without jumps of speed and without overshooting; not at "
                 "all. What has no values in between (`true`, names, files) steps"},
            {.key = "loop",
             .type = KeyType::boolean,
             .fallback = "false",
             .help = "start again at the last keyframe; without it the first and the last value hold"},
        }};
}

} // namespace glint
