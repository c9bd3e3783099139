#include "rows.h"

#include "glint/document.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace glint::viewer {
namespace {

/// What a pixel of dragging adds to angles, in degrees.
constexpr double angle_step = 0.5;

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

/// The help is that of the reference page, without its markup.
RowText text_of(const KeySpec& key) {
    std::string help(key.help);
    std::erase(help, '`');
    const std::string unit(key.unit);
    if (!unit.empty()) help = help.empty() ? unit : help + " (" + unit + ")";
    return {std::string(key.key), label_of(key.key), help};
}

bool is_length(const KeySpec& key) { return key.unit.starts_with("scene units"); }

double first_finite(double a, double b) { return std::isfinite(a) ? a : b; }

Vec3 vector_of(const std::vector<double>& three) { return {three[0], three[1], three[2]}; }

} // namespace

Rows::Rows(Ui& ui, std::vector<Edit>& edits, std::string path, const TableSpec& table, KeyOwner owner,
           double step, const FileKeys& file)
    : ui_(ui), edits_(edits), path_(std::move(path)), table_(table), owner_(owner), step_(step), file_(file) {
    if (const KeySpec* selector = find_key(table, table.selector, {}))
        type_ = plain_text(*selector, selector->get(owner));
}

void Rows::row(const KeySpec& key) {
    if (!key.get || !key.belongs_to(type_)) return;
    // Of two names for one value, the one that the file uses.
    if (!key.alternative.empty()) {
        const KeySpec* other = find_key(table_, key.alternative, {});
        const std::vector<double>& given = written(std::string(other->key));
        if (given.size() == 1) return number(*other, given.front());
    }
    const KeyValue value = key.get(owner_);
    const RowText text = text_of(key);
    if (const auto* flag = std::get_if<bool>(&value)) check(text, *flag);
    if (const auto* whole = std::get_if<std::int64_t>(&value)) slider(key, text, static_cast<int>(*whole));
    if (const auto* real = std::get_if<double>(&value)) number(key, *real);
    if (const auto* real = std::get_if<std::optional<double>>(&value); real && *real) number(key, **real);
    if (const auto* whole = std::get_if<std::optional<std::int64_t>>(&value))
        slider(key, text, static_cast<int>(whole->value_or(static_cast<std::int64_t>(key.range.low))));
    if (const auto* chosen = std::get_if<Choice>(&value))
        choice(text, std::string(key.choices[chosen->index]), {key.choices.begin(), key.choices.end()});
    if (const auto* three = std::get_if<Vec3>(&value)) vector(key, text, *three);
    if (const auto* corners = std::get_if<std::array<Vec3, 3>>(&value)) vertices(text, *corners);
}

void Rows::numbers(const KeySpec& key) { drag(text_of(key), std::get<Vec3>(key.get(owner_)), share_step); }

void Rows::names(std::string_view key, const std::vector<std::string>& names) {
    const KeySpec& spec = *find_key(table_, key, {});
    choice(text_of(spec), std::get<std::string>(spec.get(owner_)), names);
}

// ── Widgets ────────────────────────────────────────────────────────────────────────────────────────────────

void Rows::begin(const RowText& text) {
    ImGui::PushID((path_ + "." + text.key).c_str());
    label_row(ui_, text.label.c_str(), text.help.c_str());
    ImGui::BeginDisabled(is_animated(text.key));
}

void Rows::finish(const std::string& key, bool in_map) {
    ImGui::EndDisabled();
    if (is_animated(key)) tooltip("animated: its value is that of the frame");
    if (in_map) ui_.map.item(path_ + "." + key);
    ImGui::PopID();
}

/// Is the key, a part of it, or a table that contains it animated?
bool Rows::is_animated(const std::string& key) const {
    const std::string path = path_ + "." + key;
    const auto is_part = [](const std::string& part, const std::string& whole) {
        return part.starts_with(whole) && (part.size() == whole.size() || part[whole.size()] == '.');
    };
    return std::any_of(ui_.animated.begin(), ui_.animated.end(), [&](const std::string& animated) {
        return is_part(animated, path) || is_part(path, animated);
    });
}

bool Rows::drag(const RowText& text, double* values, int count, double step) {
    begin(text);
    const bool changed = ImGui::DragScalarN("##", ImGuiDataType_Double, values, count,
                                            static_cast<float>(step), nullptr, nullptr, "%.4g");
    finish(text.key);
    return changed;
}

void Rows::drag(const RowText& text, double value, double step) {
    if (drag(text, &value, 1, step)) set(text.key, scene_value(value));
}

void Rows::drag(const RowText& text, Vec3 value, double step) {
    if (drag(text, &value.x, 3, step)) set(text.key, scene_value(value));
}

void Rows::scale(const RowText& text, const std::vector<double>& factors) {
    if (factors.size() == 3) drag(text, vector_of(factors), share_step);
    if (factors.size() == 1) drag(text, factors[0], share_step);
}

void Rows::number(const KeySpec& key, double value) {
    if (is_length(key)) return drag(text_of(key), value, step_);
    slider(key, text_of(key), value);
}

/// A number typed after Ctrl + click may be larger than the slider's end.
void Rows::slider(const KeySpec& key, const RowText& text, double value) {
    // The brightness of lights has no usual end.
    const double headroom = table_.name == "light" ? 2 : 1;
    const double min = first_finite(key.typical.low, key.range.low);
    const double max =
        first_finite(key.range.high, end_for(value * headroom, first_finite(key.typical.high, 1)));
    const char* format = key.unit == "degrees" ? "%.3g°" : "%.3g";
    begin(text);
    if (ImGui::SliderScalar("##", ImGuiDataType_Double, &value, &min, &max, format,
                            key.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None))
        set(text.key, scene_value(std::max(value, min)));
    finish(text.key);
}

void Rows::slider(const KeySpec& key, const RowText& text, int value) {
    const int min = std::min(value, static_cast<int>(first_finite(key.typical.low, key.range.low)));
    const int max = std::max(value, static_cast<int>(first_finite(key.typical.high, key.range.high)));
    begin(text);
    if (ImGui::SliderInt("##", &value, min, max)) set(text.key, std::to_string(std::max(value, min)));
    finish(text.key);
}

void Rows::color(const RowText& text, const Vec3& value) {
    begin(text);
    ImVec4 shown = screen_color(value);
    if (ImGui::ColorEdit3("##", &shown.x, ImGuiColorEditFlags_PickerHueWheel | ImGuiColorEditFlags_Uint8)) {
        // The picker has 8 bits per channel: four decimals are enough.
        const auto rounded = [](float x) { return std::round(to_linear(x) * 10000) / 10000; };
        set(text.key, scene_value(Vec3(rounded(shown.x), rounded(shown.y), rounded(shown.z))));
    }
    finish(text.key);
}

void Rows::check(const RowText& text, bool value) {
    begin(text);
    if (ImGui::Checkbox("##", &value)) set(text.key, value ? "true" : "false");
    finish(text.key);
}

void Rows::choice(const RowText& text, const std::string& value, const std::vector<std::string>& choices) {
    begin(text);
    const int chosen = choose(ui_, path_ + "." + text.key, value, choices);
    if (chosen >= 0) set(text.key, scene_value(choices[static_cast<std::size_t>(chosen)]));
    finish(text.key, false);
}

void Rows::vector(const KeySpec& key, const RowText& text, const Vec3& value) {
    if (key.type == KeyType::color) return color(text, value);
    if (key.type != KeyType::scale) return drag(text, value, is_length(key) ? step_ : share_step);
    const std::vector<double>& factors = written(text.key);
    scale(text, factors.empty() ? std::vector{1.0} : factors);
}

void Rows::vertices(const RowText& text, std::array<Vec3, 3> corners) {
    bool moved = false;
    std::string list;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::string number = std::to_string(i);
        moved |=
            drag({text.key + "." + number, "corner " + std::to_string(i + 1), ""}, &corners[i].x, 3, step_);
        list += (i > 0 ? ", " : "") + scene_value(corners[i]);
    }
    if (moved) set(text.key, "[" + list + "]");
}

// ── Transforms ─────────────────────────────────────────────────────────────────────────────────────────────

void Rows::transform(bool add_move) {
    const auto entry = [](int number) { return "transform." + std::to_string(number) + "."; };
    const auto is_written = [&](int number) {
        constexpr std::array kinds{"translate", "rotate", "scale", "matrix"};
        return std::any_of(kinds.begin(), kinds.end(),
                           [&](const char* kind) { return !written(entry(number) + kind).empty(); });
    };
    int count = 0;
    bool moves = false;
    for (; is_written(count); ++count) moves = transform_entry(entry(count));
    if (!add_move || moves) return;
    // Once it is written, the row is that of the entry: it keeps its name.
    Vec3 way(0);
    if (!drag({entry(count) + "translate", "move", "an entry behind those of the file"}, &way.x, 3, step_))
        return;
    const auto longer = file_.longer_list(path_ + ".transform", "{ translate = " + scene_value(way) + " }");
    if (longer) set("transform", *longer);
}

/// The rows of an entry; true if it is one that moves.
bool Rows::transform_entry(const std::string& entry) {
    const std::vector<double>& move = written(entry + "translate");
    const std::vector<double>& axis = written(entry + "rotate");
    const std::vector<double>& angle = written(entry + "angle");
    if (move.size() == 3)
        drag({entry + "translate", "move", "an entry of the transform; they apply in the order of the file"},
             vector_of(move), step_);
    if (angle.size() == 1)
        drag({entry + "angle", "turn", "degrees about the axis, through the origin"}, angle[0], angle_step);
    if (axis.size() == 3)
        drag({entry + "rotate", "axis", "to turn about; of any length"}, vector_of(axis), share_step);
    scale({entry + "scale", "scale", "about the origin; negative mirrors"}, written(entry + "scale"));
    return move.size() == 3;
}

} // namespace glint::viewer
