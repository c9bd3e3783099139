// Reading, checking and interpolating animation tracks.

#include "formats/scene/animation_tracks.h"

#include "formats/scene/key_path.h"
#include "formats/scene/table_reader.h"
#include "scene/text.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace glint::formats {
namespace {

using Kind = TreeValue::Kind;

/// Whether values of such a key can be interpolated.
bool has_values_between(KeyType type) {
    switch (type) {
    case KeyType::whole_number:
    case KeyType::number:
    case KeyType::point:
    case KeyType::direction:
    case KeyType::rgb:
    case KeyType::color:
    case KeyType::lengths:
    case KeyType::scale:
    case KeyType::vertices:
    case KeyType::transform:
        return true;
    default:
        return false;
    }
}

TreeValue list_of(const Vec3& v, const SourcePos& where) {
    TreeValue list;
    list.kind = Kind::list;
    list.where = where;
    for (int i = 0; i < 3; ++i) {
        TreeValue number;
        number.kind = Kind::number;
        number.number = v[i];
        number.where = where;
        list.items.push_back(number);
    }
    return list;
}

/// Whether two values have the same structure, so that their numbers correspond.
bool same_form(const TreeValue& a, const TreeValue& b) {
    if (a.is_number() && b.is_number()) return true;
    if (a.kind != b.kind || a.items.size() != b.items.size() || a.entries.size() != b.entries.size())
        return false;
    for (std::size_t i = 0; i < a.items.size(); ++i)
        if (!same_form(a.items[i], b.items[i])) return false;
    return std::all_of(a.entries.begin(), a.entries.end(), [&](const TreeEntry& entry) {
        const TreeEntry* other = b.find(entry.key);
        return other && entry.key != "matrix" && same_form(entry.value, other->value);
    });
}

class TrackReader {
  public:
    TrackReader(const TreeValue& root, Problems& problems)
        : root_(root), scene_(root), paths_(scene_, problems),
          problems_(problems), context_{problems, color_values_of(root), true} {}

    Tracks run() {
        Tracks all;
        if (const TreeEntry* list = root_.find("animate"))
            for (const TreeValue& item : list->value.items)
                if (item.kind == Kind::table) read(item, all);
        read_frames(all);
        return all;
    }

  private:
    /// Reads the frame range; the default ends at the last keyframe.
    void read_frames(Tracks& all) {
        for (const Track& track : all.tracks)
            if (!track.timeline.frames.empty())
                all.last = std::max(all.last, static_cast<int>(std::ceil(track.timeline.frames.back())));
        const TreeEntry* entry = root_.find("animation");
        if (!entry || entry->value.kind != Kind::table) return;
        const TableSpec& spec = *find_table("animation");
        TableReader table(entry->value, spec, spec.header(), {}, context_);
        AnimationTable read{{all.first, all.last}, all.fps};
        table.read(read);
        all.first = read.frames[0];
        all.last = read.frames[1];
        all.fps = read.fps;
    }

    void read(const TreeValue& item, Tracks& all) {
        const TableSpec& spec = *find_table("animate");
        const ReadContext context{problems_, context_.colors, false};
        TableReader table(item, spec, spec.header(), {}, context);
        Track track;
        track.where = table.position_of("key");
        AnimateTable read;
        table.read(read);
        track.path = read.key;
        track.timeline.frames = std::move(read.frames);
        track.timeline.interpolation = read.interpolation;
        track.timeline.loop = read.loop;
        if (const TreeValue* values = table.list("values")) track.values = values->items;
        if (!table.good()) return;
        if (track.values.size() != track.timeline.frames.size())
            return table.error(table.position_of("values"),
                               std::to_string(track.values.size()) +
                                   (track.values.size() == 1 ? " value" : " values") + " for " +
                                   std::to_string(track.timeline.frames.size()) + " frames",
                               "one value is needed for each of \"frames\"");
        if (check_key(track) && check_form(track, table)) all.tracks.push_back(std::move(track));
    }

    /// Checks that the key exists and accepts all values.
    bool check_key(Track& track) {
        const KeyTarget target = paths_.find(track.path, track.where);
        if (!target.table) return false;
        const bool moves = target.spec->form != TableForm::root && target.spec->name != "animate" &&
                           target.spec->name != "animation" && target.key != "name" &&
                           target.key != target.spec->selector;
        if (!moves) {
            problems_.error(track.where, scene::in_quotes(track.path) + " does not move",
                            "what moves is the camera, objects, lights, materials and settings");
            return false;
        }
        const std::string type = selected_type(*target.table, *target.spec);
        const KeySpec* spec = find_key(*target.spec, target.key, type);
        bool good = true;
        for (TreeValue& value : track.values) {
            TreeValue table;
            table.where = track.where;
            table.entries.push_back({target.key, track.where, value});
            TableReader reader(table, *target.spec, target.spec->header(), type, context_);
            if (spec) reader.value(*spec);
            good = good && reader.good() && spec;
            if (!spec) break;
            if (reader.good()) write_out(value, spec->type);
        }
        if (spec) track.type = spec->type;
        return good;
    }

    /// Expands colour names and uniform scales to three numbers.
    void write_out(TreeValue& value, KeyType type) const {
        if (type == KeyType::color && value.kind == Kind::text)
            value = list_of(linear_color(*color_codes(value.text), context_.colors), value.where);
        else if (type == KeyType::scale && value.is_number())
            value = list_of(Vec3(value.number), value.where);
        for (TreeValue& entry : value.items)
            if (TreeEntry* scale = type == KeyType::transform ? entry.find("scale") : nullptr)
                write_out(scale->value, KeyType::scale);
    }

    /// Checks that the values can be interpolated as requested.
    bool check_form(Track& track, TableReader& table) {
        if (track.timeline.interpolation == scene::Interpolation::step) return true;
        if (!has_values_between(track.type)) {
            if (table.has("interpolation")) {
                table.error(table.position_of("interpolation"),
                            scene::in_quotes(track.path) + " has no values in between",
                            "leave \"interpolation\" out, or write \"step\"");
                return false;
            }
            track.timeline.interpolation = scene::Interpolation::step;
            return true;
        }
        for (const TreeValue& value : track.values) {
            if (same_form(track.values.front(), value)) continue;
            table.error(
                value.where, "the way from one form of \"transform\" to another is not known",
                "write the same entries with the same keys, none of them a matrix; or interpolation = "
                "\"step\"");
            return false;
        }
        return true;
    }

    const TreeValue& root_;
    TreeValue scene_; ///< copy for looking up paths, which may add tables
    KeyPaths paths_;
    Problems& problems_;
    ReadContext context_;
};

/// The value, or the same part of it, at a keyframe.
using ValueAtKey = std::function<const TreeValue&(std::size_t)>;

/// Interpolates every number of a value. Looks only at keyframes near the frame.
TreeValue blend(const Track& track, double frame, const ValueAtKey& at) {
    TreeValue value = at(track.timeline.keyframe(frame));
    if (value.is_number()) {
        value.number = track.timeline.at(frame, [&](std::size_t key) { return at(key).number; });
        if (track.type == KeyType::whole_number) {
            value.number = std::floor(value.number + 0.5);
            value.integer = static_cast<std::int64_t>(value.number);
        } else
            value.kind = Kind::number;
    }
    for (std::size_t i = 0; i < value.items.size(); ++i)
        value.items[i] =
            blend(track, frame, [&](std::size_t key) -> const TreeValue& { return at(key).items[i]; });
    for (TreeEntry& entry : value.entries)
        entry.value = blend(track, frame, [&](std::size_t key) -> const TreeValue& {
            return at(key).find(entry.key)->value;
        });
    return value;
}

} // namespace

Tracks read_tracks(const TreeValue& root, Problems& problems) {
    if (!root.find("animate") && !root.find("animation")) return {};
    return TrackReader(root, problems).run();
}

TreeValue value_at(const Track& track, double frame) {
    const double within = track.timeline.within(frame);
    if (track.timeline.interpolation == scene::Interpolation::step)
        return track.values[track.timeline.keyframe(within)];
    return blend(track, within, [&](std::size_t key) -> const TreeValue& { return track.values[key]; });
}

} // namespace glint::formats
