// Names of enumerators in explanations.

#include "glint/explanation.h"

namespace glint {

const char* ray_kind_name(RayKind kind) {
    switch (kind) {
    case RayKind::primary:
        return "primary";
    case RayKind::reflected:
        return "reflected";
    case RayKind::refracted:
        return "refracted";
    }
    return "";
}

const char* ray_end_name(RayEnd end) {
    switch (end) {
    case RayEnd::bounced:
        return "bounced";
    case RayEnd::matte:
        return "matte";
    case RayEnd::depth_limit:
        return "depth_limit";
    case RayEnd::background:
        return "background";
    case RayEnd::absorbed:
        return "absorbed";
    }
    return "";
}

} // namespace glint
