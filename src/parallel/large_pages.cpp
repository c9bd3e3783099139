#include "parallel/large_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace glint {
namespace {

constexpr std::size_t large_page = std::size_t{1} << 21U;

/// Memory of at least a large page begins with one.
std::align_val_t aligned(std::size_t bytes, std::size_t alignment) {
    return std::align_val_t(bytes >= large_page ? large_page : alignment);
}

} // namespace

void prefer_large_pages(void* begin, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    const auto first = reinterpret_cast<std::uintptr_t>(begin);
    const std::uintptr_t from = (first + large_page - 1) / large_page * large_page;
    const std::uintptr_t to = (first + bytes) / large_page * large_page;
    // A system without large pages refuses, which changes nothing.
    if (from < to) (void)::madvise(reinterpret_cast<void*>(from), to - from, MADV_HUGEPAGE);
#else
    (void)begin;
    (void)bytes;
#endif
}

void* LargePages::do_allocate(std::size_t bytes, std::size_t alignment) {
    void* const at = ::operator new(bytes, aligned(bytes, alignment));
    prefer_large_pages(at, bytes);
    return at;
}

void LargePages::do_deallocate(void* at, std::size_t bytes, std::size_t alignment) {
    ::operator delete(at, aligned(bytes, alignment));
}

} // namespace glint
