#pragma once
// Builds the rows of key tables: a key is bound to the member that it sets, and its default is what the
// member's initializer says.
//
//     number<&Material::index>("index").range(above_0).help("η of refraction, used where τ > 0")
//
// Keys of lights name one member for each kind that has the key. A few keys are not a member as it stands;
// their accessors are written out: `size` (two members), `look_at` and `radiant_intensity` (read in another
// form than they are kept in), and a light's `type` (the alternative of a variant). The file's own forms of a
// value, such as colours by name and lists of transforms, are read by
// formats/scene/table_reader.h.

#include "glint/keys.h"
#include "glint/limits.h"
#include "glint/scene.h"

#include <limits>
#include <optional>
#include <utility>

namespace glint::scene::keys {

inline constexpr double float_limit = std::numeric_limits<float>::max();

inline constexpr NumberRange at_least_0{.low = 0};
inline constexpr NumberRange above_0{.low = 0, .low_open = true};
inline constexpr NumberRange share{.low = 0, .high = 1};
inline constexpr NumberRange coordinate{.low = -coordinate_limit, .high = coordinate_limit};
inline constexpr NumberRange length{.low = 0, .high = coordinate_limit, .low_open = true};
/// What is at least 0 and computed with in single precision.
inline constexpr NumberRange single_precision{.low = 0, .high = float_limit};
/// Indices of refraction are divided by.
inline constexpr NumberRange divisor{.low = std::numeric_limits<float>::min(), .high = coordinate_limit};

constexpr NumberRange between(double low, double high) { return {.low = low, .high = high}; }

// ── Members ────────────────────────────────────────────────────────────────────────────────────────────────

template <class T, class Variant>
inline constexpr bool is_alternative = false;
template <class T, class... All>
inline constexpr bool is_alternative<T, std::variant<All...>> = (std::is_same_v<T, All> || ...);

template <class T>
inline constexpr bool is_shape = is_alternative<T, Shape>;
template <class T>
inline constexpr bool is_light = is_alternative<T, decltype(Light::kind)>;

template <class Member>
struct MemberOf;
template <class Class_, class Value_>
struct MemberOf<Value_ Class_::*> {
    using Class = Class_;
    using Value = Value_;
};
template <auto member>
using ClassOf = typename MemberOf<decltype(member)>::Class;
template <auto member>
using ValueOf = typename MemberOf<decltype(member)>::Value;

template <class T, class Like>
using ConstLike = std::conditional_t<std::is_const_v<Like>, const T, T>;

/// The struct of type T that the owner is or holds; null if it holds another.
template <class T>
T* part_of(const KeyOwner& owner) {
    using Part = std::remove_const_t<T>;
    if constexpr (is_shape<Part>) {
        auto* object = owner.as<ConstLike<Object, T>>();
        return object ? std::get_if<Part>(&object->shape) : nullptr;
    } else if constexpr (is_light<Part>) {
        auto* light = owner.as<ConstLike<Light, T>>();
        return light ? std::get_if<Part>(&light->kind) : nullptr;
    } else
        return owner.as<T>();
}

template <class T>
KeyValue key_value(const T& member) {
    if constexpr (std::is_enum_v<T>)
        return Choice{static_cast<std::size_t>(member)};
    else if constexpr (std::is_same_v<T, int>)
        return std::int64_t{member};
    else if constexpr (std::is_same_v<T, std::optional<int>>)
        return std::optional<std::int64_t>(member);
    else if constexpr (std::is_same_v<T, std::uint64_t>) {
        if (member > std::numeric_limits<std::int64_t>::max()) return member;
        return static_cast<std::int64_t>(member);
    } else
        return member;
}

template <class T>
void assign(T& member, const KeyValue& value) {
    if constexpr (std::is_enum_v<T>)
        member = static_cast<T>(std::get<Choice>(value).index);
    else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>)
        member = static_cast<T>(std::get<std::int64_t>(value));
    else if constexpr (std::is_same_v<T, std::optional<int>>) {
        const auto& whole = std::get<std::optional<std::int64_t>>(value);
        member = whole ? std::optional(static_cast<int>(*whole)) : std::nullopt;
    } else
        member = std::get<T>(value);
}

template <auto... members>
KeyValue get(const KeyOwner& owner) {
    KeyValue value;
    const auto take = [&](const auto* part, auto member) {
        if (part) value = key_value(part->*member);
    };
    (take(part_of<const ClassOf<members>>(owner), members), ...);
    return value;
}

template <auto... members>
void set(const KeyOwner& owner, const KeyValue& value) {
    const auto put = [&](auto* part, auto member) {
        if (part) assign(part->*member, value);
    };
    (put(part_of<ClassOf<members>>(owner), members), ...);
}

template <auto member, auto...>
KeyValue initial() {
    return key_value(ClassOf<member>{}.*member);
}

/// The types of [[light]] that have one of the members; empty where all have.
template <class... Classes>
std::vector<std::string_view> light_types() {
    std::vector<std::string_view> types;
    if constexpr ((is_light<Classes> && ...)) {
        const std::array held{decltype(Light::kind)(Classes{}).index()...};
        for (std::size_t i = 0; i < light_names.size(); ++i)
            for (const std::size_t index : held)
                if (index == i) types.push_back(light_names[i]);
        if (types.size() == light_names.size()) types.clear();
    }
    return types;
}

// ── Rows ───────────────────────────────────────────────────────────────────────────────────────────────────

/// A KeySpec while it is put together.
class KeyRow {
  public:
    explicit KeyRow(KeySpec spec) : spec_(std::move(spec)) {}
    operator KeySpec() && { return std::move(spec_); }

    KeyRow&& unit(std::string_view text) && { return with(spec_.unit, text); }
    KeyRow&& help(std::string_view text) && { return with(spec_.help, text); }
    KeyRow&& range(const NumberRange& range) && { return with(spec_.range, range); }
    KeyRow&& limits(const NumberRange& limits) && { return with(spec_.limits, limits); }
    /// For sliders.
    KeyRow&& typical(double low, double high) && { return with(spec_.typical, between(low, high)); }
    KeyRow&& logarithmic() && { return with(spec_.logarithmic, true); }
    KeyRow&& not_in_metadata() && { return with(spec_.in_metadata, false); }
    KeyRow&& no_default() && { return with(spec_.initial, nullptr); }
    /// Another default than the member's initializer.
    KeyRow&& initially(KeyValue (*value)()) && { return with(spec_.initial, value); }
    KeyRow&& required() && {
        spec_.required = true;
        return std::move(*this).no_default();
    }
    /// Another key may stand for this one, which is the one that is written.
    KeyRow&& or_else(std::string_view key) && { return with(spec_.alternative, key); }
    /// Stands for another key.
    KeyRow&& instead_of(std::string_view key) && { return std::move(*this).or_else(key).no_default(); }
    /// The table's types that have the key, as values of its selector.
    template <class Enum>
    KeyRow&& only(std::initializer_list<Enum> types) && {
        for (const Enum type : types) spec_.types.push_back(name_of(type));
        return std::move(*this);
    }

  private:
    template <class T>
    KeyRow&& with(T& member, const std::type_identity_t<T>& value) {
        member = value;
        return std::move(*this);
    }

    KeySpec spec_;
};

template <class Value, auto... members>
KeyRow bound(std::string_view key, KeyType type) {
    static_assert((std::is_same_v<ValueOf<members>, Value> && ...), "a member of another type");
    KeySpec spec{.key = key, .type = type};
    spec.types = light_types<ClassOf<members>...>();
    spec.get = get<members...>;
    spec.set = set<members...>;
    spec.initial = initial<members...>;
    return KeyRow(std::move(spec));
}

template <auto member>
KeyRow boolean(std::string_view key) {
    return bound<bool, member>(key, KeyType::boolean);
}
/// Of int or std::uint64_t.
template <auto member>
KeyRow integer(std::string_view key) {
    static_assert(std::is_integral_v<ValueOf<member>>);
    return bound<ValueOf<member>, member>(key, KeyType::whole_number);
}
template <auto member>
KeyRow integer_or_auto(std::string_view key) {
    return bound<std::optional<int>, member>(key, KeyType::whole_number_or_auto);
}
template <auto... members>
KeyRow number(std::string_view key) {
    return bound<double, members...>(key, KeyType::number);
}
/// A number of the light model: computed with in single precision.
template <auto... members>
KeyRow factor(std::string_view key) {
    return number<members...>(key).range(at_least_0).limits(single_precision);
}
template <auto member>
KeyRow choice(std::string_view key) {
    using Enum = ValueOf<member>;
    KeySpec spec = bound<Enum, member>(key, KeyType::choice);
    spec.choices = enum_names<Enum>;
    return KeyRow(std::move(spec));
}
template <auto member>
KeyRow text(std::string_view key, KeyType type = KeyType::text) {
    return bound<std::string, member>(key, type);
}
template <auto... members>
KeyRow point(std::string_view key) {
    return bound<Vec3, members...>(key, KeyType::point).unit("scene units").range(coordinate);
}
template <auto... members>
KeyRow direction(std::string_view key) {
    return bound<Vec3, members...>(key, KeyType::direction);
}
template <auto... members>
KeyRow color(std::string_view key, KeyType type = KeyType::color) {
    return bound<Vec3, members...>(key, type).range(at_least_0).limits(single_precision);
}
template <auto member>
KeyRow scale(std::string_view key) {
    return bound<Vec3, member>(key, KeyType::scale);
}

} // namespace glint::scene::keys
