#pragma once
// The bytes of a PLY file, and errors that refer to positions in it.

#include "glint/error.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace glint::formats::ply {

/// A view of a whole file in memory. Positions are byte offsets; lines and columns are counted only for
/// messages.
class Source {
  public:
    /// `bytes` must outlive the source; `name` is the file name for messages.
    Source(std::span<const std::byte> bytes, std::string name);

    std::string_view text() const { return text_; }
    std::size_t size() const { return text_.size(); }
    const std::string& name() const { return name_; }
    /// Offset of a part of text().
    std::size_t offset(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - text_.data());
    }

    /// Throws Error(input) with line, column and, if printable, the line at an offset.
    [[noreturn]] void fail_in_text(std::size_t offset, std::string message, std::string hint) const;
    /// Throws Error(input) at a byte offset.
    [[noreturn]] void fail_at_byte(std::size_t offset, std::string message, std::string hint) const;

  private:
    std::string_view text_;
    std::string name_;
};

/// A word of the file for messages: quoted and shortened, with non-printable characters as '?'.
std::string quoted_word(std::string_view word);

/// "did you mean 'nearest'?", or `otherwise` if no candidate is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       std::string otherwise);

} // namespace glint::formats::ply
