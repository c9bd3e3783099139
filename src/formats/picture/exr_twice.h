#pragma once
// Telling damage from lack of memory.

#include "glint/error.h"

#include <exception>

namespace glint::formats {

/// Calls `work` again if it throws anything but an Error. Where zlib lacks memory, OpenEXR reports data that
/// are damaged; what is damaged fails again.
template <class Work>
auto twice(const Work& work) {
    try {
        return work();
    } catch (const Error&) {
        throw;
    } catch (const std::exception&) {
        return work();
    }
}

} // namespace glint::formats
