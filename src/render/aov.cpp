#include "render/aov.h"

namespace glint {

bool is_light(Aov aov) { return aov == Aov::final || term_of(aov); }

std::optional<Term> term_of(Aov aov) {
    const int number = static_cast<int>(aov) - static_cast<int>(Aov::ambient);
    if (number < 0 || number >= term_count) return std::nullopt;
    return static_cast<Term>(number);
}

const char* aov_name(Aov aov) {
    if (const auto term = term_of(aov)) return term_name(*term);
    switch (aov) {
    case Aov::shadows:
        return "shadows";
    case Aov::normal:
        return "normal";
    case Aov::depth:
        return "depth";
    case Aov::cost:
        return "cost";
    default:
        return "final";
    }
}

} // namespace glint
