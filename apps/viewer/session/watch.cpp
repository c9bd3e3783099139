// Snapshots of files and their comparison.
#include "watch.h"

#include <system_error>

namespace glint::viewer {

FileWatch::Stamp FileWatch::stamp_of(const std::string& file) {
    std::error_code failed;
    Stamp stamp;
    stamp.time = std::filesystem::last_write_time(file, failed);
    if (failed) return {};
    stamp.size = std::filesystem::file_size(file, failed);
    stamp.exists = !failed;
    return stamp;
}

void FileWatch::watch(const std::vector<std::string>& files) {
    for (const std::string& file : files) known_.try_emplace(file, stamp_of(file));
    before_ = known_;
}

bool FileWatch::has_changed() {
    std::map<std::string, Stamp> now;
    for (const auto& [file, stamp] : known_) now[file] = stamp_of(file);
    // A file that has changed since the last call may be half written.
    const bool is_settled = now == before_;
    before_ = now;
    if (!is_settled || now == known_) return false;
    known_ = std::move(now);
    return true;
}

} // namespace glint::viewer
