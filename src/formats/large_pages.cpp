#include "formats/large_pages.h"

#include <sys/mman.h>

#include <cstdint>

namespace glint {

void prefer_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    constexpr std::uintptr_t large = std::uintptr_t{1} << 21U;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + large - 1) / large * large;
    const std::uintptr_t past = (begin + bytes) / large * large;
    if (first < past) ::madvise(reinterpret_cast<void*>(first), past - first, MADV_HUGEPAGE);
#endif
}

} // namespace glint
