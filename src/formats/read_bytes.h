#pragma once
// Reading files into memory.

#include "formats/load_watch.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace glint::formats {

/// A file opened for sequential reading. Throws Error(input) with the file name, the reason given by the
/// system, and a cure.
class InputFile {
  public:
    explicit InputFile(std::string path);
    /// Reads from an open descriptor, and closes it; `name` is for messages.
    InputFile(int descriptor, std::string name);
    ~InputFile();
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;

    const std::string& path() const { return path_; }
    /// Size reported by the system; none for pipes and the like.
    std::optional<std::size_t> size() const { return size_; }
    /// Reads some of the next bytes; returns their number, 0 at the end.
    std::size_t read(std::span<std::byte> bytes);
    /// Seeks to the start; only if the file has a size.
    void rewind();

  private:
    std::string path_;
    int descriptor_;
    std::optional<std::size_t> size_;
};

/// A byte buffer without zero initialization, which saves a pass over memory for large files.
class FileBytes {
  public:
    explicit FileBytes(std::size_t size);

    std::byte* data() { return bytes_.get(); }
    std::size_t size() const { return size_; }
    /// Reallocates; keeps the first `kept` bytes.
    void grow(std::size_t size, std::size_t kept);
    /// Truncates to `size`.
    void cut(std::size_t size) { size_ = size; }

    operator std::span<const std::byte>() const { return {bytes_.get(), size_}; }

  private:
    std::unique_ptr<std::byte[]> bytes_;
    std::size_t size_;
};

/// Throws Error(input) for the bytes of a compressed file, and says of which kind.
void refuse_compressed(std::string_view bytes, const std::string& name);

/// "a FIFO", "a socket" or "a device": what a file is that is neither regular nor a folder; null for others.
const char* special_file(const std::filesystem::file_status& status);

/// Throws Error(resource) where twice as many bytes as were read do not fit into memory: files that have no
/// size, such as pipes, may never end.
void require_memory_to_grow(std::size_t bytes, const std::string& name);

/// Throws for a file that begins with bytes with which none of its kind does.
using CheckStart = std::function<void(std::span<const std::byte>)>;

/// Reads the rest of a file. `check_start` ends reading what may have no end.
FileBytes read_bytes(InputFile& file, const LoadWatch& watch = {}, const CheckStart& check_start = {});

} // namespace glint::formats
