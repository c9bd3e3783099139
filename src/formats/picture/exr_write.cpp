// Writing EXR files with OpenEXR.

#include "formats/picture/codecs.h"
#include "formats/picture/exr_header.h"
#include "formats/picture/exr_twice.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>
#include <new>

namespace glint::formats {

namespace {

/// OpenEXR's output stream to memory. OpenEXR seeks back to fill in the table of row offsets.
class MemoryOutput : public Imf::OStream {
  public:
    /// `expected`: room that growing need not copy.
    explicit MemoryOutput(std::size_t expected) : Imf::OStream("memory") { bytes_.reserve(expected); }

    void write(const char* data, int size) override {
        const auto count = static_cast<std::size_t>(size);
        if (at_ + count > bytes_.size()) bytes_.resize(at_ + count);
        const auto* first = reinterpret_cast<const std::byte*>(data);
        std::copy(first, first + count, bytes_.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ += count;
    }
    std::uint64_t tellp() override { return at_; }
    void seekp(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }

    std::vector<std::byte> take() { return std::move(bytes_); }

  private:
    std::vector<std::byte> bytes_;
    std::size_t at_ = 0;
};

/// Adds a float channel with its memory layout. OpenEXR only reads through the pointer.
void add_channel(Imf::Header& header, Imf::FrameBuffer& buffer, const std::string& name, const float* first,
                 std::size_t step) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    const std::size_t stride = step * sizeof(float);
    const Imath::Box2i& window = header.dataWindow();
    const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    buffer.insert(name, Imf::Slice::Make(Imf::FLOAT, first, window, stride, stride * width));
}

void add_image(Imf::Header& header, Imf::FrameBuffer& buffer, const std::string& prefix, const Image& image) {
    static constexpr std::array channels{"R", "G", "B"};
    for (std::size_t i = 0; i < channels.size(); ++i)
        add_channel(header, buffer, prefix + channels[i], image.pixels.data() + i, 3);
}

/// The full picture is the display window, the image in it the data window.
Imf::Header header_of(const Image& image, const PictureOptions& options) {
    const int width = options.full_width > 0 ? options.full_width : image.width;
    const int height = options.full_height > 0 ? options.full_height : image.height;
    const Imath::V2i first(options.x, options.y);
    return {Imath::Box2i({0, 0}, {width - 1, height - 1}),
            Imath::Box2i(first, first + Imath::V2i(image.width - 1, image.height - 1))};
}

std::vector<std::byte> encode(const Image& image, const PictureOptions& options) {
    Imf::Header header = header_of(image, options);
    header.compression() = Imf::ZIP_COMPRESSION;
    // The prefix, which glint's own keys have, avoids clashes with attributes that OpenEXR defines.
    for (const auto& [key, value] : options.metadata)
        header.insert(key.starts_with("glint.") ? key : "glint." + key, Imf::StringAttribute(value));

    Imf::FrameBuffer buffer;
    add_image(header, buffer, "", image);
    if (!options.alpha.empty()) add_channel(header, buffer, "A", options.alpha.data(), 1);
    for (const Layer& layer : options.layers) add_image(header, buffer, layer.name + ".", layer.image);

    // Rows that do not get smaller are stored as they are.
    MemoryOutput out(channel_bytes(image, options) + (std::size_t{1} << 16U));
    {
        // No OpenEXR threads. The destructor completes the file.
        Imf::OutputFile file(out, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    std::vector<std::byte> bytes = out.take();
    if (!has_all_blocks(bytes)) throw std::bad_alloc();
    return bytes;
}

} // namespace

std::vector<std::byte> encode_exr(const Image& image, const PictureOptions& options) {
    try {
        return twice([&] { return encode(image, options); });
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error(ErrorKind::internal, std::string("cannot encode the EXR: ") + problem.what());
    }
}

} // namespace glint::formats
