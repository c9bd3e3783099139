// Large pages through madvise().

#include "parallel/large_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <new>

namespace glint::parallel {
namespace {

/// A multiple of all common small page sizes.
constexpr std::size_t small_page = std::size_t{1} << 16U;

/// Calls madvise() for the whole pages within a range. Failure is harmless and ignored.
void advise(void* begin, std::size_t bytes, std::size_t page, int advice) {
    const std::size_t skipped = (page - reinterpret_cast<std::uintptr_t>(begin) % page) % page;
    const std::size_t whole = skipped < bytes ? (bytes - skipped) / page * page : 0;
    if (whole > 0) (void)::madvise(static_cast<char*>(begin) + skipped, whole, advice);
}

/// Blocks of at least one large page start at a page boundary.
std::align_val_t aligned(std::size_t bytes, std::size_t alignment) {
    return std::align_val_t(bytes >= large_page ? large_page : alignment);
}

} // namespace

void prefer_large_pages(void* begin, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
    advise(begin, bytes, large_page, MADV_HUGEPAGE);
#else
    (void)begin;
    (void)bytes;
#endif
}

void return_pages(void* begin, std::size_t bytes) { advise(begin, bytes, small_page, MADV_DONTNEED); }

void* new_in_large_pages(std::size_t bytes, std::size_t alignment) {
    void* const at = ::operator new(bytes, aligned(bytes, alignment));
    prefer_large_pages(at, bytes);
    return at;
}

void delete_in_large_pages(void* at, std::size_t bytes, std::size_t alignment) {
    ::operator delete(at, aligned(bytes, alignment));
}

} // namespace glint::parallel
