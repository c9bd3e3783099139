#pragma once

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace glint {

inline constexpr std::size_t large_page = std::size_t{1} << 21U;

/// Asks the system for large pages behind fresh memory, where it has them: much fewer faults while large
/// arrays are filled. Only advice; short arrays are left alone.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Gives the pages within a piece of memory back to the system until they are written to again. What was in
/// it is lost.
void return_pages(void* begin, std::size_t bytes);

/// reserve(), in large pages.
template <class Value>
void reserve_large(std::vector<Value>& values, std::size_t count) {
    values.reserve(count);
    prefer_large_pages(values.data(), values.capacity() * sizeof(Value));
}

/// Memory in large pages, where a piece is long enough for one. As operator new and delete with a size and an
/// alignment, which delete must be told again.
void* new_in_large_pages(std::size_t bytes, std::size_t alignment);
void delete_in_large_pages(void* at, std::size_t bytes, std::size_t alignment);

/// Puts a vector in large pages. resize() leaves new values of simple types unset.
template <class Value>
struct LargePageAllocator {
    using value_type = Value;
    using is_always_equal = std::true_type;

    LargePageAllocator() = default;
    template <class Other>
    LargePageAllocator(const LargePageAllocator<Other>&) {} // NOLINT(google-explicit-constructor)

    Value* allocate(std::size_t count) {
        return static_cast<Value*>(new_in_large_pages(count * sizeof(Value), alignof(Value)));
    }
    void deallocate(Value* at, std::size_t count) {
        delete_in_large_pages(at, count * sizeof(Value), alignof(Value));
    }
    template <class Made>
    void construct(Made* at) {
        ::new (static_cast<void*>(at)) Made;
    }
    template <class Made, class... From>
    void construct(Made* at, From&&... from) {
        ::new (static_cast<void*>(at)) Made(std::forward<From>(from)...);
    }
    bool operator==(const LargePageAllocator&) const = default;
};

template <class Value>
using LargeVector = std::vector<Value, LargePageAllocator<Value>>;

/// Gives what lies behind a vector's last value back to the system, which may have put a large page there.
/// The capacity stays.
template <class Value>
void return_room(LargeVector<Value>& values) {
    return_pages(values.data() + values.size(), (values.capacity() - values.size()) * sizeof(Value));
}

} // namespace glint
