// Reading and checking the values of one table.

#include "formats/scene/table.h"

#include "scene/keys/check.h"
#include "scene/text.h"

#include <algorithm>

namespace glint {
namespace {

using Kind = TreeValue::Kind;

bool is_number(const TreeValue& value) { return value.kind == Kind::integer || value.kind == Kind::number; }

Vec3 vec3_of(const TreeValue& list) {
    return {list.items[0].number, list.items[1].number, list.items[2].number};
}

std::string label_of(const KeySpec& key) { return in_quotes(key.key); }

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
        // Of two mutually exclusive keys report only the later one.
        if (either && has(spec.key) && position_of(spec.alternative) < position_of(spec.key))
            error(position_of(spec.key),
                  label_of(spec) + " cannot go together with " + in_quotes(spec.alternative) + " in " +
                      label_,
                  "keep one of them");
        if (!spec.required || context_.patch || either || has(spec.key)) continue;
        std::string what = "missing required key " + label_of(spec);
        if (!spec.alternative.empty()) what += " (or " + in_quotes(spec.alternative) + ")";
        error(header(), what + " in " + label_, std::string(spec.help));
    }
}

void TableReader::error(const SourcePos& pos, std::string message, std::string hint) {
    good_ = false;
    context_.problems.error(pos, std::move(message), std::move(hint));
}

SourcePos TableReader::position_of(std::string_view key) const {
    const TreeEntry* entry = table_.find(key);
    return entry ? entry->value.where : table_.where;
}

void TableReader::read_members(const KeyOwner& owner) {
    for (const KeySpec& key : spec_.keys) {
        // Keys that the type does not have were reported; ignore their values.
        if (!key.set || find_key(spec_, key.key, type_) != &key) continue;
        if (const auto read = value(key)) key.set(owner, *read);
    }
}

std::optional<KeyValue> TableReader::value(const KeySpec& key) {
    const TreeEntry* entry = table_.find(key.key);
    if (!entry) return std::nullopt;
    auto read = parse(key, entry->value);
    if (!read) return std::nullopt;
    if (auto fault = value_fault(key, *read)) {
        error(entry->value.where, std::move(fault->message), std::move(fault->hint));
        return std::nullopt;
    }
    return read;
}

std::optional<KeyValue> TableReader::parse(const KeySpec& key, const TreeValue& value) {
    switch (key.type) {
    case KeyType::boolean:
        return boolean(key, value);
    case KeyType::whole_number:
        return check_integer(key, value) ? std::optional<KeyValue>(value.integer) : std::nullopt;
    case KeyType::number:
        return check_number(key, value) ? std::optional<KeyValue>(value.number) : std::nullopt;
    case KeyType::number_or_auto:
        return number_or_auto(key, value);
    case KeyType::choice:
        return choice(key, value);
    case KeyType::text:
    case KeyType::file:
    case KeyType::key_path:
        return text(key, value);
    case KeyType::size:
        return size(key, value);
    case KeyType::frame_range:
        return frame_range(key, value);
    case KeyType::point:
    case KeyType::direction:
    case KeyType::rgb:
    case KeyType::lengths:
        return vector(key, value);
    case KeyType::color:
        return color(key, value);
    case KeyType::scale:
        return scale(key, value);
    case KeyType::vertices:
        return vertices(key, value);
    case KeyType::matrix:
        return matrix(key, value);
    case KeyType::transform:
        return transform(key, value);
    case KeyType::frames:
        return ascending(key, value);
    case KeyType::values:
        break;
    }
    return std::nullopt;
}

void TableReader::wrong_type(const KeySpec& key, const TreeValue& value, std::string_view expected) {
    error(value.where, "expected " + std::string(expected) + " for " + label_of(key) + ", found " +
                           std::string(value.kind_words()));
}

bool TableReader::check_number(const KeySpec& key, const TreeValue& value) {
    if (!is_number(value)) {
        wrong_type(key, value, "a number");
        return false;
    }
    auto fault = number_fault(key, value.number);
    if (fault) error(value.where, std::move(fault->message), std::move(fault->hint));
    return !fault;
}

bool TableReader::check_integer(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::integer) return check_number(key, value);
    wrong_type(key, value, "an integer");
    return false;
}

bool TableReader::check_numbers(const KeySpec& key, const TreeValue& value, std::size_t count) {
    const std::string expected = "a list of " + std::to_string(count) + " numbers";
    if (value.kind != Kind::list) {
        wrong_type(key, value, expected);
        return false;
    }
    if (value.items.size() != count) {
        error(value.where, "expected " + expected + " for " + label_of(key) + ", found " +
                               std::to_string(value.items.size()));
        return false;
    }
    bool good = true;
    for (const TreeValue& item : value.items) good = check_number(key, item) && good;
    return good;
}

std::optional<KeyValue> TableReader::boolean(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::boolean) return value.boolean;
    wrong_type(key, value, "a boolean (true or false)");
    return std::nullopt;
}

std::optional<KeyValue> TableReader::number_or_auto(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::text && value.text == "auto") return std::optional<double>();
    if (is_number(value))
        return check_number(key, value) ? std::optional<KeyValue>(std::optional(value.number)) : std::nullopt;
    wrong_type(key, value, "a number or \"auto\"");
    return std::nullopt;
}

std::optional<KeyValue> TableReader::choice(const KeySpec& key, const TreeValue& value) {
    if (value.kind != Kind::text) {
        wrong_type(key, value, "a string");
        return std::nullopt;
    }
    const auto found = std::find(key.choices.begin(), key.choices.end(), value.text);
    if (found != key.choices.end()) return Choice{static_cast<std::size_t>(found - key.choices.begin())};
    const auto names = choice_names(key);
    std::string hint = context_.problems.suggestion(value.text, names);
    hint += (hint.empty() ? "expected " : " Expected ") + std::string(names.size() > 1 ? "one of " : "") +
            listed(names);
    error(value.where, "unknown " + std::string(key.key) + " " + in_quotes(value.text), std::move(hint));
    return std::nullopt;
}

std::optional<KeyValue> TableReader::text(const KeySpec& key, const TreeValue& value) {
    if (value.kind != Kind::text)
        wrong_type(key, value, "a string");
    else if (value.text.empty())
        error(value.where, label_of(key) + " must not be empty");
    else if (value.text.find('\0') != std::string::npos)
        error(value.where, label_of(key) + " must not hold a zero character");
    else
        return value.text;
    return std::nullopt;
}

std::optional<KeyValue> TableReader::size(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::list && value.items.size() == 2) return integer_pair(key, value);
    if (value.kind != Kind::list)
        wrong_type(key, value, "a list [width, height]");
    else
        error(value.where, "expected [width, height] for " + label_of(key) + ", found " +
                               std::to_string(value.items.size()) +
                               (value.items.size() == 1 ? " number" : " numbers"));
    return std::nullopt;
}

std::optional<KeyValue> TableReader::frame_range(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::list && value.items.size() == 2) return integer_pair(key, value);
    wrong_type(key, value, "[first, last]");
    return std::nullopt;
}

std::optional<KeyValue> TableReader::integer_pair(const KeySpec& key, const TreeValue& value) {
    const bool good_first = check_integer(key, value.items[0]);
    const bool good_second = check_integer(key, value.items[1]);
    if (!good_first || !good_second) return std::nullopt;
    return std::array{static_cast<int>(value.items[0].integer), static_cast<int>(value.items[1].integer)};
}

std::optional<KeyValue> TableReader::vector(const KeySpec& key, const TreeValue& value) {
    return check_numbers(key, value, 3) ? std::optional<KeyValue>(vec3_of(value)) : std::nullopt;
}

std::optional<KeyValue> TableReader::color(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::list) return vector(key, value);
    if (value.kind != Kind::text) {
        wrong_type(key, value, "a colour ([r, g, b], \"#rrggbb\" or a name)");
        return std::nullopt;
    }
    if (const auto rgb = color_codes(value.text)) return linear_color(*rgb, context_.colors);
    std::string hint = context_.problems.suggestion(value.text, color_names());
    if (hint.empty() || value.text.starts_with('#'))
        hint = "expected [r, g, b], \"#rgb\", \"#rrggbb\" or a name of CSS or X11";
    error(value.where, "unknown colour " + in_quotes(value.text) + " for " + label_of(key), std::move(hint));
    return std::nullopt;
}

std::optional<KeyValue> TableReader::scale(const KeySpec& key, const TreeValue& value) {
    if (is_number(value))
        return check_number(key, value) ? std::optional<KeyValue>(Vec3(value.number)) : std::nullopt;
    if (value.kind == Kind::list) return vector(key, value);
    wrong_type(key, value, "a number or a list of 3 numbers");
    return std::nullopt;
}

std::optional<KeyValue> TableReader::vertices(const KeySpec& key, const TreeValue& value) {
    std::array<Vec3, 3> points{};
    if (value.kind != Kind::list) {
        wrong_type(key, value, "a list of 3 points");
        return std::nullopt;
    }
    if (value.items.size() != points.size()) {
        error(value.where, "expected a list of 3 points for " + label_of(key) + ", found " +
                               std::to_string(value.items.size()));
        return std::nullopt;
    }
    bool good = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool is_point = check_numbers(key, value.items[i], 3);
        if (is_point) points[i] = vec3_of(value.items[i]);
        good = good && is_point;
    }
    return good ? std::optional<KeyValue>(points) : std::nullopt;
}

std::optional<KeyValue> TableReader::matrix(const KeySpec& key, const TreeValue& value) {
    if (!check_numbers(key, value, 16)) return std::nullopt;
    Mat4 matrix{1};
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = value.items[static_cast<std::size_t>(4 * row + column)].number;
    return matrix;
}

std::optional<KeyValue> TableReader::transform(const KeySpec& key, const TreeValue& value) {
    if (value.kind == Kind::list) return read_transform(value, context_);
    wrong_type(key, value, "a list");
    return std::nullopt;
}

std::optional<KeyValue> TableReader::ascending(const KeySpec& key, const TreeValue& value) {
    if (value.kind != Kind::list) {
        wrong_type(key, value, "a list of numbers");
        return std::nullopt;
    }
    std::vector<double> numbers;
    if (value.items.empty()) error(value.where, label_of(key) + " must not be empty");
    for (const TreeValue& item : value.items) {
        if (!check_number(key, item)) return std::nullopt;
        if (!numbers.empty() && item.number <= numbers.back()) {
            error(item.where,
                  label_of(key) + " must ascend, found " + show(item.number) + " after " +
                      show(numbers.back()),
                  "sort the keyframes by their frames");
            return std::nullopt;
        }
        numbers.push_back(item.number);
    }
    return numbers;
}

const TreeValue* TableReader::list(std::string_view key) {
    const TreeEntry* entry = table_.find(key);
    if (!entry) return nullptr;
    if (entry->value.kind == Kind::list) return &entry->value;
    wrong_type(*find_key(spec_, key, type_), entry->value, "a list");
    return nullptr;
}

std::string selected_type(const TreeValue& table, const TableSpec& spec) {
    const TreeEntry* entry = spec.selector.empty() ? nullptr : table.find(spec.selector);
    if (!entry || entry->value.kind != Kind::text) return {};
    const auto& types = find_key(spec, spec.selector, {})->choices;
    return std::find(types.begin(), types.end(), entry->value.text) != types.end() ? entry->value.text : "";
}

} // namespace glint
