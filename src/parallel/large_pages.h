#pragma once

#include <cstddef>
#include <vector>

namespace glint {

/// Asks the system for large pages behind fresh memory, where it has them: much fewer faults while large
/// arrays are filled. Only advice; short arrays are left alone.
void prefer_large_pages(void* begin, std::size_t bytes);

/// reserve(), in large pages.
template <class Value>
void reserve_large(std::vector<Value>& values, std::size_t count) {
    values.reserve(count);
    prefer_large_pages(values.data(), values.capacity() * sizeof(Value));
}

} // namespace glint
