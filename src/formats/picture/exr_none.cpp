// Replaces exr_read.cpp and exr_write.cpp in builds without OpenEXR.

#include "formats/picture/codecs.h"

namespace glint::formats {
namespace {

constexpr const char* cause = "this glint was built without OpenEXR";
constexpr const char* cure = "use .png or .pfm, or build with -DGLINT_EXR=ON";

} // namespace

std::vector<std::byte> encode_exr(const Image&, const PictureOptions&) {
    throw Error(ErrorKind::output, cause, cure);
}

LoadedPicture decode_exr(std::span<const std::byte>, const std::string& name) {
    refuse_picture(name, cause, cure);
}

} // namespace glint::formats
