#pragma once
// Notices when files that are open elsewhere are saved.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace glint::viewer {

/// Compares modification time, size and existence of files when asked. File system notifications would not be
/// simpler: editors save in too many ways.
class FileWatch {
  public:
    /// Watches these files too, from their present state; files watched already keep the state last seen.
    void watch(const std::vector<std::string>& files);

    /// Has a file changed since it was last seen, and not since the last call? True once for each change.
    bool has_changed();

  private:
    struct Stamp {
        bool exists = false;
        std::filesystem::file_time_type time{};
        std::uintmax_t size = 0;

        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    static Stamp stamp_of(const std::string& file);

    std::map<std::string, Stamp> known_;  ///< as last reported
    std::map<std::string, Stamp> before_; ///< at the last call
};

} // namespace glint::viewer
