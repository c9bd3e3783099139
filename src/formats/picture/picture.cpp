// Reading and writing pictures of any format.

#include "formats/picture/codecs.h"
#include "formats/read_bytes.h"
#include "formats/read_text.h"
#include "glint/limits.h"

#include <algorithm>
#include <filesystem>
#include <new>
#include <string_view>
#include <system_error>

namespace glint::formats {

namespace {

[[noreturn]] void refuse_arguments(const std::string& message, const std::string& hint) {
    throw Error(ErrorKind::usage, message, hint);
}

PictureFormat require_format(const std::string& path) {
    if (const auto format = picture_format(path)) return *format;
    const std::string extension = lower_extension(path);
    const std::string found = extension.empty() ? "has no extension" : "ends in '" + extension + "'";
    refuse_arguments("the picture's name '" + path + "' " + found, "pictures end in .png, .exr or .pfm");
}

void check_image(const Image& image, const std::string& what) {
    const bool sides = image.width >= 1 && image.height >= 1 && image.width <= picture_side_limit &&
                       image.height <= picture_side_limit;
    if (!sides || std::int64_t{image.width} * image.height > picture_pixel_limit)
        refuse_arguments(what + " has " + size_text(image.width, image.height) + " pixels",
                         "a picture has 1 to 65,536 pixels a side, at most 2^30 in all");
    const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    if (image.pixels.size() != 3 * pixels)
        refuse_arguments(what + " holds " + std::to_string(image.pixels.size()) + " values",
                         size_text(image.width, image.height) + " RGB pixels have " +
                             std::to_string(3 * pixels));
}

void check_layers(const Image& image, const std::vector<Layer>& layers) {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const Layer& layer = layers[i];
        if (layer.name.empty()) refuse_arguments("a layer has no name", "name every layer");
        const auto same_name = [&](const Layer& other) { return other.name == layer.name; };
        if (std::count_if(layers.begin(), layers.end(), same_name) > 1)
            refuse_arguments("two layers have the name '" + layer.name + "'",
                             "give each layer a name of its own");
        check_image(layer.image, "the layer '" + layer.name + "'");
        if (layer.image.width != image.width || layer.image.height != image.height)
            refuse_arguments("the layer '" + layer.name + "' has another size than the picture",
                             "layers have the picture's " + size_text(image.width, image.height) + " pixels");
    }
}

void check_options(const Image& image, const PictureOptions& options) {
    if (options.bits != 8 && options.bits != 16)
        refuse_arguments("a picture of " + std::to_string(options.bits) + " bits", "PNG has 8 or 16 bits");
    check_image(image, "the picture");
    check_layers(image, options.layers);
    if (!options.alpha.empty() && options.alpha.size() * 3 != image.pixels.size())
        refuse_arguments("alpha holds " + std::to_string(options.alpha.size()) + " values",
                         size_text(image.width, image.height) + " pixels have one each");
    const bool part = options.full_width > 0 || options.full_height > 0;
    if (part && (options.x < 0 || options.y < 0 || options.x + image.width > options.full_width ||
                 options.y + image.height > options.full_height))
        refuse_arguments("the picture does not lie within the whole of which it is a part",
                         "the whole has " + size_text(options.full_width, options.full_height) + " pixels");
    for (const auto& [key, value] : options.metadata)
        if (key.empty())
            refuse_arguments("a piece of metadata has no name ('" + value + "')", "name every piece");
}

} // namespace

std::string size_text(std::int64_t width, std::int64_t height) {
    return std::to_string(width) + " x " + std::to_string(height);
}

void refuse_picture(const std::string& name, const std::string& message, const std::string& hint,
                    std::optional<std::uint64_t> byte) {
    throw Error(ErrorKind::input, message, hint, {.file = name, .byte = byte});
}

void check_picture_size(const std::string& name, std::int64_t width, std::int64_t height) {
    const bool sides =
        width >= 1 && height >= 1 && width <= picture_side_limit && height <= picture_side_limit;
    if (!sides || width * height > picture_pixel_limit)
        refuse_picture(name, "the picture claims a size of " + size_text(width, height) + " pixels",
                       "a picture has 1 to 65,536 pixels a side, at most 2^30 in all");
}

void require_picture_memory(const std::string& name, std::int64_t width, std::int64_t height,
                            std::size_t pixel_bytes, double more) {
    const double bytes = static_cast<double>(width) * static_cast<double>(height) * double(pixel_bytes);
    require_memory(bytes + more, "a picture of " + size_text(width, height) + " pixels",
                   "make it smaller first", {.file = name});
}

std::size_t channel_bytes(const Image& image, const PictureOptions& options) {
    std::size_t floats = image.pixels.size() + options.alpha.size();
    for (const Layer& layer : options.layers) floats += layer.image.pixels.size();
    return floats * sizeof(float);
}

namespace {

using Decoder = LoadedPicture (*)(std::span<const std::byte>, const std::string&);

/// The decoder of a file that begins with these bytes.
Decoder decoder_of(std::span<const std::byte> bytes, const std::string& name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with("\x89PNG")) return decode_png;
    if (text.starts_with("\x76\x2f\x31\x01")) return decode_exr;
    if (text.starts_with("PF") || text.starts_with("Pf")) return decode_pfm;
    refuse_compressed(text, name);
    if (bytes.empty()) refuse_picture(name, "the file is empty", "write or copy it again");
    refuse_picture(name, "this is no picture in PNG, EXR or PFM", "convert it to one of these first", 0);
}

} // namespace

LoadedPicture decode_picture(std::span<const std::byte> bytes, const std::string& name) {
    return decoder_of(bytes, name)(bytes, name);
}

} // namespace glint::formats

namespace glint {

namespace fs = std::filesystem;

std::optional<PictureFormat> picture_format(const std::string& path) {
    if (path == "-") return PictureFormat::png;
    const std::string extension = formats::lower_extension(path);
    if (!extension.empty()) return value_named<PictureFormat>(extension.substr(1));
    std::error_code none;
    if (formats::special_file(fs::status(path, none))) return PictureFormat::png;
    return std::nullopt;
}

void check_picture_target(const std::string& path, bool with_alpha, bool with_layers) {
    const PictureFormat format = formats::require_format(path);
    if (with_layers && format != PictureFormat::exr)
        formats::refuse_arguments("'" + path + "' cannot hold layers", "layers are written to .exr");
    if (with_alpha && format == PictureFormat::pfm)
        formats::refuse_arguments("'" + path + "' cannot hold alpha", "alpha is written to .png and .exr");
    if (path != "-") check_writable(path);
}

void write_picture(const std::string& path, const Image& image, const PictureOptions& options) {
    formats::check_options(image, options);
    check_picture_target(path, !options.alpha.empty(), !options.layers.empty());
    switch (formats::require_format(path)) {
    case PictureFormat::pfm:
        return formats::write_pieces(path, formats::PfmFile(image).pieces());
    case PictureFormat::exr:
        return write_file(path, formats::encode_exr(image, options));
    case PictureFormat::png:
        break;
    }
    const std::vector<std::byte> bytes = formats::encode_png(image, options);
    if (path == "-")
        formats::write_stdout(bytes);
    else
        write_file(path, bytes);
}

LoadedPicture read_picture(const std::string& path) {
    try {
        std::error_code none;
        if (const fs::file_status status = fs::status(path, none);
            fs::is_character_file(status) || fs::is_block_file(status))
            formats::refuse_picture(path, "this is a device, not a picture", "name a file");
        formats::InputFile file(path);
        const auto check_start = [&](std::span<const std::byte> bytes) { formats::decoder_of(bytes, path); };
        return formats::decode_picture(formats::read_bytes(file, {}, check_start), path);
    } catch (const std::bad_alloc&) {
        throw Error(ErrorKind::resource, "not enough memory to read the picture", "close other programs",
                    {.file = path});
    }
}

} // namespace glint
