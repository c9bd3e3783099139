#pragma once
// How PNG files are read and written without libpng's errors getting into C++'s way. For png_*.cpp only,
// since it shows libpng's types.

#include <png.h>

#include <array>
#include <csetjmp>
#include <cstddef>

namespace glint {

/// The text of the error that ended a call, kept without the heap.
struct PngFailure {
    std::array<char, 160> message{};
};

/// libpng's error callback: keeps the message and leaves by longjmp.
[[noreturn]] inline void png_fail(png_structp png, png_const_charp message) {
    auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
    std::size_t length = 0;
    for (; message[length] != '\0' && length + 1 < failure->message.size(); ++length)
        failure->message[length] = message[length];
    failure->message[length] = '\0';
    png_longjmp(png, 1);
}

/// libpng's warnings are about ancillary chunks; the picture is whole without them.
inline void png_ignore(png_structp, png_const_charp) {}

/// Runs calls to libpng; false when one of them failed. The longjmp passes over `calls`, which therefore must
/// hold nothing with a destructor.
template <class Calls>
bool png_try(png_structp png, const Calls& calls) {
    if (setjmp(png_jmpbuf(png)) != 0) return false; // NOLINT(cert-err52-cpp): libpng has no other way
    calls();
    return true;
}

} // namespace glint
