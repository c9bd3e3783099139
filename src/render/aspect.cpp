#include "render/aspect.h"

namespace glint {

bool is_light(Aspect aspect) { return aspect == Aspect::final || term_of(aspect); }

std::optional<Term> term_of(Aspect aspect) {
    const int number = static_cast<int>(aspect) - static_cast<int>(Aspect::ambient);
    if (number < 0 || number >= term_count) return std::nullopt;
    return static_cast<Term>(number);
}

const char* aspect_name(Aspect aspect) {
    if (const auto term = term_of(aspect)) return term_name(*term);
    switch (aspect) {
    case Aspect::shadows:
        return "shadows";
    case Aspect::normal:
        return "normal";
    case Aspect::depth:
        return "depth";
    case Aspect::cost:
        return "cost";
    default:
        return "final";
    }
}

} // namespace glint
