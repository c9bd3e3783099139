// Splitting formulas into symbols, and inserting numbers.

#include "formats/explain/formula.h"

#include "glint/explanation_files.h"
#include "scene/text.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace glint::formats {

namespace {

/// Multi-byte characters that are not letters.
constexpr std::string_view signs[] = {"·", "⊙", "−", "√", "²"};

std::size_t sign_at(std::string_view text, std::size_t at) {
    for (const std::string_view sign : signs)
        if (text.substr(at, sign.size()) == sign) return sign.size();
    return 0;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(std::string_view text, std::size_t at) {
    const char c = text[at];
    if ((static_cast<unsigned char>(c) & 0x80u) != 0) return sign_at(text, at) == 0;
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

/// End of the word that starts at a letter.
std::size_t word_end(std::string_view text, std::size_t at) {
    while (at < text.size() && (is_letter(text, at) || is_digit(text[at]))) {
        ++at;
        while (at < text.size() && scene::continues_utf8(text[at])) ++at;
    }
    return at;
}

} // namespace

Scope::Scope(const ExplainedRay& ray, const ExplainedLight* light) : lists_{&ray.given, &ray.steps} {
    if (light != nullptr) lists_.push_back(&light->steps);
}

const Step* Scope::find(std::string_view symbol) const {
    for (auto list = lists_.rbegin(); list != lists_.rend(); ++list)
        for (const Step& step : **list)
            if (step.symbol == symbol) return &step;
    return nullptr;
}

template <class Part>
void Scope::split(std::string_view formula, const Part& part) const {
    for (std::size_t at = 0; at < formula.size();) {
        std::size_t end = at;
        const Step* step = nullptr;
        if (is_letter(formula, at)) {
            end = word_end(formula, at);
            // r² is a quantity if one has that symbol, otherwise a square.
            constexpr std::string_view square = "²";
            if (formula.substr(end, square.size()) == square)
                step = find(formula.substr(at, end + square.size() - at));
            if (step != nullptr)
                end += square.size();
            else
                step = find(formula.substr(at, end - at));
        } else {
            end += std::max<std::size_t>(1, sign_at(formula, at));
        }
        part(formula.substr(at, end - at), step);
        at = end;
    }
}

std::vector<const Step*> Scope::named_in(std::string_view formula) const {
    std::vector<const Step*> found;
    split(formula, [&](std::string_view, const Step* step) {
        if (step != nullptr && std::find(found.begin(), found.end(), step) == found.end())
            found.push_back(step);
    });
    return found;
}

std::string Scope::filled_in(const Step& step) const {
    std::string text;
    split(step.formula, [&](std::string_view part, const Step* named) {
        if (named == nullptr) return void(text += part);
        const std::string number = quantity_text(named->result, readable_digits);
        // Put negative numbers in parentheses, as their sign would read as an operator.
        text += !named->result.vector && number.rfind("−", 0) == 0 ? "(" + number + ")" : number;
    });
    return text == step.formula || text == quantity_text(step.result, readable_digits) ? "" : text;
}

std::string origin_text(const Explanation& explanation) {
    const glm::dvec3& origin = explanation.origin;
    if (origin == glm::dvec3(0)) return {};
    return "positions are relative to (" + scene::show(origin) + "), about which the scene is traced";
}

std::string number_text(float x, int digits) {
    if (std::isnan(x)) return "not a number";
    if (std::isinf(x)) return x > 0 ? "∞" : "−∞";
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, static_cast<double>(x));
    std::string text = buffer;
    const bool negative = text.front() == '-';
    if (negative) text.erase(0, 1);
    return (negative ? "−" : "") + text;
}

} // namespace glint::formats

namespace glint {

std::string formula_in_numbers(const Step& step, const ExplainedRay& ray, const ExplainedLight* light) {
    return formats::Scope(ray, light).filled_in(step);
}

std::string quantity_text(const Quantity& q, int digits) {
    if (!q.vector) return formats::number_text(q.value.x, digits);
    return "(" + formats::number_text(q.value.x, digits) + ", " + formats::number_text(q.value.y, digits) +
           ", " + formats::number_text(q.value.z, digits) + ")";
}

std::string other_pixel_text(const Explanation& explanation, const OtherPixel& other, int digits) {
    const glm::vec3 off = glm::abs(other.color - explanation.color);
    return "on " + other.device + " it is " + quantity_text(other.color, digits) + ", off by at most " +
           formats::number_text(std::max({off.x, off.y, off.z}), 3);
}

} // namespace glint
