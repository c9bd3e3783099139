#pragma once
// A command line taken apart by the table of options. Every fault is an Error(usage) that names the option,
// what was expected and what was given.

#include "options.h"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

class Arguments {
  public:
    Arguments(const Command& command, std::map<std::string, std::vector<std::string>> values,
              std::vector<std::string> operands);

    const Command& command() const { return *command_; }
    const std::vector<std::string>& operands() const { return operands_; }

    /// Was the option of that key given?
    bool has(const std::string& key) const;
    /// Its value; of several the last one.
    std::optional<std::string> text(const std::string& key) const;
    /// All its values, in order.
    std::vector<std::string> all(const std::string& key) const;
    /// A whole number within [least, most].
    std::optional<std::int64_t> integer(const std::string& key, std::int64_t least, std::int64_t most) const;
    /// A number, "inf" included, not below 0.
    std::optional<double> number(const std::string& key) const;
    /// `count` whole numbers within [least, most], parted by `separator`. `example` shows the
    /// form.
    std::optional<std::vector<std::int64_t>> integers(const std::string& key, std::size_t count,
                                                      char separator, std::int64_t least, std::int64_t most,
                                                      const char* example) const;

  private:
    const Command* command_;
    std::map<std::string, std::vector<std::string>> values_;
    std::vector<std::string> operands_;
};

/// Takes apart what follows the command's name. Unknown options get a "did you mean". The number of operands
/// is checked unless --help is given.
Arguments parse_arguments(const Command& command, const std::vector<std::string>& words);

} // namespace glint::cli
