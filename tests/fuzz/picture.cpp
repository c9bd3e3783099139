// PNG, EXR and PFM pictures.

#include "fuzz.h"

#include "formats/picture/codecs.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace glint;
    return test::accept_or_refuse([&] { formats::decode_picture(test::bytes_of(data, size), "fuzz"); });
}
