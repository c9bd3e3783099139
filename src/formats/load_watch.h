#pragma once
// Progress reports and cancellation while reading files.

#include "glint/scene_files.h"

#include <cstdint>
#include <string>

namespace glint::formats {

class LoadWatch {
  public:
    /// Without callbacks.
    LoadWatch() = default;
    LoadWatch(const std::string& file, const LoadOptions& options)
        : cancel_(options.cancel), progress_(options.progress ? &options.progress : nullptr),
          activity_("reading " + file) {}

    /// Reports progress. Throws Error(cancelled) if the caller has cancelled.
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

} // namespace glint::formats
