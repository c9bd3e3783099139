#include "scene/keys/check.h"

#include "glint/limits.h"
#include "math/vec.h"
#include "scene/text.h"

#include <algorithm>
#include <cmath>

namespace glint::scene {
namespace {

bool is_zero(const Vec3& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Below this the squared length is no longer a normal double, and the direction would be lost.
bool has_direction(const Vec3& v) { return std::isnormal(glm::dot(v, v)); }

bool is_affine(const Mat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

bool is_finite(const Mat4& m) {
    return std::all_of(&m[0].x, &m[0].x + 16, [](double x) { return std::isfinite(x); });
}

double product_of_lengths(const glm::dmat3& m) {
    return glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
}

// Regular: the determinant is not lost in its own rounding, measured against the columns or the rows.
bool is_regular(const Mat4& matrix) {
    const glm::dmat3 m(matrix);
    const double volume = std::abs(glm::determinant(m));
    const double largest = std::min(product_of_lengths(m), product_of_lengths(glm::transpose(m)));
    return std::isnormal(volume) && volume > 1e-15 * largest;
}

std::string quoted(const KeySpec& key) { return in_quotes(key.key); }

/// Finds the first number that is wrong.
struct NumberCheck {
    const KeySpec& key;

    std::optional<KeyFault> all(const double* first, std::size_t count) const {
        for (std::size_t i = 0; i < count; ++i)
            if (auto fault = number_fault(key, first[i])) return fault;
        return std::nullopt;
    }

    std::optional<KeyFault> operator()(double x) const { return number_fault(key, x); }
    std::optional<KeyFault> operator()(std::int64_t x) const { return (*this)(static_cast<double>(x)); }
    std::optional<KeyFault> operator()(std::uint64_t x) const { return (*this)(static_cast<double>(x)); }
    template <class Number>
    std::optional<KeyFault> operator()(const std::optional<Number>& x) const {
        return x ? (*this)(*x) : std::nullopt;
    }
    std::optional<KeyFault> operator()(const std::array<int, 2>& pair) const {
        const auto fault = (*this)(static_cast<double>(pair[0]));
        return fault ? fault : (*this)(static_cast<double>(pair[1]));
    }
    std::optional<KeyFault> operator()(const Vec3& v) const { return all(&v.x, 3); }
    std::optional<KeyFault> operator()(const std::array<Vec3, 3>& points) const {
        return all(&points[0].x, 9);
    }
    std::optional<KeyFault> operator()(const Mat4& m) const { return all(&m[0].x, 16); }
    template <class Other>
    std::optional<KeyFault> operator()(const Other&) const {
        return std::nullopt;
    }
};

std::optional<KeyFault> size_fault(const KeySpec& key, const std::array<int, 2>& size) {
    if (std::int64_t{size[0]} * size[1] <= picture_pixel_limit) return std::nullopt;
    return KeyFault{quoted(key) + " is above 2^30 pixels", {}};
}

std::optional<KeyFault> order_fault(const KeySpec& key, const std::array<int, 2>& frames) {
    if (frames[0] <= frames[1]) return std::nullopt;
    return KeyFault{"the last of " + quoted(key) + " comes before the first", {}};
}

std::optional<KeyFault> direction_fault(const KeySpec& key, const Vec3& v) {
    if (has_direction(v)) return std::nullopt;
    return KeyFault{quoted(key) + (is_zero(v) ? " must not be zero" : " has a length beyond all measure"),
                    "expected a direction [x, y, z]"};
}

std::optional<KeyFault> scale_fault(const KeySpec& key, const Vec3& v) {
    if (v.x != 0 && v.y != 0 && v.z != 0) return std::nullopt;
    return KeyFault{quoted(key) + " must not be 0", "negative numbers mirror"};
}

std::optional<KeyFault> affine_fault(const KeySpec& key, const Mat4& m) {
    if (is_affine(m)) return std::nullopt;
    return KeyFault{quoted(key) + " is not affine: its last row must be 0, 0, 0, 1", {}};
}

std::optional<KeyFault> matrix_fault(const KeySpec& key, const Mat4& m) {
    if (auto fault = affine_fault(key, m)) return fault;
    if (is_regular(m)) return std::nullopt;
    return KeyFault{quoted(key) + " is singular: it flattens what it transforms", {}};
}

/// Many entries, each of them good, may still shrink or grow without end.
std::optional<KeyFault> transform_fault(const KeySpec& key, const Mat4& m) {
    if (is_finite(m) && is_regular(m)) return affine_fault(key, m);
    return KeyFault{quoted(key) + " as a whole is not regular: it scales beyond all measure", {}};
}

std::optional<KeyFault> choice_fault(const KeySpec& key, Choice choice) {
    if (choice.index < key.choices.size()) return std::nullopt;
    return KeyFault{"unknown " + std::string(key.key) + " number " + std::to_string(choice.index), {}};
}

} // namespace

std::optional<KeyFault> number_fault(const KeySpec& key, double x) {
    const bool finite = std::isfinite(x), in_range = key.range.contains(x);
    if (finite && in_range && key.limits.contains(x)) return std::nullopt;
    const std::string expected = !finite ? "finite" : in_range ? key.limits.text() : key.range.text();
    return KeyFault{quoted(key) + " must be " + expected + ", found " + show(x), {}};
}

std::optional<KeyFault> value_fault(const KeySpec& key, const KeyValue& value) {
    switch (key.type) {
    case KeyType::size:
        return size_fault(key, std::get<std::array<int, 2>>(value));
    case KeyType::frame_range:
        return order_fault(key, std::get<std::array<int, 2>>(value));
    case KeyType::direction:
        return direction_fault(key, std::get<Vec3>(value));
    case KeyType::scale:
        return scale_fault(key, std::get<Vec3>(value));
    case KeyType::matrix:
        return matrix_fault(key, std::get<Mat4>(value));
    case KeyType::transform:
        return transform_fault(key, std::get<Mat4>(value));
    case KeyType::choice:
        return choice_fault(key, std::get<Choice>(value));
    default:
        return std::nullopt;
    }
}

std::optional<KeyFault> fault_of(const KeySpec& key, const KeyValue& value) {
    if (std::holds_alternative<std::monostate>(value)) return std::nullopt;
    if (auto fault = std::visit(NumberCheck{key}, value)) return fault;
    return value_fault(key, value);
}

KeyFault unknown_material(const std::string& name) {
    return {"unknown material " + in_quotes(name), "define it as [material." + name + "]"};
}

std::optional<KeyFault> view_fault(const CameraDescription& camera) {
    // Relative to both lengths: what is left of a cross product of parallel vectors is rounding.
    const Vec3 side = glm::cross(camera.direction, camera.up);
    const double lengths = glm::length(camera.direction) * glm::length(camera.up);
    if (glm::length(side) > 1e-12 * lengths) return std::nullopt;
    return KeyFault{"\"up\" is parallel to the view", "choose an up that the camera does not look along"};
}

std::optional<KeyFault> balance_fault(const Material& m) {
    const double sum = m.reflectivity + m.transparency;
    if (sum <= 1) return std::nullopt;
    return KeyFault{"material " + in_quotes(m.name) + " has reflectivity + transparency = " + show(sum),
                    "energy = \"balanced\" needs at most 1"};
}

} // namespace glint::scene
