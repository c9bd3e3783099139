#pragma once

#include "formats/load_watch.h"

#include <cstddef>
#include <memory>
#include <span>
#include <string>

namespace glint {

/// Bytes that are not zeroed before they are written: for large files that is a pass over memory saved.
class FileBytes {
  public:
    explicit FileBytes(std::size_t size);

    std::byte* data() { return bytes_.get(); }
    std::size_t size() const { return size_; }
    /// Takes larger memory; the first `kept` bytes stay.
    void grow(std::size_t size, std::size_t kept);
    /// Forgets what stands beyond `size`.
    void cut(std::size_t size) { size_ = size; }

    operator std::span<const std::byte>() const { return {bytes_.get(), size_}; }

  private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_;
};

/// A whole file in memory. Throws Error(input), naming the file, the system's reason and a cure.
FileBytes read_bytes(const std::string& path, const LoadWatch& watch = {});

} // namespace glint
