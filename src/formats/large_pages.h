#pragma once

#include <cstddef>

namespace glint {

/// Tells the system that this memory will soon be written whole, so that it may come in large pages: a fault
/// for each small one takes as long as reading what goes there. Nothing is promised, and nothing can fail.
void prefer_large_pages(void* memory, std::size_t bytes);

} // namespace glint
