// Atomic file writes.

#include "formats/write_file.h"

#include "glint/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>

namespace glint::formats {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : "."; }

std::string cure(const fs::path& path, int code) {
    const std::string folder = folder_of(path).string();
    std::error_code none;
    switch (code) {
    case ENOSPC:
    case EDQUOT:
        return "free some space, or write to another disk";
    case EFBIG:
        return "raise the limit on the size of files (ulimit -f), or write less";
    case ENOENT:
    case ENOTDIR:
        return fs::is_directory(folder, none)
                   ? "no file can be created in the folder '" + folder + "': write to another one"
                   : "create the folder '" + folder + "' first, or correct the name";
    case EISDIR:
        return "name a file inside the folder, such as '" + (path / "picture.png").string() + "'";
    case EACCES:
    case EPERM:
    case EROFS:
        return "write to a place where you have permission to";
    case ENAMETOOLONG:
        return "choose a shorter name";
    case EBUSY:
        return "the file is mounted by itself and cannot be replaced: mount its folder, or write elsewhere";
    case EPIPE:
        return "the program that reads the output has ended; look for its message";
    default:
        return "check the disk, or write to another place";
    }
}

/// `target_path`: what the path links to, or the path itself.
[[noreturn]] void fail_at(const fs::path& path, const fs::path& target_path, int code) {
    const std::string link = target_path == path ? "" : " (it links to '" + target_path.string() + "')";
    throw Error(ErrorKind::output, "cannot write the file: " + std::generic_category().message(code) + link,
                cure(target_path, code), {.file = path.string()});
}

class Descriptor {
  public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int fd() const { return fd_; }
    /// Closes explicitly; some file systems report a full disk only then.
    int close() { return ::close(std::exchange(fd_, -1)); }

  private:
    int fd_;
};

/// The name of a temporary file, where a signal handler finds it: in static memory and without a lock.
struct NameSlot {
    std::atomic<bool> taken{false};
    std::atomic<bool> filled{false};
    std::array<char, PATH_MAX> name{};
};
constinit std::array<NameSlot, 4> name_slots; // of as many threads that write at a time

/// Takes a slot while it lives, if one is free.
class PublishedName {
  public:
    PublishedName() {
        for (NameSlot& slot : name_slots)
            if (!slot_ && !slot.taken.exchange(true)) slot_ = &slot;
    }
    ~PublishedName() {
        if (!slot_) return;
        slot_->filled = false;
        slot_->taken = false;
    }
    PublishedName(const PublishedName&) = delete;
    PublishedName& operator=(const PublishedName&) = delete;

    void set(const char* name) {
        // No file has a longer name.
        if (!slot_ || std::strlen(name) >= slot_->name.size()) return;
        slot_->filled = false;
        std::strcpy(slot_->name.data(), name);
        slot_->filled = true;
    }

  private:
    NameSlot* slot_ = nullptr;
};

/// Opens a new file with a unique name in a folder. Its name is published first: a signal may come at once.
int open_temporary(const fs::path& folder, fs::path& name, PublishedName& published) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        name = folder / (".glint-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
        published.set(name.c_str());
        const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
}

/// A temporary file, removed unless keep() is called. If it cannot be created, its descriptor is negative and
/// errno has the reason.
class Temporary {
  public:
    explicit Temporary(const fs::path& folder) : file_(open_temporary(folder, path_, published_)) {}
    ~Temporary() {
        if (!kept_) ::unlink(path_.c_str());
    }
    Temporary(const Temporary&) = delete;
    Temporary& operator=(const Temporary&) = delete;
    Descriptor& file() { return file_; }
    const fs::path& path() const { return path_; }
    void keep() { kept_ = true; }

  private:
    PublishedName published_;
    fs::path path_; ///< set by the initializer of file_
    Descriptor file_;
    bool kept_ = false;
};

/// Returns 0 or errno.
int write_all(int fd, Pieces pieces) {
    std::array<iovec, 256> some;
    std::size_t written = 0; // bytes of the first piece written
    while (!pieces.empty()) {
        const std::size_t count = std::min(some.size(), pieces.size());
        for (std::size_t i = 0; i < count; ++i)
            some[i] = {const_cast<std::byte*>(pieces[i].data()), pieces[i].size()};
        some[0] = {const_cast<std::byte*>(pieces[0].data()) + written, pieces[0].size() - written};
        const ssize_t taken = ::writev(fd, some.data(), static_cast<int>(count));
        if (taken < 0 && errno == EINTR) continue;
        if (taken < 0) return errno;
        written += static_cast<std::size_t>(taken);
        while (!pieces.empty() && written >= pieces[0].size()) {
            written -= pieces[0].size();
            pieces = pieces.subspan(1);
        }
    }
    return 0;
}

/// Resolves symbolic links: renaming over a link would replace the link.
fs::path follow_links(const fs::path& path) {
    constexpr int max_links = 40;
    fs::path target_path = path;
    std::error_code none;
    for (int i = 0; i < max_links && fs::is_symlink(target_path, none); ++i)
        target_path = target_path.parent_path() / fs::read_symlink(target_path, none);
    return target_path;
}

/// A file that is mounted by itself, as containers do, cannot be replaced.
bool is_mount_point(const fs::path& file) {
    struct statx info = {};
    return ::statx(AT_FDCWD, file.c_str(), 0, 0, &info) == 0 &&
           (info.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

struct Target {
    fs::path target_path;
    bool exists = false;
    bool regular = true; ///< false for devices and pipes, which must not be replaced
    mode_t mode = 0;
};

/// In a folder with the sticky bit, such as /tmp, only its owner may replace a file.
bool may_be_replaced(const fs::path& folder, const struct stat& file) {
    struct stat info = {};
    const uid_t user = ::geteuid();
    return ::stat(folder.c_str(), &info) != 0 || (info.st_mode & S_ISVTX) == 0 || user == 0 ||
           user == info.st_uid || user == file.st_uid;
}

Target find_target(const fs::path& path) {
    Target target;
    struct stat info = {};
    target.exists = ::stat(path.c_str(), &info) == 0;
    if (!target.exists && errno != ENOENT) fail_at(path, path, errno);
    target.regular = !target.exists || S_ISREG(info.st_mode);
    target.mode = info.st_mode & 07777U;
    // Links in /proc to open pipes lead nowhere.
    target.target_path = target.regular ? follow_links(path) : path;
    const auto fail = [&](int code) { fail_at(path, target.target_path, code); };
    if (!target.exists && !target.target_path.has_filename()) fail(path.empty() ? ENOENT : EISDIR);
    if (!target.exists) return target;
    if (S_ISDIR(info.st_mode)) fail(EISDIR);
    if (S_ISSOCK(info.st_mode)) fail(ENXIO);
    if (::access(path.c_str(), W_OK) != 0) fail(errno);
    if (target.regular && !may_be_replaced(folder_of(target.target_path), info)) fail(EPERM);
    if (target.regular && is_mount_point(target.target_path)) fail(EBUSY);
    return target;
}

void write_in_place(const fs::path& path, Pieces pieces) {
    Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.fd() < 0) fail_at(path, path, errno);
    if (const int code = write_all(file.fd(), pieces); code != 0) fail_at(path, path, code);
    if (file.close() != 0) fail_at(path, path, errno);
}

/// Syncs the folder, so that the new name survives a crash; ignores folders that cannot be synced.
void sync_folder(const fs::path& folder) {
    const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.fd() >= 0) ::fsync(opened.fd());
}

} // namespace

void write_pieces(const std::string& path, Pieces pieces) {
    const Target target = find_target(path);
    if (!target.regular) return write_in_place(path, pieces);

    const auto fail = [&](int code) { fail_at(path, target.target_path, code); };
    const fs::path folder = folder_of(target.target_path);
    Temporary temporary(folder);
    Descriptor& file = temporary.file();
    if (file.fd() < 0) fail(errno);
    // Keep the permissions of the replaced file.
    if (target.exists && ::fchmod(file.fd(), target.mode) != 0) fail(errno);
    if (const int code = write_all(file.fd(), pieces); code != 0) fail(code);
    if (::fsync(file.fd()) != 0 && errno != EINVAL) fail(errno);
    if (file.close() != 0) fail(errno);
    if (std::rename(temporary.path().c_str(), target.target_path.c_str()) != 0) fail(errno);
    temporary.keep();
    sync_folder(folder);
}

void write_stdout(std::span<const std::byte> bytes) {
    if (const int code = write_all(STDOUT_FILENO, Pieces(&bytes, 1)); code != 0)
        fail_at("<stdout>", "<stdout>", code);
}

} // namespace glint::formats

namespace glint {

void check_writable(const std::string& path) {
    const formats::Target target = formats::find_target(path);
    if (!target.regular) return;
    // Permissions, read-only disks and odd file systems show themselves only by trying.
    formats::Temporary probe(formats::folder_of(target.target_path));
    if (probe.file().fd() < 0) formats::fail_at(path, target.target_path, errno);
}

std::string file_identity(const std::string& path) {
    const auto text = [](const struct stat& info) {
        return std::to_string(info.st_dev) + ":" + std::to_string(info.st_ino);
    };
    struct stat info = {};
    if (::stat(path.c_str(), &info) == 0) return text(info);
    const std::filesystem::path target = formats::follow_links(path);
    if (::stat(formats::folder_of(target).c_str(), &info) != 0) formats::fail_at(path, target, errno);
    return text(info) + "/" + target.filename().string();
}

void remove_temporary_files() noexcept {
    for (const formats::NameSlot& slot : formats::name_slots)
        if (slot.filled) ::unlink(slot.name.data());
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
    formats::write_pieces(path, formats::Pieces(&bytes, 1));
}

} // namespace glint
