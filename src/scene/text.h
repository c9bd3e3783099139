#pragma once
// Text of messages about values and scene files.

#include <string>
#include <string_view>
#include <vector>

namespace glint {

/// The shortest text that reads back as x: "0.1", "4", "nan".
std::string show(double x);

/// "word" between quotes, as one short line: control characters become '?', long text ends in "…".
std::string in_quotes(std::string_view text);

/// "a, b, c".
std::string listed(const std::vector<std::string>& words);

/// "did you mean "glass"?", or nothing where no candidate is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

} // namespace glint
