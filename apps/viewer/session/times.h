#pragma once
// How long frames took: what --ui-stats prints.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace glint::viewer {

/// A histogram with steps of a twentieth, from a tenth of a millisecond to minutes.
class FrameTimes {
  public:
    void add(double seconds);

    std::uint64_t count() const { return count_; }
    /// The time that a share of the frames keeps, 0.5 for the median; the upper end of its step, at most a
    /// twentieth too long. 0 without frames.
    double within(double share) const;
    /// The share of frames that took at most so long; exact at the steps' ends, else a step's worth too low.
    double share_within(double seconds) const;
    double longest() const { return longest_; }
    /// One line: "600 frames, median 16.7 ms (60.0 a second), 99 % within 18.4 ms, 99.9 % within …".
    std::string summary() const;
    /// One line a filled range: time, number and a bar.
    std::string histogram() const;

  private:
    static constexpr std::size_t steps = 300;
    std::array<std::uint64_t, steps> counts_{};
    std::uint64_t count_ = 0;
    double longest_ = 0;
};

} // namespace glint::viewer
