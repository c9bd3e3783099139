#pragma once
// Files that other programs may save at any moment.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace glint::viewer {

/// Tells by time, size and number of files whether they were written again. Files are looked at only when
/// asked: editors save in too many ways for the system's notices to be simpler.
class FileWatch {
  public:
    /// Watches these too from now on; those that are watched keep the state that they were seen in.
    void look_at(const std::vector<std::string>& files);

    /// Has any file become another since it was looked at, and come to rest since the last question? Says so
    /// once for each change.
    bool has_changed();

  private:
    struct Stamp {
        bool exists = false;
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;

        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    static Stamp stamp_of(const std::string& file);

    std::map<std::string, Stamp> known_;  ///< as they were read
    std::map<std::string, Stamp> before_; ///< as they were at the last question
};

} // namespace glint::viewer
