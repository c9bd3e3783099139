#pragma once
// The names of enumerators in files. Each enumeration has its table beside it.

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace glint {

/// As many names as an enumeration has values, of which `last` is the last.
template <auto last>
using NamesUpTo = std::array<std::string_view, static_cast<std::size_t>(last) + 1>;

/// The names of an enumeration's values, in their order.
template <class Enum>
inline constexpr bool enum_names = false;

template <class Enum>
constexpr std::string_view name_of(Enum value) {
    return enum_names<Enum>[static_cast<std::size_t>(value)];
}

/// The value of that name; none if there is none.
template <class Enum>
constexpr std::optional<Enum> value_named(std::string_view name) {
    for (std::size_t i = 0; i < enum_names<Enum>.size(); ++i)
        if (enum_names<Enum>[i] == name) return static_cast<Enum>(i);
    return std::nullopt;
}

} // namespace glint
