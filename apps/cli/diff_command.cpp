// glint diff: compares two pictures.
#include "commands.h"
#include "outputs.h"

#include "glint/limits.h"
#include "glint/picture_files.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace glint::cli {
namespace {

/// The difference of two pictures in all metrics.
struct Measures {
    Comparison comparison; ///< its share: of pixels that differ by more than 1/255
    double unequal = 0;    ///< fraction of pixels that differ at all
    bool eight_bit = false;
};

void require_same_size(const Image& a, const Image& b) {
    if (a.width == b.width && a.height == b.height) return;
    throw Error(ErrorKind::input, fmt::format("the pictures have different sizes: {}×{} and {}×{}", a.width,
                                              a.height, b.width, b.height));
}

Measures measure(const LoadedPicture& a, const LoadedPicture& b) {
    const PictureDifference any = diff_pictures(a, b, 0);
    const double one_step = any.eight_bit ? 1.0 : 1.0 / 255;
    return {diff_pictures(a, b, one_step).comparison, any.comparison.share, any.eight_bit};
}

/// Is the metric within the tolerance? PSNR alone falls with the difference.
bool within(const Comparison& found, const std::string& metric, double tolerance) {
    if (metric == "psnr") return found.psnr >= tolerance;
    const double value = metric == "mae"     ? found.mae
                         : metric == "rmse"  ? found.rmse
                         : metric == "share" ? found.share
                                             : found.max;
    return value <= tolerance;
}

std::string table(const Measures& measures) {
    const Comparison& found = measures.comparison;
    const char* unit = measures.eight_bit ? " of 255" : "";
    return fmt::format("max      {:.6g}{}\n"
                       "mae      {:.6g}{}\n"
                       "rmse     {:.6g}{}\n"
                       "psnr     {:.4g} dB\n"
                       "unequal  {:.6g} of the pixels\n"
                       "share    {:.6g} of the pixels by more than 1/255\n",
                       found.max, unit, found.mae, unit, found.rmse, unit, found.psnr, measures.unequal,
                       found.share);
}

/// Scaled to 1 for white, so that pictures of 8 and 16 bits can be compared.
LoadedPicture relative_to_white(LoadedPicture picture) {
    if (picture.bits == 32) return picture;
    const float white = picture.bits == 16 ? 65535.0f : 255.0f;
    for (float& value : picture.image.pixels) value /= white;
    for (float& value : picture.alpha) value /= white;
    return picture;
}

void write_heat(const std::string& path, const LoadedPicture& a, const LoadedPicture& b,
                const Measures& measures) {
    const double max_difference = measures.comparison.max / (measures.eight_bit ? 255 : 1);
    // Equal pictures, and infinite differences, need a finite scale above 0.
    const double full_scale = max_difference > 0 && std::isfinite(max_difference) ? max_difference : 1;
    require_memory(3.0 * sizeof(float) * static_cast<double>(a.image.pixels.size()), "a heat map",
                   "leave -o away");
    PictureOptions options;
    options.view = View::raw;
    const LoadedPicture one = relative_to_white(a), other = relative_to_white(b);
    const Image heat = difference_heat(one.image, other.image, full_scale, one.alpha, other.alpha);
    write_output({"-o", path}, [&] { write_picture(path, heat, options); });
}

} // namespace

int diff_command(const Arguments& arguments, Console& console) {
    const std::string metric = arguments.text("metric").value_or("max");
    const double strictest = metric == "psnr" ? std::numeric_limits<double>::infinity() : 0;
    const double tolerance = arguments.number("tolerance").value_or(strictest);
    const auto heat = arguments.text("output");
    if (heat) {
        output_format(*heat);
        require_outputs(arguments.operands(), {{"-o", *heat}});
    }
    const LoadedPicture a = read_picture(arguments.operands()[0]);
    const LoadedPicture b = read_picture(arguments.operands()[1]);
    require_same_size(a.image, b.image);
    const Measures measures = measure(a, b);
    if (heat) write_heat(*heat, a, b, measures);
    // stdout is for the picture if that is written there.
    if (!console.quiet() && heat != "-") print_data(table(measures));
    return within(measures.comparison, metric, tolerance) ? exit_code::done : exit_code::differ;
}

} // namespace glint::cli
