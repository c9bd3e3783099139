// Reading whole files.

#include "formats/read_bytes.h"

#include "glint/error.h"
#include "glint/limits.h"
#include "parallel/large_pages.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

namespace glint::formats {

namespace {

[[noreturn]] void fail(const std::string& path, int code) {
    std::string hint = "check the disk and the file system";
    if (code == ENOENT || code == ENOTDIR)
        hint = "check the name; relative names start at the working directory";
    if (code == ENAMETOOLONG) hint = "shorten the name";
    if (code == ELOOP) hint = "mend the symbolic links, which lead back to themselves";
    if (code == EISDIR) hint = "name a file inside the folder";
    if (code == EACCES || code == EPERM) hint = "ask for permission to read it";
    throw Error(ErrorKind::input, "cannot read the file: " + std::generic_category().message(code), hint,
                {.file = path});
}

} // namespace

InputFile::InputFile(std::string path) : InputFile(::open(path.c_str(), O_RDONLY | O_CLOEXEC), path) {}

InputFile::InputFile(int descriptor, std::string name) : path_(std::move(name)), descriptor_(descriptor) {
    if (descriptor_ < 0) fail(path_, errno);
    struct stat info = {};
    const int code = ::fstat(descriptor_, &info) != 0 ? errno : S_ISDIR(info.st_mode) ? EISDIR : 0;
    if (code != 0) {
        ::close(descriptor_);
        fail(path_, code);
    }
    if (S_ISREG(info.st_mode)) size_ = static_cast<std::size_t>(info.st_size);
}

InputFile::~InputFile() { ::close(descriptor_); }

std::size_t InputFile::read(std::span<std::byte> bytes) {
    for (;;) {
        const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
        if (count >= 0) return static_cast<std::size_t>(count);
        if (errno != EINTR) fail(path_, errno);
    }
}

void InputFile::rewind() {
    if (::lseek(descriptor_, 0, SEEK_SET) != 0) fail(path_, errno);
}

FileBytes::FileBytes(std::size_t size)
    : bytes_(std::make_unique_for_overwrite<std::byte[]>(size)), size_(size) {
    parallel::prefer_large_pages(bytes_.get(), size);
}

void FileBytes::grow(std::size_t size, std::size_t kept) {
    FileBytes larger(size);
    std::copy_n(data(), kept, larger.data());
    *this = std::move(larger);
}

void refuse_compressed(std::string_view bytes, const std::string& name) {
    struct Kind {
        std::string_view magic;
        const char* name;
        const char* cure;
    };
    using namespace std::string_view_literals;
    static constexpr Kind kinds[] = {{"\x1f\x8b"sv, "gzip", "decompress it first: gunzip -k"},
                                     {"\xfd"
                                      "7zXZ\0"sv,
                                      "xz", "decompress it first: unxz -k"},
                                     {"\x28\xb5\x2f\xfd"sv, "zstd", "decompress it first: unzstd -k"},
                                     {"BZh"sv, "bzip2", "decompress it first: bunzip2 -k"},
                                     {"PK\3\4"sv, "zip", "unpack it first: unzip"}};
    for (const Kind& kind : kinds) {
        if (!bytes.starts_with(kind.magic)) continue;
        // Text may begin with BZh too; a block of bzip2 begins with the digits of pi.
        if (kind.name == "bzip2"sv &&
            !bytes.substr(std::min<std::size_t>(4, bytes.size())).starts_with("1AY&SY"))
            continue;
        throw Error(ErrorKind::input, std::string("the file is compressed with ") + kind.name, kind.cure,
                    {.file = name});
    }
}

const char* special_file(const std::filesystem::file_status& status) {
    switch (status.type()) {
    case std::filesystem::file_type::fifo:
        return "a FIFO";
    case std::filesystem::file_type::socket:
        return "a socket";
    case std::filesystem::file_type::block:
    case std::filesystem::file_type::character:
        return "a device";
    default:
        return nullptr;
    }
}

void require_memory_to_grow(std::size_t bytes, const std::string& name) {
    require_memory(2 * static_cast<double>(bytes), "reading on", "give it a smaller input", {.file = name});
}

FileBytes read_bytes(InputFile& file, const LoadWatch& watch, const CheckStart& check_start) {
    // Pipes have no size, and files may grow: the size is only an initial guess. Reading one byte more
    // detects the end.
    constexpr std::size_t least = 1U << 16U;
    constexpr std::size_t at_once = 1U << 24U;
    if (file.size())
        require_memory(static_cast<double>(*file.size()), "the file", "close other programs",
                       {.file = file.path()});
    FileBytes bytes(file.size() ? *file.size() + 1 : least);
    std::size_t used = 0;
    for (;;) {
        if (used == bytes.size()) {
            if (used == least && check_start) check_start(bytes);
            require_memory_to_grow(used, file.path());
            bytes.grow(2 * used, used);
        }
        watch.at(0, 1);
        const std::size_t count = file.read({bytes.data() + used, std::min(bytes.size() - used, at_once)});
        if (count == 0) break;
        used += count;
    }
    bytes.cut(used);
    return bytes;
}

} // namespace glint::formats
