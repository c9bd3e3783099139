#pragma once
#include <string>

namespace glint {

/// What is wrong with a value, and what is expected instead (may be empty).
struct KeyFault {
    std::string message;
    std::string hint;
};

} // namespace glint
