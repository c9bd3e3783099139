#pragma once
// Renders one view on the backend that is selected, and on the CPU after a fault of the GPU.

#include "backend.h"

#include "glint/kernels.h"
#include "glint/scene.h"

#include <memory>
#include <optional>
#include <string>

namespace glint::viewer {

struct RenderedFrame;

/// How coarse the first pass of a picture must be to be shown in time: a cost model learnt from earlier
/// pictures: tracing costs so much for each sample, showing the picture so much for each pixel.
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

/// For one thread, the renderer's.
class ViewRenderer {
  public:
    /// What the next picture shows, and how it is rendered.
    struct Picture {
        Scene scene; ///< with the camera and size of the view
        Aov show = Aov::final;
        Kernel kernel = Kernel::automatic;
        BackendFactory gpu;          ///< none: the CPU renders
        int max_step = max_coarsest; ///< no frame coarser than this is shown
    };

    /// `cancel` ends start() and refine() within milliseconds and must outlive the renderer.
    ViewRenderer(int threads, double first_picture_seconds, const CancelFlag& cancel);

    /// Renders the first pass of a picture, as coarse as it must be to be shown in time.
    void start(Picture picture);
    /// Renders for about `seconds`, or not at all once the picture is finished.
    void refine(double seconds);
    /// Fills in a frame, all but its number and colours of the screen. False if there is nothing to show:
    /// no pass is complete, or the picture is coarser than what was shown before.
    bool copy_to(RenderedFrame& frame);
    /// How long it took to show the first pass: the next one is as coarse as that suggests.
    void learn_show_seconds(double seconds);

    /// From here to the next start() there is nothing to render.
    void clear() { picture_.reset(); }
    /// Lets the next start() try the GPU again.
    void forget_fault() { fault_.clear(); }
    /// Destroys the backends.
    void release();

    bool has_picture() const { return picture_.has_value(); }
    /// Also true without a picture.
    bool is_finished() const;

  private:
    struct Device {
        explicit Device(double first_picture_seconds) : cost(first_picture_seconds) {}

        std::unique_ptr<Backend> backend; ///< none before it is needed, and after a fault
        FirstPassCost cost;
    };
    Device& active() { return on_gpu_ ? gpu_ : cpu_; }
    const Device& active() const { return on_gpu_ ? gpu_ : cpu_; }
    bool start_on_gpu();
    void start_on_cpu();
    void render_first_pass(Device& device);
    void fall_back(const std::string& fault);
    int pixel_count() const;

    int threads_;
    const CancelFlag& cancel_;
    Device cpu_, gpu_;
    std::optional<Picture> picture_;
    bool on_gpu_ = false;           ///< the backend that renders `picture_`
    std::string fault_;             ///< why the GPU is not used; empty: it may be
    int first_step_ = 0;            ///< of the last first pass; 0: it was not typical
    double first_pass_seconds_ = 0; ///< of that pass, without showing it
};

} // namespace glint::viewer
