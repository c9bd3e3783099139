// Loaded into a program by LD_PRELOAD, lets its allocations fail.
//
//   FAIL_ALLOCATION=7    the seventh only
//   FAIL_ALLOCATION=7+   the seventh and all after it
//   COUNT_ALLOCATIONS=F  writes how many there were to the file F

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

// What the C library calls its own, so that they can be called from here.
extern "C" {
void* __libc_malloc(std::size_t);                // NOLINT(bugprone-reserved-identifier)
void* __libc_calloc(std::size_t, std::size_t);   // NOLINT(bugprone-reserved-identifier)
void* __libc_realloc(void*, std::size_t);        // NOLINT(bugprone-reserved-identifier)
void* __libc_memalign(std::size_t, std::size_t); // NOLINT(bugprone-reserved-identifier)
}

namespace {

std::atomic<long> count{0};
long first_failure = 0; ///< 0: none fails
bool sustained = false;

[[gnu::constructor]] void read_environment() {
    if (const char* text = std::getenv("FAIL_ALLOCATION")) {
        first_failure = std::atol(text);
        sustained = std::strchr(text, '+') != nullptr;
    }
    count = 0;
}

[[gnu::destructor]] void write_count() {
    const char* name = std::getenv("COUNT_ALLOCATIONS");
    const long counted = count;
    first_failure = 0;
    if (std::FILE* file = name ? std::fopen(name, "w") : nullptr) {
        std::fprintf(file, "%ld\n", counted);
        std::fclose(file);
    }
}

bool fails() {
    const long number = ++count;
    const bool failing = first_failure > 0 && (sustained ? number >= first_failure : number == first_failure);
    if (failing) errno = ENOMEM;
    return failing;
}

} // namespace

extern "C" {

void* malloc(std::size_t size) { return fails() ? nullptr : __libc_malloc(size); }
void* calloc(std::size_t items, std::size_t size) { return fails() ? nullptr : __libc_calloc(items, size); }
void* realloc(void* at, std::size_t size) { return fails() ? nullptr : __libc_realloc(at, size); }
void* memalign(std::size_t alignment, std::size_t size) {
    return fails() ? nullptr : __libc_memalign(alignment, size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }
int posix_memalign(void** at, std::size_t alignment, std::size_t size) {
    *at = memalign(alignment, size);
    return *at ? 0 : ENOMEM;
}

} // extern "C"
