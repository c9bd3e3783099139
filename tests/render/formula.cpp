#include "formula.h"

#include "math/elementary.shared.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace glint::test {
namespace {

Number scalar(float x) { return {glm::vec3(x), false}; }
Number vector(const glm::vec3& v) { return {v, true}; }

/// Recursive descent: sum, product, power, atom.
class Reader {
  public:
    Reader(const std::string& text, const std::map<std::string, Number>& values)
        : text_(text), values_(values) {}

    Number read() {
        const Number result = sum();
        if (at_ != text_.size()) fail("the end");
        return result;
    }

  private:
    [[noreturn]] void fail(const std::string& expected) const {
        throw std::runtime_error("expected " + expected + " at \"" + text_.substr(at_) + "\" of \"" + text_ +
                                 "\"");
    }
    void skip_spaces() {
        while (at_ < text_.size() && text_[at_] == ' ') ++at_;
    }
    bool take(const std::string& sign) {
        skip_spaces();
        if (text_.compare(at_, sign.size(), sign) != 0) return false;
        at_ += sign.size();
        skip_spaces();
        return true;
    }
    void need(const std::string& sign) {
        if (!take(sign)) fail(sign);
    }

    Number sum() {
        Number left = product();
        for (;;) {
            if (take("+")) {
                const Number right = product();
                left = {left.v + right.v, left.vector || right.vector};
            } else if (take("−")) {
                const Number right = product();
                left = {left.v - right.v, left.vector || right.vector};
            } else {
                return left;
            }
        }
    }

    Number product() {
        Number left = signed_power();
        for (;;) {
            if (take("·")) {
                const Number right = signed_power();
                if (left.vector && right.vector)
                    left = scalar(glm::dot(left.v, right.v));
                else
                    left = {left.v * right.v, left.vector || right.vector};
            } else if (take("⊙")) {
                const Number right = signed_power();
                left = {left.v * right.v, true};
            } else if (take("/")) {
                const Number right = signed_power();
                left = {left.v / right.v, left.vector || right.vector};
            } else {
                return left;
            }
        }
    }

    Number signed_power() {
        if (!take("−")) return power();
        const Number x = signed_power();
        return {-x.v, x.vector};
    }

    Number power() {
        Number base = atom();
        if (take("²")) return {base.v * base.v, base.vector};
        if (!take("^")) return base;
        const Number exponent = atom();
        return scalar(pow_of(base.v.x, exponent.v.x));
    }

    Number atom() {
        skip_spaces();
        if (const Number* known = symbol()) return *known;
        if (take("(")) return closed(sum());
        if (take("|")) return length();
        if (take("√(")) return closed(root(sum()));
        if (take("e^(")) return closed(exponential(sum()));
        if (take("normalize(")) return closed(normalized(sum()));
        if (take("arccos(")) return closed(degrees(std::acos(clamped(sum()))));
        if (take("arcsin(")) return closed(degrees(std::asin(clamped(sum()))));
        if (take("max(")) return extreme(true);
        if (take("min(")) return extreme(false);
        std::size_t used = 0;
        try {
            const float x = std::stof(text_.substr(at_), &used);
            at_ += used;
            return scalar(x);
        } catch (const std::exception&) {
            fail("a number");
        }
    }

    /// The longest symbol that stands here whole.
    const Number* symbol() {
        const Number* best = nullptr;
        std::size_t longest = 0;
        for (const auto& [name, value] : values_) {
            if (name.size() <= longest || text_.compare(at_, name.size(), name) != 0) continue;
            if (goes_on(at_ + name.size())) continue;
            longest = name.size();
            best = &value;
        }
        at_ += longest;
        return best;
    }
    /// Does a word go on here? Signs of more than one byte end it.
    bool goes_on(std::size_t at) const {
        if (at >= text_.size()) return false;
        for (const char* sign : {"·", "⊙", "−", "√", "²"})
            if (text_.compare(at, std::string(sign).size(), sign) == 0) return false;
        const auto c = static_cast<unsigned char>(text_[at]);
        return c >= 0x80 || std::isalnum(c) != 0 || c == '_';
    }

    Number closed(const Number& x) {
        need(")");
        return x;
    }
    Number length() {
        const Number x = sum();
        need("|");
        return scalar(std::sqrt(glm::dot(x.v, x.v)));
    }
    Number extreme(bool largest) {
        Number a = sum();
        if (take(")")) return scalar(std::max({a.v.x, a.v.y, a.v.z}));
        need(",");
        const Number b = closed(sum());
        return {largest ? glm::max(a.v, b.v) : glm::min(a.v, b.v), a.vector || b.vector};
    }
    static Number root(const Number& x) { return scalar(std::sqrt(x.v.x)); }
    static Number exponential(const Number& x) {
        return {glm::vec3(exp_of(x.v.x), exp_of(x.v.y), exp_of(x.v.z)), x.vector};
    }
    static Number normalized(const Number& x) { return vector(glm::normalize(x.v)); }
    static double clamped(const Number& x) { return std::clamp(static_cast<double>(x.v.x), -1.0, 1.0); }
    static Number degrees(double radians) {
        return scalar(static_cast<float>(radians * 180 / 3.14159265358979323846));
    }

    const std::string& text_;
    const std::map<std::string, Number>& values_;
    std::size_t at_ = 0;
};

} // namespace

Number evaluate(const std::string& formula, const std::map<std::string, Number>& values) {
    return Reader(formula, values).read();
}

} // namespace glint::test
