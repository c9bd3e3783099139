// Error handling of libpng by setjmp and longjmp.

#include "formats/picture/png_guard.h"

#include <png.h>

#include <csetjmp>
#include <cstddef>
#include <new>
#include <string_view>

namespace glint::formats {

void png_fail(png_struct_def* png, const char* message) {
    auto* failure = static_cast<PngFailure*>(png_get_error_ptr(png));
    std::size_t length = 0;
    for (; message[length] != '\0' && length + 1 < failure->message.size(); ++length)
        failure->message[length] = message[length];
    failure->message[length] = '\0';
    png_longjmp(png, 1);
}

void throw_if_out_of_memory(const PngFailure& failure) {
    const std::string_view message = failure.message.data();
    for (const char* words :
         {"ut of memory", "not enough memory", "nsufficient memory", "too many text chunks"})
        if (message.find(words) != std::string_view::npos) throw std::bad_alloc();
}

void png_ignore(png_struct_def*, const char*) {}

bool png_try(png_struct_def* png, const std::function<void()>& calls) {
    if (setjmp(png_jmpbuf(png)) != 0) return false; // NOLINT(cert-err52-cpp): libpng offers no other way
    calls();
    return true;
}

} // namespace glint::formats
