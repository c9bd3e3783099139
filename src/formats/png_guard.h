#pragma once
// How PNG files are read and written without libpng's errors getting into C++'s way.

#include <array>
#include <functional>

/// libpng's png_struct, by the name that libpng declares it with.
struct png_struct_def;

namespace glint {

/// The text of the error that ended a call, kept without the heap.
struct PngFailure {
    std::array<char, 160> message{};
};

/// libpng's error callback: keeps the message in the PngFailure and leaves by longjmp.
[[noreturn]] void png_fail(png_struct_def* png, const char* message);

/// libpng's warnings are about ancillary chunks; the picture is whole without them.
void png_ignore(png_struct_def* png, const char* message);

/// Runs calls to libpng; false when one of them failed. The longjmp passes over `calls`, which therefore must
/// hold nothing with a destructor.
bool png_try(png_struct_def* png, const std::function<void()>& calls);

} // namespace glint
