#pragma once
// What a caller may want to know, and to stop, while a large file is read.

#include "glint/formats.h"

#include <cstdint>
#include <string>

namespace glint {

class LoadWatch {
  public:
    /// Nobody watches.
    LoadWatch() = default;
    LoadWatch(const std::string& file, const LoadOptions& options)
        : cancel_(options.cancel), progress_(options.progress ? &options.progress : nullptr),
          activity_("reading " + file) {}

    /// Tells that `done` of `all` is read. Throws Error(cancelled) where the caller has had enough.
    void at(std::uint64_t done, std::uint64_t all) const {
        if (cancel_ != nullptr && cancel_->load(std::memory_order_relaxed))
            throw Error(ErrorKind::cancelled, activity_ + " was cancelled");
        if (progress_ != nullptr)
            (*progress_)({activity_, all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 1.0});
    }

  private:
    const CancelFlag* cancel_ = nullptr;
    const LoadCallback* progress_ = nullptr;
    std::string activity_;
};

} // namespace glint
