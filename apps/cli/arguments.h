#pragma once
// A command line parsed by the table of options. Invalid ones throw Error(usage) with the option, what was
// expected and what was given.

#include "options.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

class Arguments {
  public:
    Arguments(const Command& command, std::map<std::string, std::vector<std::string>> values,
              std::vector<std::string> operands);

    const Command& command() const { return *command_; }
    const std::vector<std::string>& operands() const { return operands_; }

    /// Was the option with this key given?
    bool has(const std::string& key) const;
    /// Its value, the last one if there are several.
    std::optional<std::string> text(const std::string& key) const;
    /// All its values, in order.
    std::vector<std::string> all(const std::string& key) const;
    /// The index of its value among choices(); 0 if it was not given.
    std::size_t choice(const std::string& key) const;
    /// A whole number in [min, max].
    std::optional<std::int64_t> integer(const std::string& key, std::int64_t min, std::int64_t max) const;
    /// A number ≥ 0; may be "inf".
    std::optional<double> number(const std::string& key) const;
    /// `count` whole numbers in [min, max], separated by `separator`. `example` shows the format.
    std::optional<std::vector<std::int64_t>> integers(const std::string& key, std::size_t count,
                                                      char separator, std::int64_t min, std::int64_t max,
                                                      const char* example) const;

  private:
    const Command* command_;
    std::map<std::string, std::vector<std::string>> values_;
    std::vector<std::string> operands_;
};

/// None unless all of the text is a number.
std::optional<std::int64_t> whole_number(std::string_view text);

/// Parses the arguments after the command's name. Unknown options get a "did you mean". The number of
/// operands is checked unless --help is given.
Arguments parse_arguments(const Command& command, const std::vector<std::string>& arguments);

} // namespace glint::cli
