#pragma once
// The bytes of one PLY file, and how messages point into them.

#include "glint/error.h"

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace glint::ply {

/// A view of a whole file in memory. Places are offsets; lines and columns are counted only when a message
/// needs them, so that readers need not keep account.
class Source {
  public:
    /// `bytes` must outlive the source; `name` stands for the file in messages.
    Source(std::span<const std::byte> bytes, std::string name);

    std::string_view text() const { return text_; }
    std::size_t size() const { return text_.size(); }
    const std::string& name() const { return name_; }
    /// Offset of a part of text().
    std::size_t offset(std::string_view part) const {
        return static_cast<std::size_t>(part.data() - text_.data());
    }

    /// Throws Error(input) at the line and column of an offset, with the line itself where it can be shown.
    [[noreturn]] void fail_in_text(std::size_t offset, std::string message, std::string hint) const;
    /// Throws Error(input) at a byte offset.
    [[noreturn]] void fail_at_byte(std::size_t offset, std::string message, std::string hint) const;

  private:
    std::string_view text_;
    std::string name_;
};

/// A word of a file for a message: in quotes, shortened, bytes that are not printable ASCII as '?'.
std::string in_marks(std::string_view word);

/// "did you mean 'nearest'?", or `otherwise` where no candidate is near.
std::string suggestion(std::string_view word, const std::vector<std::string>& candidates,
                       std::string otherwise);

} // namespace glint::ply
