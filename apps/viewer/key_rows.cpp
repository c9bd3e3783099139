#include "key_rows.h"

#include "glint/document.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::viewer {
namespace {

/// A slider's end for a number that has none: a round one above what it is now.
double end_for(double value, double usual) {
    if (value <= usual) return usual;
    return std::pow(10.0, std::ceil(std::log10(value * 1.0001)));
}

/// "vertex colors"; two names are too long for the panel.
std::string label_of(std::string_view key) {
    if (key == "radiant_intensity") return "radiant int.";
    if (key == "highlight_model") return "highlights";
    std::string label(key);
    std::replace(label.begin(), label.end(), '_', ' ');
    return label;
}

/// As on the reference page, without its markup.
std::string help_of(const KeySpec& key) {
    std::string help(key.help);
    std::erase(help, '`');
    if (key.unit.empty()) return help;
    return help.empty() ? std::string(key.unit) : help + " (" + std::string(key.unit) + ")";
}

bool is_length(const KeySpec& key) { return key.unit.starts_with("scene units"); }

} // namespace

void scale_row(Rows& rows, const std::string& key, const std::vector<double>& written, const char* help) {
    if (written.size() == 3)
        rows.place(key, "scale", {written[0], written[1], written[2]}, share_step, help);
    else if (written.size() == 1)
        rows.length(key, "scale", written[0], share_step, help);
}

struct KeyRows::Visitor {
    KeyRows& rows;
    const KeySpec& key;

    void operator()(bool value) const {
        rows.rows_.check(std::string(key.key).c_str(), label_of(key.key).c_str(), value,
                         help_of(key).c_str());
    }
    void operator()(std::int64_t value) const { rows.integer(key, static_cast<int>(value)); }
    void operator()(double value) const { rows.number(key, value); }
    void operator()(const std::optional<double>& value) const {
        if (value) rows.number(key, *value);
    }
    void operator()(Choice choice) const {
        rows.rows_.choice(std::string(key.key).c_str(), label_of(key.key).c_str(),
                          std::string(key.choices[choice.index]), {key.choices.begin(), key.choices.end()},
                          help_of(key).c_str());
    }
    void operator()(const Vec3& value) const { rows.vector(key, value); }
    void operator()(const std::array<Vec3, 3>& value) const { rows.vertices(key, value); }
    template <class Other>
    void operator()(const Other&) const {}
};

std::string KeyRows::type_of(const TableSpec& table, const KeyOwner& owner) {
    const KeySpec* selector = find_key(table, table.selector, {});
    return selector ? plain_text(*selector, selector->get(owner)) : std::string();
}

void KeyRows::row(const KeySpec& key) {
    if (!key.get || !key.belongs_to(type_)) return;
    // Of two names for one value, the one that the file uses.
    if (!key.alternative.empty()) {
        const KeySpec* other = find_key(table_, key.alternative, {});
        const std::vector<double>& written = file_.numbers(path_ + "." + std::string(other->key));
        if (written.size() == 1) return number(*other, written.front());
    }
    std::visit(Visitor{*this, key}, key.get(owner_));
}

void KeyRows::row(std::string_view key) { row(*find_key(table_, key, {})); }

void KeyRows::numbers(const KeySpec& key) {
    rows_.place(std::string(key.key), label_of(key.key).c_str(), std::get<Vec3>(key.get(owner_)), share_step,
                help_of(key).c_str());
}

void KeyRows::names(std::string_view key, const std::vector<std::string>& words) {
    const KeySpec& spec = *find_key(table_, key, {});
    rows_.choice(std::string(key).c_str(), label_of(key).c_str(), std::get<std::string>(spec.get(owner_)),
                 words, help_of(spec).c_str());
}

void KeyRows::number(const KeySpec& key, double value) {
    const std::string name(key.key), label = label_of(key.key), help = help_of(key);
    if (is_length(key)) return rows_.length(name, label.c_str(), value, step_, help.c_str());
    // The brightness of lights has no usual end.
    const double headroom = table_.name == "light" ? 2 : 1;
    Range slider;
    slider.min = std::isfinite(key.typical.low) ? key.typical.low : key.range.low;
    slider.max = std::isfinite(key.range.high)
                     ? key.range.high
                     : end_for(value * headroom, std::isfinite(key.typical.high) ? key.typical.high : 1);
    slider.format = key.unit == "degrees" ? "%.3g°" : "%.3g";
    slider.logarithmic = key.logarithmic;
    rows_.number(name.c_str(), label.c_str(), value, slider, help.c_str());
}

void KeyRows::integer(const KeySpec& key, int value) {
    const auto bound = [](double typical, double range) {
        return static_cast<int>(std::isfinite(typical) ? typical : range);
    };
    rows_.whole(std::string(key.key).c_str(), label_of(key.key).c_str(), value,
                std::min(value, bound(key.typical.low, key.range.low)),
                std::max(value, bound(key.typical.high, key.range.high)), help_of(key).c_str());
}

void KeyRows::vector(const KeySpec& key, const Vec3& value) {
    const std::string name(key.key), label = label_of(key.key), help = help_of(key);
    if (key.type == KeyType::color) return rows_.color(name.c_str(), label.c_str(), value, help.c_str());
    if (key.type != KeyType::scale)
        return rows_.place(name, label.c_str(), value, is_length(key) ? step_ : share_step, help.c_str());
    const std::vector<double>& written = file_.numbers(path_ + "." + name);
    scale_row(rows_, name, written.empty() ? std::vector{1.0} : written, help.c_str());
}

void KeyRows::vertices(const KeySpec& key, const std::array<Vec3, 3>& value) {
    constexpr std::array labels{"corner 1", "corner 2", "corner 3"};
    const std::string name(key.key);
    std::array<Vec3, 3> corners = value;
    bool moved = false;
    for (std::size_t i = 0; i < corners.size(); ++i)
        moved |= rows_.drag(name + "." + std::to_string(i), labels[i], corners[i], step_, "");
    if (moved)
        rows_.set(name, "[" + scene_value(corners[0]) + ", " + scene_value(corners[1]) + ", " +
                            scene_value(corners[2]) + "]");
}

} // namespace glint::viewer
