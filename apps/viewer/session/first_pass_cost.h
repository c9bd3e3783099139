#pragma once
// How coarse the first pass of a progressive picture must be to be shown in time.

namespace glint::viewer {

/// A cost model learnt from earlier pictures: tracing costs so much for each sample, showing the picture so
/// much for each pixel.
class FirstPassCost {
  public:
    /// The first picture is to be shown within `seconds`.
    explicit FirstPassCost(double seconds) : seconds_(seconds) {}

    /// The finest step, every step-th pixel of each row and column, that is predicted to be in time.
    int step(int pixels) const;
    /// Takes a measured first pass into account.
    void learn(int pixels, int step, double trace_seconds, double show_seconds);

  private:
    double predicted_seconds(int pixels, int step) const;

    double seconds_;
    double seconds_per_sample_ = 1e-6;
    double seconds_per_pixel_ = 1e-8;
};

} // namespace glint::viewer
