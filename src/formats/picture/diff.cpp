// The comparison of `glint diff`.

#include "glint/picture_files.h"

namespace glint {

namespace {

std::string kind_name(int bits) {
    return bits == 32 ? "a float picture" : bits == 16 ? "a 16-bit picture" : "an 8-bit picture";
}

LoadedPicture scaled(LoadedPicture picture, float factor) {
    for (float& value : picture.image.pixels) value *= factor;
    for (float& value : picture.alpha) value *= factor;
    return picture;
}

Comparison compare_all(const LoadedPicture& a, const LoadedPicture& b, double tolerance, double peak) {
    return compare(a.image, b.image, tolerance, peak, a.alpha, b.alpha);
}

/// Compare in units of 1/65535, in which an 8-bit step is exactly 257.
Comparison compare_16_bit(const LoadedPicture& a, const LoadedPicture& b, double tolerance) {
    constexpr double steps = 257;
    const auto widened = [](const LoadedPicture& p) { return scaled(p, p.bits == 8 ? 257.0f : 1.0f); };
    Comparison comparison = compare_all(widened(a), widened(b), tolerance * steps, 65535);
    comparison.max /= steps;
    comparison.mae /= steps;
    comparison.rmse /= steps;
    return comparison;
}

} // namespace

PictureDifference diff_pictures(const LoadedPicture& a, const LoadedPicture& b, double tolerance) {
    if ((a.bits == 32) != (b.bits == 32))
        throw Error(ErrorKind::usage, "cannot compare " + kind_name(a.bits) + " with " + kind_name(b.bits),
                    "one holds codes on the sRGB curve, the other linear light: compare two PNG files, or "
                    "two of EXR and PFM");

    PictureDifference difference;
    difference.eight_bit = a.bits != 32;
    if (a.bits == 32)
        difference.comparison = compare_all(a, b, tolerance, 1);
    else if (a.bits == 8 && b.bits == 8)
        difference.comparison = compare_all(a, b, tolerance, 255);
    else
        difference.comparison = compare_16_bit(a, b, tolerance);
    return difference;
}

} // namespace glint
