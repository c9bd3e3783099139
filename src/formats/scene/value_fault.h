#pragma once
// What people write as values that is not TOML.

#include <optional>
#include <string>
#include <string_view>

namespace glint::formats {

struct ValueFault {
    std::string message;
    std::string hint;
    bool is_text = false; ///< only quotes are missing
};

/// What is wrong with the text of a value, such as 1e400, .5, (1, 2, 3), True, or a name without quotes; none
/// if it is something else.
std::optional<ValueFault> value_fault(std::string_view text);

} // namespace glint::formats
