#include "formats/read_bytes.h"

#include "formats/large_pages.h"
#include "glint/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

namespace glint {

namespace {

[[noreturn]] void fail(const std::string& path, int code) {
    std::string hint = "check the disk and the file system";
    if (code == ENOENT || code == ENOTDIR)
        hint = "check the name; relative names start at the working directory";
    if (code == EISDIR) hint = "name a file inside the folder";
    if (code == EACCES || code == EPERM) hint = "ask for permission to read it";
    Location where;
    where.file = path;
    throw Error(ErrorKind::input, "cannot read the file: " + std::generic_category().message(code), hint,
                where);
}

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() { ::close(fd_); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int fd() const { return fd_; }

  private:
    int fd_;
};

} // namespace

FileBytes::FileBytes(std::size_t size)
    : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {
    prefer_large_pages(bytes_.get(), size);
}

void FileBytes::grow(std::size_t size, std::size_t kept) {
    FileBytes larger(size);
    std::copy_n(data(), kept, larger.data());
    *this = std::move(larger);
}

FileBytes read_bytes(const std::string& path, const LoadWatch& watch) {
    const int opened = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (opened < 0) fail(path, errno);
    const Descriptor file(opened);
    struct stat info = {};
    if (::fstat(file.fd(), &info) != 0) fail(path, errno);
    if (S_ISDIR(info.st_mode)) fail(path, EISDIR);

    // Pipes tell no size, and files may grow: the size only says where to begin. One byte more finds the end.
    constexpr std::size_t least = 1U << 16U;
    constexpr std::size_t at_once = 1U << 24U;
    FileBytes bytes(S_ISREG(info.st_mode) ? static_cast<std::size_t>(info.st_size) + 1 : least);
    std::size_t used = 0;
    for (;;) {
        if (used == bytes.size()) bytes.grow(2 * used, used);
        watch.at(0, 1);
        const ssize_t count = ::read(file.fd(), bytes.data() + used, std::min(bytes.size() - used, at_once));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, errno);
        if (count == 0) break;
        used += static_cast<std::size_t>(count);
    }
    bytes.cut(used);
    return bytes;
}

} // namespace glint
