// Reading and checking the values of one table.

#include "formats/scene/table_reader.h"

#include "formats/scene/value_fault.h"
#include "scene/keys/check.h"
#include "scene/text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glint::formats {

using scene::in_quotes;

namespace {

using Kind = TreeValue::Kind;
using Read = std::optional<KeyValue>;

std::string label_of(const KeySpec& key) { return in_quotes(key.key); }

/// Reads a value of one key; reports a wrong form and numbers out of range.
class ValueReader {
  public:
    ValueReader(TableReader& table, const KeySpec& key, const ReadContext& context)
        : table_(table), key_(key), context_(context) {}

    Read read(const TreeValue& value) {
        switch (key_.type) {
        case KeyType::boolean:
            if (value.kind == Kind::boolean) return value.boolean;
            return wrong_type(value, "a boolean (true or false)");
        case KeyType::whole_number:
            return integer(value);
        case KeyType::number:
            return number(value);
        case KeyType::number_or_auto:
            return number_or_auto(value);
        case KeyType::whole_number_or_auto:
            return integer_or_auto(value);
        case KeyType::choice:
            return choice(value);
        case KeyType::text:
        case KeyType::file:
        case KeyType::key_path:
            return text(value);
        case KeyType::size:
            return size(value);
        case KeyType::frame_range:
            return value.items.size() == 2 ? integer_pair(value) : wrong_type(value, "[first, last]");
        case KeyType::point:
        case KeyType::direction:
        case KeyType::rgb:
        case KeyType::lengths:
            return vector(value);
        case KeyType::color:
            return color(value);
        case KeyType::scale:
            return scale(value);
        case KeyType::vertices:
            return vertices(value);
        case KeyType::matrix:
            return matrix(value);
        case KeyType::transform:
            return value.kind == Kind::list ? read_transform(value, context_) : wrong_type(value, "a list");
        case KeyType::frames:
            return ascending(value);
        case KeyType::values:
            break;
        }
        return std::nullopt;
    }

    Read wrong_type(const TreeValue& value, std::string_view expected) {
        // Of -D, what is no TOML became a text.
        const bool given = value.kind == Kind::text && value.where.origin > 0;
        if (auto fault = given ? value_fault(value.text) : std::nullopt; fault && !fault->is_text)
            return fail(value.where, std::move(fault->message), std::move(fault->hint));
        return wrong(value, expected, value.kind_words());
    }

  private:
    Read fail(const SourcePos& pos, std::string message, std::string hint = {}) {
        table_.error(pos, std::move(message), std::move(hint));
        return std::nullopt;
    }
    Read wrong(const TreeValue& value, std::string_view expected, std::string_view found) {
        return fail(value.where, "expected " + std::string(expected) + " for " + label_of(key_) + ", found " +
                                     std::string(found));
    }

    Read number(const TreeValue& value) {
        if (!value.is_number()) return wrong_type(value, "a number");
        if (auto fault = scene::number_fault(key_, value.number))
            return fail(value.where, std::move(fault->message), std::move(fault->hint));
        return value.number;
    }

    Read integer(const TreeValue& value) {
        if (value.kind != Kind::integer) return wrong_type(value, "an integer");
        return number(value) ? Read(value.integer) : std::nullopt;
    }

    /// Is it a list of that many numbers, each of them allowed?
    bool numbers(const TreeValue& value, std::size_t count) {
        const std::string expected = "a list of " + std::to_string(count) + " numbers";
        bool good = value.kind == Kind::list && value.items.size() == count;
        if (value.kind != Kind::list)
            wrong_type(value, expected);
        else if (!good)
            wrong(value, expected, std::to_string(value.items.size()));
        else
            for (const TreeValue& item : value.items) good = number(item).has_value() && good;
        return good;
    }

    Read number_or_auto(const TreeValue& value) {
        if (value.kind == Kind::text && value.text == "auto") return std::optional<double>();
        if (!value.is_number()) return wrong_type(value, "a number or \"auto\"");
        return number(value) ? Read(std::optional(value.number)) : std::nullopt;
    }

    Read integer_or_auto(const TreeValue& value) {
        if (value.kind == Kind::text && value.text == "auto") return std::optional<std::int64_t>();
        if (value.kind != Kind::integer) return wrong_type(value, "an integer or \"auto\"");
        return number(value) ? Read(std::optional(value.integer)) : std::nullopt;
    }

    Read choice(const TreeValue& value) {
        if (value.kind != Kind::text) return wrong_type(value, "a string");
        const auto found = std::find(key_.choices.begin(), key_.choices.end(), value.text);
        if (found != key_.choices.end())
            return Choice{static_cast<std::size_t>(found - key_.choices.begin())};
        const auto names = choice_names(key_);
        std::string hint = context_.problems.suggestion(value.text, names);
        hint += (hint.empty() ? "expected " : " Expected ") + std::string(names.size() > 1 ? "one of " : "") +
                scene::listed(names);
        return fail(value.where, "unknown " + std::string(key_.key) + " " + in_quotes(value.text),
                    std::move(hint));
    }

    Read text(const TreeValue& value) {
        if (value.kind != Kind::text) return wrong_type(value, "a string");
        if (value.text.empty()) return fail(value.where, label_of(key_) + " must not be empty");
        if (value.text.find('\0') != std::string::npos)
            return fail(value.where, label_of(key_) + " must not hold a zero character");
        return value.text;
    }

    Read size(const TreeValue& value) {
        if (value.kind != Kind::list) return wrong_type(value, "a list [width, height]");
        const std::size_t count = value.items.size();
        if (count == 2) return integer_pair(value);
        return wrong(value, "[width, height]", std::to_string(count) + (count == 1 ? " number" : " numbers"));
    }

    Read integer_pair(const TreeValue& value) {
        const Read first = integer(value.items[0]);
        const Read second = integer(value.items[1]);
        if (!first || !second) return std::nullopt;
        return std::array{static_cast<int>(value.items[0].integer), static_cast<int>(value.items[1].integer)};
    }

    Read vector(const TreeValue& value) { return numbers(value, 3) ? Read(vec3_of(value)) : std::nullopt; }

    Read color(const TreeValue& value) {
        if (value.kind == Kind::list) return vector(value);
        if (value.kind != Kind::text) return wrong_type(value, "a colour ([r, g, b], \"#rrggbb\" or a name)");
        if (const auto rgb = color_codes(value.text)) return linear_color(*rgb, context_.colors);
        std::string hint = context_.problems.suggestion(value.text, color_names());
        if (hint.empty() || value.text.starts_with('#'))
            hint = "expected [r, g, b], \"#rgb\", \"#rrggbb\" or a name of CSS or X11";
        return fail(value.where, "unknown colour " + in_quotes(value.text) + " for " + label_of(key_),
                    std::move(hint));
    }

    Read scale(const TreeValue& value) {
        if (value.is_number()) return number(value) ? Read(Vec3(value.number)) : std::nullopt;
        if (value.kind == Kind::list) return vector(value);
        return wrong_type(value, "a number or a list of 3 numbers");
    }

    Read vertices(const TreeValue& value) {
        std::array<Vec3, 3> points{};
        if (value.kind != Kind::list) return wrong_type(value, "a list of 3 points");
        if (value.items.size() != points.size())
            return wrong(value, "a list of 3 points", std::to_string(value.items.size()));
        bool good = true;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool is_point = numbers(value.items[i], 3);
            if (is_point) points[i] = vec3_of(value.items[i]);
            good = good && is_point;
        }
        return good ? Read(points) : std::nullopt;
    }

    Read matrix(const TreeValue& value) {
        if (!numbers(value, 16)) return std::nullopt;
        Mat4 matrix{1};
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 4; ++column)
                matrix[column][row] = value.items[static_cast<std::size_t>(4 * row + column)].number;
        return matrix;
    }

    Read ascending(const TreeValue& value) {
        if (value.kind != Kind::list) return wrong_type(value, "a list of numbers");
        std::vector<double> all;
        if (value.items.empty()) fail(value.where, label_of(key_) + " must not be empty");
        for (const TreeValue& item : value.items) {
            if (!number(item)) return std::nullopt;
            if (!all.empty() && item.number <= all.back())
                return fail(item.where,
                            label_of(key_) + " must ascend, found " + scene::show(item.number) + " after " +
                                scene::show(all.back()),
                            "sort the keyframes by their frames");
            all.push_back(item.number);
        }
        return all;
    }

    TableReader& table_;
    const KeySpec& key_;
    const ReadContext& context_;
};

/// Was an angle in degrees probably meant in radians? Only whole degrees are taken for certain.
bool looks_like_radians(const KeySpec& key, double angle) {
    constexpr double degree = std::numbers::pi / 180;
    if (key.unit != "degrees" || angle == std::floor(angle)) return false;
    if (key.range.high <= 180) return angle <= key.range.high * degree;
    // Rotations may be small: only multiples of 15° below a whole turn, as rounded to three digits or, if
    // they are quarter turns, to two decimals.
    const double steps = std::abs(angle) / (15 * degree);
    const double nearest = std::round(steps);
    if (!(nearest > 0 && nearest < 24 && std::abs(steps - nearest) < 6e-4 * nearest)) return false;
    const bool two_decimals = std::abs(angle - std::round(angle * 100) / 100) < 1e-9;
    return !two_decimals || std::fmod(nearest, 6) == 0;
}

} // namespace

Vec3 vec3_of(const TreeValue& list) {
    return {list.items[0].number, list.items[1].number, list.items[2].number};
}

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
                  "its keys are " + scene::listed(names));
        else
            error(entry.where, "unknown key " + in_quotes(entry.key) + " in " + label_,
                  context_.problems.suggestion(entry.key, names, "its keys are " + scene::listed(names)));
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
    auto read = ValueReader(*this, key, context_).read(entry->value);
    if (!read) return std::nullopt;
    if (auto fault = scene::value_fault(key, *read)) {
        error(entry->value.where, std::move(fault->message), std::move(fault->hint));
        return std::nullopt;
    }
    if (const auto* angle = std::get_if<double>(&*read); angle && looks_like_radians(key, *angle))
        context_.problems.warning(entry->value.where,
                                  label_of(key) + " " + scene::show(*angle) + " looks like radians",
                                  "angles are in degrees; " + scene::show(*angle) + " radians are " +
                                      scene::rounded(*angle * 180 / std::numbers::pi) + "°");
    return read;
}

const TreeValue* TableReader::list(std::string_view key) {
    const TreeEntry* entry = table_.find(key);
    if (!entry) return nullptr;
    if (entry->value.kind == Kind::list) return &entry->value;
    ValueReader(*this, *find_key(spec_, key, type_), context_).wrong_type(entry->value, "a list");
    return nullptr;
}

std::string selected_type(const TreeValue& table, const TableSpec& spec) {
    if (spec.selector.empty()) return {};
    const KeySpec& selector = *find_key(spec, spec.selector, {});
    const TreeEntry* entry = table.find(spec.selector);
    if (!entry) return selector.initial ? plain_text(selector, selector.initial()) : "";
    const auto& types = selector.choices;
    const bool good =
        entry->value.kind == Kind::text && std::ranges::find(types, entry->value.text) != types.end();
    return good ? entry->value.text : "";
}

} // namespace glint::formats
