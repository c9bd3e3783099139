#pragma once

#include "formats/load_watch.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace glint {

/// A file to be read from its beginning to its end. Throws Error(input), naming the file, the system's reason
/// and a cure.
class InputFile {
  public:
    explicit InputFile(std::string path);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    /// What the system says of its size; nothing for pipes and the like, which tell none.
    std::optional<std::size_t> size() const { return size_; }
    /// Reads some of the next bytes; how many, 0 at the end.
    std::size_t read(std::span<std::byte> bytes);
    /// Back to its beginning; only of a file that has a size.
    void rewind();

  private:
    std::string path_;
    int descriptor_ = -1;
    std::optional<std::size_t> size_;
};

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

/// All that is left of a file, in memory.
FileBytes read_bytes(InputFile& file, const LoadWatch& watch = {});
/// A whole file.
FileBytes read_bytes(const std::string& path);

} // namespace glint
