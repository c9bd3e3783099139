// Fuzzing within 512 MiB: glint is told of a limit that leaves room for AddressSanitizer and libFuzzer.

#include <sys/resource.h>

#include <cstdlib>

/// What libFuzzer calls first.
extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments);
extern "C" int LLVMFuzzerInitialize(int*, char***) {
    constexpr rlim_t bytes = rlim_t{384} << 20U;
    const rlimit limit = {bytes, bytes};
    if (setrlimit(RLIMIT_RSS, &limit) != 0) std::abort();
    return 0;
}

/// What AddressSanitizer asks for options: memory that is freed shall not be kept long.
extern "C" const char* __asan_default_options(); // NOLINT(bugprone-reserved-identifier)
extern "C" const char* __asan_default_options() { return "quarantine_size_mb=16"; }
