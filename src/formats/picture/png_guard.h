#pragma once
// Calls to libpng from C++; its errors longjmp.

#include <array>
#include <functional>

/// libpng's png_struct under its tag name.
struct png_struct_def;

namespace glint::formats {

/// Message of a failed call, without heap memory.
struct PngFailure {
    std::array<char, 160> message{};
};

/// libpng's error callback: stores the message in the PngFailure and longjmps.
[[noreturn]] void png_fail(png_struct_def* png, const char* message);

/// Throws std::bad_alloc if the message of libpng or zlib tells of a lack of memory.
void throw_if_out_of_memory(const PngFailure& failure);

/// libpng's warning callback. Warnings concern ancillary chunks, without which the picture is complete.
void png_ignore(png_struct_def* png, const char* message);

/// Runs calls to libpng; returns false if one fails. The longjmp skips destructors, so `calls` must not
/// create objects that have one.
bool png_try(png_struct_def* png, const std::function<void()>& calls);

} // namespace glint::formats
