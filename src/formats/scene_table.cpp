#include "formats/scene_table.h"

#include "formats/scene_words.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace glint {
namespace {

using Kind = TreeValue::Kind;

bool is_number(const TreeValue& value) { return value.kind == Kind::integer || value.kind == Kind::number; }

Vec3 vec3_of(const TreeValue& list) {
    return {list.items[0].number, list.items[1].number, list.items[2].number};
}

std::string label_of(const KeySpec& spec) { return in_quotes(spec.key); }

// Below this the squared length is no longer a normal double, and the direction would be lost.
bool has_direction(const Vec3& v) { return std::isnormal(glm::dot(v, v)); }

bool affine(const Mat4& m) { return m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0 && m[3][3] == 1; }

double product_of_lengths(const glm::dmat3& m) {
    return glm::length(m[0]) * glm::length(m[1]) * glm::length(m[2]);
}

// Regular: the determinant is not lost in its own rounding, measured against the columns or the rows.
bool regular(const Mat4& matrix) {
    const glm::dmat3 m(matrix);
    const double volume = std::abs(glm::determinant(m));
    const double largest = std::min(product_of_lengths(m), product_of_lengths(glm::transpose(m)));
    return std::isnormal(volume) && volume > 1e-15 * largest;
}

} // namespace

TableReader::TableReader(const TreeValue& table, const TableSpec& spec, std::string label, std::string type,
                         const ReadContext& context)
    : table_(table), spec_(spec), label_(std::move(label)), type_(std::move(type)), context_(context) {
    check_known();
    check_required();
}

void TableReader::check_known() {
    for (const TreeEntry& entry : table_.entries) {
        if (find_key(spec_, entry.key, type_)) continue;
        const auto names = key_names(spec_, type_);
        if (find_key(spec_, entry.key, {}))
            error(entry.where,
                  "key " + in_quotes(entry.key) + " does not belong to " + label_ + " with " +
                      std::string(spec_.selector) + " = " + in_quotes(type_),
                  "its keys are " + listed(names));
        else {
            std::string hint = context_.problems.suggestion(entry.key, names);
            if (hint.empty()) hint = "its keys are " + listed(names);
            error(entry.where, "unknown key " + in_quotes(entry.key) + " in " + label_, std::move(hint));
        }
    }
}

void TableReader::check_required() {
    for (const KeySpec& spec : spec_.keys) {
        if (find_key(spec_, spec.key, type_) != &spec || (type_.empty() && !spec.types.empty())) continue;
        const bool either = !spec.alternative.empty() && has(spec.alternative);
        // Of two keys that exclude each other the later one is reported, once.
        if (either && has(spec.key) && place(spec.alternative) < place(spec.key))
            error(place(spec.key),
                  label_of(spec) + " cannot go together with " + in_quotes(spec.alternative) + " in " +
                      label_,
                  "keep one of them");
        if (!spec.required || context_.patch || either || has(spec.key)) continue;
        std::string what = "missing required key " + label_of(spec);
        if (!spec.alternative.empty()) what += " (or " + in_quotes(spec.alternative) + ")";
        error(header(), what + " in " + label_, std::string(spec.help));
    }
}

void TableReader::error(const Place& place, std::string message, std::string hint) {
    good_ = false;
    context_.problems.error(place, std::move(message), std::move(hint));
}

Place TableReader::place(std::string_view key) const {
    const TreeEntry* entry = table_.find(key);
    return entry ? entry->value.where : table_.where;
}

TableReader::Found TableReader::find(std::string_view key) const {
    Found found{find_key(spec_, key, type_), nullptr};
    assert(find_key(spec_, key, {}) && "the key table lacks a key that is read");
    // A key that this type does not have was reported as such; its value does not matter.
    if (const TreeEntry* entry = found.spec ? table_.find(key) : nullptr) found.value = &entry->value;
    return found;
}

void TableReader::wrong_type(const Found& found, const TreeValue& value, std::string_view expected) {
    error(value.where, "expected " + std::string(expected) + " for " + label_of(*found.spec) + ", found " +
                           std::string(value.kind_words()));
}

bool TableReader::check_number(const Found& found, const TreeValue& value) {
    if (!is_number(value)) {
        wrong_type(found, value, "a number");
        return false;
    }
    if (!std::isfinite(value.number)) {
        error(value.where, label_of(*found.spec) + " must be finite, found " + show(value.number));
        return false;
    }
    Range range = found.spec->range;
    if (found.spec->type == KeyType::point || found.spec->type == KeyType::vertices)
        range = {.low = -coordinate_limit, .high = coordinate_limit};
    if (found.spec->type == KeyType::rgb || found.spec->type == KeyType::color) range = {.low = 0};
    if (range.contains(value.number)) return true;
    error(value.where, label_of(*found.spec) + " must be " + range.words() + ", found " + show(value.number));
    return false;
}

bool TableReader::check_integer(const Found& found, const TreeValue& value) {
    if (value.kind == Kind::integer) return check_number(found, value);
    wrong_type(found, value, "an integer");
    return false;
}

bool TableReader::check_numbers(const Found& found, const TreeValue& value, std::size_t count) {
    const std::string expected = "a list of " + std::to_string(count) + " numbers";
    if (value.kind != Kind::list) {
        wrong_type(found, value, expected);
        return false;
    }
    if (value.items.size() != count) {
        error(value.where, "expected " + expected + " for " + label_of(*found.spec) + ", found " +
                               std::to_string(value.items.size()));
        return false;
    }
    bool good = true;
    for (const TreeValue& item : value.items) good = check_number(found, item) && good;
    return good;
}

void TableReader::read(std::string_view key, bool& target) {
    const Found found = find(key);
    if (!found.value) return;
    if (found.value->kind == Kind::boolean)
        target = found.value->boolean;
    else
        wrong_type(found, *found.value, "a boolean (true or false)");
}

void TableReader::read(std::string_view key, int& target) {
    const Found found = find(key);
    if (found.value && check_integer(found, *found.value)) target = static_cast<int>(found.value->integer);
}

void TableReader::read(std::string_view key, std::uint64_t& target) {
    const Found found = find(key);
    if (found.value && check_integer(found, *found.value))
        target = static_cast<std::uint64_t>(found.value->integer);
}

void TableReader::read(std::string_view key, double& target) {
    const Found found = find(key);
    if (found.value && check_number(found, *found.value)) target = found.value->number;
}

void TableReader::read(std::string_view key, std::optional<double>& target) {
    const Found found = find(key);
    if (!found.value) return;
    if (found.value->kind == Kind::text && found.value->text == "auto")
        target.reset();
    else if (!is_number(*found.value))
        wrong_type(found, *found.value, "a number or \"auto\"");
    else if (check_number(found, *found.value))
        target = found.value->number;
}

void TableReader::read(std::string_view key, std::string& target) {
    const Found found = find(key);
    if (!found.value) return;
    const TreeValue& value = *found.value;
    if (value.kind != Kind::text) return wrong_type(found, value, "a string");
    if (value.text.empty()) return error(value.where, label_of(*found.spec) + " must not be empty");
    if (value.text.find('\0') != std::string::npos)
        return error(value.where, label_of(*found.spec) + " must not hold a zero character");
    target = value.text;
}

void TableReader::read(std::string_view key, Vec3& target) {
    const Found found = find(key);
    if (!found.value) return;
    const auto value = found.spec->type == KeyType::color ? color(found) : vector(found, *found.value);
    if (value) target = *value;
}

std::optional<Vec3> TableReader::vector(const Found& found, const TreeValue& value) {
    const KeyType type = found.spec->type;
    Vec3 v{0};
    if (type == KeyType::scale && is_number(value)) {
        if (!check_number(found, value)) return std::nullopt;
        v = Vec3(value.number);
    } else if (type == KeyType::scale && value.kind != Kind::list) {
        wrong_type(found, value, "a number or a list of 3 numbers");
        return std::nullopt;
    } else {
        if (!check_numbers(found, value, 3)) return std::nullopt;
        v = vec3_of(value);
    }
    if (type == KeyType::scale && (v.x == 0 || v.y == 0 || v.z == 0)) {
        error(value.where, label_of(*found.spec) + " must not be 0", "negative numbers mirror");
        return std::nullopt;
    }
    if (type == KeyType::direction && !has_direction(v)) {
        const bool zero = v.x == 0 && v.y == 0 && v.z == 0;
        error(value.where,
              label_of(*found.spec) + (zero ? " must not be zero" : " has a length beyond all measure"),
              "expected a direction [x, y, z]");
        return std::nullopt;
    }
    return v;
}

std::optional<Vec3> TableReader::color(const Found& found) {
    const TreeValue& value = *found.value;
    if (value.kind == Kind::list)
        return check_numbers(found, value, 3) ? std::optional(vec3_of(value)) : std::nullopt;
    if (value.kind != Kind::text) {
        wrong_type(found, value, "a colour ([r, g, b], \"#rrggbb\" or a name)");
        return std::nullopt;
    }
    if (const auto rgb = color_codes(value.text)) return linear_color(*rgb, context_.colors);
    std::string hint = context_.problems.suggestion(value.text, color_names());
    if (hint.empty() || value.text.starts_with('#'))
        hint = "expected [r, g, b], \"#rgb\", \"#rrggbb\" or a name of CSS or X11";
    error(value.where, "unknown colour " + in_quotes(value.text) + " for " + label_of(*found.spec),
          std::move(hint));
    return std::nullopt;
}

void TableReader::read(std::string_view key, std::array<Vec3, 3>& target) {
    const Found found = find(key);
    if (!found.value) return;
    const TreeValue& value = *found.value;
    if (value.kind != Kind::list) return wrong_type(found, value, "a list of 3 points");
    if (value.items.size() != 3)
        return error(value.where, "expected a list of 3 points for " + label_of(*found.spec) + ", found " +
                                      std::to_string(value.items.size()));
    for (std::size_t i = 0; i < 3; ++i)
        if (check_numbers(found, value.items[i], 3)) target[i] = vec3_of(value.items[i]);
}

void TableReader::read(std::string_view key, Mat4& target) {
    const Found found = find(key);
    if (!found.value || !check_numbers(found, *found.value, 16)) return;
    Mat4 matrix{1};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = found.value->items[static_cast<std::size_t>(4 * row + column)].number;
    if (!affine(matrix))
        error(found.value->where, label_of(*found.spec) + " is not affine: its last row must be 0, 0, 0, 1");
    else if (!regular(matrix))
        error(found.value->where, label_of(*found.spec) + " is singular: it flattens what it transforms");
    else
        target = matrix;
}

void TableReader::read_size(std::string_view key, int& width, int& height) {
    const Found found = find(key);
    if (!found.value) return;
    const TreeValue& value = *found.value;
    if (value.kind != Kind::list || value.items.size() != 2)
        return value.kind != Kind::list
                   ? wrong_type(found, value, "a list [width, height]")
                   : error(value.where, "expected [width, height] for " + label_of(*found.spec) + ", found " +
                                            std::to_string(value.items.size()) +
                                            (value.items.size() == 1 ? " number" : " numbers"));
    const bool good_width = check_integer(found, value.items[0]);
    const bool good_height = check_integer(found, value.items[1]);
    if (!good_width || !good_height) return;
    if (value.items[0].number * value.items[1].number > static_cast<double>(picture_pixel_limit))
        return error(value.where, label_of(*found.spec) + " is above 2^30 pixels");
    width = static_cast<int>(value.items[0].integer);
    height = static_cast<int>(value.items[1].integer);
}

void TableReader::read_range(std::string_view key, int& first, int& last) {
    const Found found = find(key);
    if (!found.value) return;
    const TreeValue& value = *found.value;
    if (value.kind != Kind::list || value.items.size() != 2) return wrong_type(found, value, "[first, last]");
    const bool good_first = check_integer(found, value.items[0]);
    const bool good_last = check_integer(found, value.items[1]);
    if (!good_first || !good_last) return;
    if (value.items[1].integer < value.items[0].integer)
        return error(value.where, "the last of " + label_of(*found.spec) + " comes before the first");
    first = static_cast<int>(value.items[0].integer);
    last = static_cast<int>(value.items[1].integer);
}

void TableReader::read_ascending(std::string_view key, std::vector<double>& target) {
    const Found found = find(key);
    if (!found.value) return;
    const TreeValue& value = *found.value;
    if (value.kind != Kind::list) return wrong_type(found, value, "a list of numbers");
    if (value.items.empty()) return error(value.where, label_of(*found.spec) + " must not be empty");
    for (const TreeValue& item : value.items) {
        if (!check_number(found, item)) return;
        if (!target.empty() && item.number <= target.back())
            return error(item.where,
                         label_of(*found.spec) + " must ascend, found " + show(item.number) + " after " +
                             show(target.back()),
                         "sort the keyframes by their frames");
        target.push_back(item.number);
    }
}

void TableReader::read_choice(std::string_view key, std::string& target) {
    if (const auto index = choice(key)) target = split_words(find(key).spec->choices)[*index];
}

std::optional<std::size_t> TableReader::choice(std::string_view key) {
    const Found found = find(key);
    if (!found.value) return std::nullopt;
    if (found.value->kind != Kind::text) {
        wrong_type(found, *found.value, "a string");
        return std::nullopt;
    }
    const auto choices = split_words(found.spec->choices);
    const auto it = std::find(choices.begin(), choices.end(), found.value->text);
    if (it != choices.end()) return static_cast<std::size_t>(it - choices.begin());
    std::string hint = context_.problems.suggestion(found.value->text, choices);
    hint += (hint.empty() ? "expected " : " Expected ") + std::string(choices.size() > 1 ? "one of " : "") +
            listed(choices);
    error(found.value->where, "unknown " + std::string(key) + " " + in_quotes(found.value->text),
          std::move(hint));
    return std::nullopt;
}

const TreeValue* TableReader::list(std::string_view key) {
    const Found found = find(key);
    if (!found.value) return nullptr;
    if (found.value->kind == Kind::list) return found.value;
    wrong_type(found, *found.value, "a list");
    return nullptr;
}

std::string selected_type(const TreeValue& table, const TableSpec& spec) {
    const TreeEntry* entry = spec.selector.empty() ? nullptr : table.find(spec.selector);
    if (!entry || entry->value.kind != Kind::text) return {};
    const KeySpec* key = find_key(spec, spec.selector, {});
    const auto types = split_words(key->choices);
    return std::find(types.begin(), types.end(), entry->value.text) != types.end() ? entry->value.text : "";
}

} // namespace glint
