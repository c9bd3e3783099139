#pragma once
// A histogram of frame times, as --ui-stats prints it.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace glint::viewer {

/// Bins grow by 5 %, from 0.1 ms to minutes.
class FrameTimes {
  public:
    void add(double seconds);

    std::uint64_t count() const { return count_; }
    /// The quantile of a share of the frames, 0.5 for the median: the upper end of its bin, at most 5 % too
    /// long. 0 without frames.
    double quantile(double share) const;
    /// The share of frames that took at most `seconds`; exact at the ends of bins, else one bin too low.
    double share_within(double seconds) const;
    double longest() const { return longest_; }
    /// One line: "600 frames, median 16.7 ms (60.0 a second), 99 % within 18.4 ms, 99.9 % within …".
    std::string summary() const;
    /// One line for each filled range: time, number and a bar.
    std::string histogram() const;

  private:
    static constexpr std::size_t bins = 300;
    std::array<std::uint64_t, bins> counts_{};
    std::uint64_t count_ = 0;
    double longest_ = 0;
};

} // namespace glint::viewer
