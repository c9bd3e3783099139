#pragma once
// What --ui-stats prints: histograms of the times of frames and pictures.

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

/// How long frames of the window took, and the rate of pictures while the camera moved.
class Statistics {
  public:
    /// `last_move`: when the camera last moved.
    void frame_drawn(double seconds, double last_move);
    void picture_shown(double last_move);
    std::string text() const;

  private:
    FrameTimes frames_;
    FrameTimes moving_frames_; ///< while the camera moved
    FrameTimes pictures_;      ///< from picture to picture while the camera moved
    double last_picture_ = 0;
};

} // namespace glint::viewer
