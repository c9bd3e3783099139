#pragma once
// The two views that a session renders side by side.

#include <array>
#include <cstddef>

namespace glint::viewer {

enum class ViewSlot {
    main,     ///< the scene being edited; "B" in a comparison
    reference ///< the kept settings that it is compared with; "A"
};
inline constexpr std::array view_slots{ViewSlot::main, ViewSlot::reference};

/// One value for each view.
template <class T>
struct PerView {
    std::array<T, view_slots.size()> values{};

    T& operator[](ViewSlot slot) { return values[static_cast<std::size_t>(slot)]; }
    const T& operator[](ViewSlot slot) const { return values[static_cast<std::size_t>(slot)]; }
    auto begin() { return values.begin(); }
    auto end() { return values.end(); }
    auto begin() const { return values.begin(); }
    auto end() const { return values.end(); }
};

} // namespace glint::viewer
