#pragma once
// Memory backed by large pages (2 MiB), which cost far fewer page faults than pages of 4 KiB.

#include <cstddef>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace glint::parallel {

inline constexpr std::size_t large_page = std::size_t{1} << 21U;

/// Advises the system to back fresh memory with large pages. No effect on arrays shorter than one page.
void prefer_large_pages(void* begin, std::size_t bytes);

/// Returns the whole pages within a memory range to the system; their contents are lost. They are mapped
/// again at the next write.
void return_pages(void* begin, std::size_t bytes);

/// reserve() with large pages.
template <class Value>
void reserve_large(std::vector<Value>& values, std::size_t count) {
    values.reserve(count);
    prefer_large_pages(values.data(), values.capacity() * sizeof(Value));
}

/// Like operator new and delete with size and alignment, with large pages for blocks of at least one page.
/// delete needs the size and alignment given to new. new throws std::bad_alloc.
void* new_in_large_pages(std::size_t bytes, std::size_t alignment);
void delete_in_large_pages(void* at, std::size_t bytes, std::size_t alignment);

/// Allocator for LargeVector. resize() default-initializes: new values of simple types are indeterminate.
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
    template <class Element>
    void construct(Element* at) {
        ::new (static_cast<void*>(at)) Element;
    }
    template <class Element, class... Arguments>
    void construct(Element* at, Arguments&&... arguments) {
        ::new (static_cast<void*>(at)) Element(std::forward<Arguments>(arguments)...);
    }
    bool operator==(const LargePageAllocator&) const = default;
};

template <class Value>
using LargeVector = std::vector<Value, LargePageAllocator<Value>>;

/// Returns the pages of a vector's unused capacity to the system. The capacity does not change.
template <class Value>
void return_unused(LargeVector<Value>& values) {
    return_pages(values.data() + values.size(), (values.capacity() - values.size()) * sizeof(Value));
}

} // namespace glint::parallel
