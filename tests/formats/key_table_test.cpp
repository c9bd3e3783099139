// The key tables: each key is bound to one member, its default is the member's initializer, what is written
// reads back as the same, and files and descriptions made in memory are refused for the same cause.

#include "formats/scene/key_table.h"
#include "formats/scene/table_reader.h"
#include "formats/scene/write.h"
#include "glint/document.h"
#include "glint/scene.h"
#include "scene/keys/check.h"
#include "scene/validate.h"
#include "scene_support.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>

namespace glint::test {

using formats::toml_text;

namespace {

template <class Variant, std::size_t... index>
std::vector<Variant> alternatives(std::index_sequence<index...>) {
    return {Variant(std::in_place_index<index>)...};
}
template <class Variant>
std::vector<Variant> alternatives() {
    return alternatives<Variant>(std::make_index_sequence<std::variant_size_v<Variant>>());
}

/// A description with every kind of table in it, with all defaults.
SceneDescription one_of_each() {
    SceneDescription scene;
    scene.camera.emplace();
    scene.materials.emplace_back().name = "m";
    for (const Shape& shape : alternatives<Shape>()) scene.objects.emplace_back().shape = shape;
    for (std::size_t i = 1; i < enum_names<PolyhedronKind>.size(); ++i)
        scene.objects.emplace_back().shape = PolyhedronShape{.kind = static_cast<PolyhedronKind>(i)};
    for (const auto& kind : alternatives<decltype(Light::kind)>()) scene.lights.push_back({kind, {}});
    for (Object& object : scene.objects)
        if (!std::holds_alternative<InstanceShape>(object.shape)) object.material = "m";
    return scene;
}

/// Calls f(table, owner) for all that keys describe.
template <class Description, class F>
void for_each_owner(Description& scene, F f) {
    f(description_table("camera"), KeyOwner(*scene.camera));
    f(description_table("render"), KeyOwner(scene.render));
    f(description_table("whitted"), KeyOwner(scene.whitted));
    for (auto& material : scene.materials) f(description_table("material"), KeyOwner(material));
    for (auto& object : scene.objects) f(description_table(name_of(object.shape)), KeyOwner(object));
    for (auto& light : scene.lights) f(description_table("light"), KeyOwner(light));
}

std::string type_of(const TableSpec& table, const KeyOwner& owner) {
    if (table.selector.empty()) return {};
    const KeySpec& key = *find_key(table, table.selector, {});
    return plain_text(key, key.get(owner));
}

/// Calls f(key, owner, type) for all keys that a description's parts have.
template <class Description, class F>
void for_each_key(Description& scene, F f) {
    for_each_owner(scene, [&](const TableSpec& table, const KeyOwner& owner) {
        const std::string type = type_of(table, owner);
        for (const KeySpec& key : table.keys)
            if (key.belongs_to(type)) f(table, key, owner, type);
    });
}

/// What reading "key = text" gives, and what is wrong with it.
struct Reading {
    std::optional<KeyValue> value;
    std::string fault;
};
Reading read(const TableSpec& table, const KeySpec& key, const std::string& type, const std::string& text) {
    const formats::SceneSource source({}, "a.toml", {});
    formats::Problems problems(source);
    const formats::ReadContext context{problems, formats::ColorValues::srgb, true};
    formats::TreeValue tree;
    tree.entries.push_back({std::string(key.key), {}, formats::parse_tree_value(text, {}).value()});
    Reading reading;
    reading.value = formats::TableReader(tree, table, table.header(), type, context).value(key);
    try {
        problems.throw_if_any();
    } catch (const Error& error) {
        reading.fault = error.diagnostics().front().message;
    }
    return reading;
}

TEST(KeyTable, TheDefaultOfAKeyIsWhatItsMemberIsInitializedWith) {
    const SceneDescription scene = one_of_each();
    std::set<const KeySpec*> seen;
    for_each_key(scene, [&](const TableSpec& table, const KeySpec& key, const KeyOwner& owner, auto& type) {
        if (!key.initial) return;
        EXPECT_EQ(key.get(owner), key.initial()) << table.name << "." << key.key;
        if (formats::default_text(key).empty()) return;
        EXPECT_EQ(read(table, key, type, formats::default_text(key)).value, key.initial())
            << table.name << "." << key.key;
        seen.insert(&key);
    });
    EXPECT_GE(seen.size(), 50u);
}

TEST(KeyTable, AKeyIsRequiredOrHasADefaultOrStandsForAnotherKey) {
    for (const TableSpec& table : description_tables())
        for (const KeySpec& key : table.keys) {
            EXPECT_TRUE(key.required || key.initial || !key.alternative.empty()) << table.name << key.key;
            EXPECT_FALSE(key.required && key.initial) << table.name << key.key;
            EXPECT_TRUE(key.set) << table.name << key.key;
            EXPECT_TRUE(key.get || !key.alternative.empty()) << table.name << key.key;
            EXPECT_EQ(key.choices.empty(), key.type != KeyType::choice) << table.name << key.key;
        }
}

TEST(KeyTable, AnOwnerOfAnotherTypeHasNoValue) {
    const Material material;
    const Light light{PointLight{}, {}};
    const TableSpec& lights = description_table("light");
    EXPECT_EQ(find_key(lights, "angle", {})->get(KeyOwner(light)), KeyValue());
    EXPECT_EQ(find_key(lights, "position", {})->get(KeyOwner(material)), KeyValue());
    EXPECT_EQ(find_key(lights, "intensity", {})->get(KeyOwner(light)), KeyValue(1.0));
    EXPECT_EQ(find_key(lights, "position", {})->types, (std::vector<std::string_view>{"point", "spot"}));
    EXPECT_EQ(KeyOwner(material).as<Material>(), nullptr) << "it is const";
    EXPECT_EQ(KeyOwner(material).as<const Material>(), &material);
}

/// Random values that keys may have.
class RandomValues {
  public:
    explicit RandomValues(unsigned seed) : random_(seed) {}

    KeyValue value(const KeySpec& key) {
        switch (key.type) {
        case KeyType::boolean:
            return below(2) == 0;
        case KeyType::whole_number:
            return static_cast<std::int64_t>(number(key));
        case KeyType::number:
            return number(key);
        case KeyType::number_or_auto:
            return below(2) == 0 ? std::optional<double>() : std::optional(number(key));
        case KeyType::whole_number_or_auto:
            return below(2) == 0 ? std::optional<std::int64_t>()
                                 : std::optional(static_cast<std::int64_t>(number(key)));
        case KeyType::choice:
            return Choice{below(key.choices.size())};
        case KeyType::size:
            return std::array{1 + static_cast<int>(below(9999)), 1 + static_cast<int>(below(9999))};
        case KeyType::vertices:
            return std::array{vector(key), vector(key), vector(key)};
        case KeyType::transform:
            return below(2) == 0 ? Mat4(1)
                                 : Mat4(glm::dvec4(vector(key), 0), glm::dvec4(vector(key), 0),
                                        glm::dvec4(vector(key), 0), glm::dvec4(vector(key), 1));
        default:
            return key.type == KeyType::scale && below(2) == 0 ? Vec3(number(key)) : vector(key);
        }
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(random_() % count); }

  private:
    double number(const KeySpec& key) {
        const double low = std::max(key.range.low, -100.0), high = std::min(key.range.high, 100.0);
        const double x = std::uniform_real_distribution<double>(low, high)(random_);
        return key.range.contains(x) ? x : (low + high) / 2;
    }
    Vec3 vector(const KeySpec& key) { return {number(key), number(key), number(key)}; }

    std::mt19937 random_;
};

/// Sets every value at random, but names, the alternatives of variants, and what must agree with other
/// values.
void randomize(SceneDescription& scene, RandomValues& values) {
    for_each_key(scene, [&](const TableSpec& table, const KeySpec& key, const KeyOwner& owner, auto&) {
        const bool name = key.type == KeyType::text || key.type == KeyType::file;
        if (!name && key.get && key.key != table.selector) key.set(owner, values.value(key));
    });
    scene.whitted.energy = Energy::report;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        scene.objects[i].name = "object " + std::to_string(i);
        if (auto* mesh = std::get_if<MeshShape>(&scene.objects[i].shape)) {
            mesh->file = "a.ply";
            scene.objects[i].name = "a mesh";
        }
        if (auto* instance = std::get_if<InstanceShape>(&scene.objects[i].shape)) instance->mesh = "a mesh";
    }
}

TEST(KeyTable, RandomDescriptionsReadBackAsTheyWereWritten) {
    RandomValues values(7);
    for (int round = 0; round < 50; ++round) {
        SceneDescription written = one_of_each();
        randomize(written, values);
        const SceneDescription read_back = parse(scene_text(written)).description;
        std::vector<KeyValue> a, b;
        std::vector<std::string> names;
        for_each_key(written, [&](const TableSpec& table, const KeySpec& key, const KeyOwner& owner, auto&) {
            if (!key.get) return;
            a.push_back(key.get(owner));
            names.push_back(table.header() + " " + std::string(key.key));
        });
        for_each_key(read_back, [&](const TableSpec&, const KeySpec& key, const KeyOwner& owner, auto&) {
            if (key.get) b.push_back(key.get(owner));
        });
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a[i], b[i]) << names[i];
    }
}

/// The value with one of its numbers replaced; empty where it cannot hold that number.
struct WithNumber {
    double x;

    KeyValue operator()(double) const { return x; }
    KeyValue operator()(const std::optional<double>&) const { return std::optional(x); }
    KeyValue operator()(std::int64_t) const {
        constexpr double limit = std::numeric_limits<int>::max();
        return std::abs(x) < limit ? KeyValue(static_cast<std::int64_t>(x)) : KeyValue();
    }
    KeyValue operator()(const std::optional<std::int64_t>&) const {
        const KeyValue whole = (*this)(std::int64_t{});
        return whole == KeyValue() ? whole : KeyValue(std::optional(std::get<std::int64_t>(whole)));
    }
    KeyValue operator()(std::array<int, 2> pair) const {
        if (!(std::abs(x) < 1e9)) return {};
        pair[1] = static_cast<int>(x);
        return pair;
    }
    KeyValue operator()(Vec3 v) const {
        v.y = x;
        return v;
    }
    KeyValue operator()(std::array<Vec3, 3> points) const {
        points[1].z = x;
        return points;
    }
    template <class Other>
    KeyValue operator()(const Other&) const {
        return {};
    }
};

std::vector<double> numbers_outside(const KeySpec& key) {
    const NumberRange& range = key.range;
    std::vector<double> numbers{std::numeric_limits<double>::quiet_NaN(),
                                std::numeric_limits<double>::infinity()};
    if (std::isfinite(range.low))
        numbers.push_back(range.low_open ? range.low : range.low - std::abs(range.low) - 1);
    if (std::isfinite(range.high)) numbers.push_back(range.high_open ? range.high : range.high * 2 + 1);
    if (std::isfinite(key.limits.high)) numbers.push_back(key.limits.high * 2);
    return numbers;
}

/// All that is wrong with the scene once the key has this value.
std::string faults_with(const KeySpec& wrong, const KeyValue& value, const std::string& type) {
    SceneDescription scene = one_of_each();
    for_each_key(scene, [&](const TableSpec&, const KeySpec& key, const KeyOwner& owner, auto& its_type) {
        if (&key == &wrong && its_type == type) key.set(owner, value);
    });
    std::string faults;
    for (const Diagnostic& fault : scene::find_errors(scene)) faults += fault.message + "\n";
    return faults;
}

TEST(KeyTable, NumbersOutOfRangeAreRefusedAlikeFromFilesAndFromMemory) {
    const SceneDescription scene = one_of_each();
    int refused = 0;
    for_each_key(scene, [&](const TableSpec& table, const KeySpec& key, const KeyOwner& owner, auto& type) {
        // The member of `seed` has no sign.
        if (!key.get || key.key == "seed") return;
        for (const double x : numbers_outside(key)) {
            const KeyValue value = std::visit(WithNumber{x}, key.get(owner));
            if (std::holds_alternative<std::monostate>(value)) continue;
            const auto cause = scene::number_fault(key, x);
            ASSERT_TRUE(cause) << table.name << "." << key.key << " = " << x;
            EXPECT_EQ(read(table, key, type, toml_text(key, value)).fault, cause->message);
            EXPECT_NE(faults_with(key, value, type).find(cause->message), std::string::npos)
                << cause->message;
            ++refused;
        }
    });
    EXPECT_GE(refused, 150);
}

TEST(KeyTable, ValuesWrongAsAWholeAreRefusedAlikeFromFilesAndFromMemory) {
    const Mat4 flat(0.1, 0.4, 0.7, 0, 0.2, 0.5, 0.8, 0, 0.3, 0.6, 0.9, 0, 0, 0, 0, 1);
    const struct {
        const char* table;
        const char* key;
        KeyValue value;
    } cases[] = {
        {"render", "size", std::array{65536, 16385}},
        {"camera", "up", Vec3(0)},
        {"plane", "normal", Vec3(0, 1e-200, 0)},
        {"light", "direction", Vec3(0)},
        {"mesh", "scale", Vec3(1, 0, 1)},
        {"sphere", "transform", flat},
        {"sphere", "transform", Mat4(1e-160)},
    };
    for (const auto& c : cases) {
        const TableSpec& table = description_table(c.table);
        const KeySpec& key = *find_key(table, c.key, {});
        const std::string type = key.types.empty() ? "" : std::string(key.types.front());
        const auto cause = scene::fault_of(key, c.value);
        ASSERT_TRUE(cause) << c.key;
        const std::string text = faults_with(key, c.value, type);
        EXPECT_NE(text.find(cause->message), std::string::npos) << c.key << ": " << text;
        if (key.type != KeyType::transform) {
            EXPECT_EQ(read(table, key, type, toml_text(key, c.value)).fault, cause->message);
        } else
            EXPECT_NE(read(table, key, type, toml_text(key, c.value)).fault, "");
    }
}

} // namespace
} // namespace glint::test
