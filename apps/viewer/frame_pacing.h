#pragma once
// When the window draws its next frame. Drawing takes time from rendering, most of all where OpenGL is
// software.

namespace glint::viewer {

class FramePacing {
  public:
    FramePacing();

    /// Keys, mouse or files: the next frames are drawn soon.
    void add_input();
    /// There is something new to show.
    void add_news() { has_news_ = true; }

    /// Is a frame to be drawn at this time? `animating`: every frame differs from the one before.
    /// `last_move`: when the camera moved.
    bool is_due(double time, bool animating, double last_move);
    /// A frame begins; returns the seconds since the last one, at most 0.1.
    double begin_frame(double time);
    void end_frame();

    /// How long the window may wait for input.
    double wait_seconds(bool animating) const;
    /// wait() was ended by input or by another thread.
    void add_wake();

  private:
    int frames_to_draw_;
    bool has_news_ = false;
    double last_input_;
    double last_frame_ = 0;
    double due_ = 0;
};

} // namespace glint::viewer
