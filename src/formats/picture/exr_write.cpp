// Writing EXR files with OpenEXR.

#include "formats/picture/codecs.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <array>

namespace glint::formats {

namespace {

/// OpenEXR's output stream to memory. OpenEXR seeks back to fill in the table of row offsets.
class MemoryOutput : public Imf::OStream {
  public:
    MemoryOutput() : Imf::OStream("memory") {}

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
                 std::size_t step, int width) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    char* base = reinterpret_cast<char*>(const_cast<float*>(first));
    const std::size_t stride = step * sizeof(float);
    buffer.insert(name, Imf::Slice(Imf::FLOAT, base, stride, stride * static_cast<std::size_t>(width)));
}

void add_image(Imf::Header& header, Imf::FrameBuffer& buffer, const std::string& prefix, const Image& image) {
    static constexpr std::array channels{"R", "G", "B"};
    for (std::size_t i = 0; i < channels.size(); ++i)
        add_channel(header, buffer, prefix + channels[i], image.pixels.data() + i, 3, image.width);
}

std::vector<std::byte> encode(const Image& image, const PictureOptions& options) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    // The prefix, which glint's own keys have, avoids clashes with attributes that OpenEXR defines.
    for (const auto& [key, value] : options.metadata)
        header.insert(key.starts_with("glint.") ? key : "glint." + key, Imf::StringAttribute(value));

    Imf::FrameBuffer buffer;
    add_image(header, buffer, "", image);
    if (!options.alpha.empty()) add_channel(header, buffer, "A", options.alpha.data(), 1, image.width);
    for (const Layer& layer : options.layers) add_image(header, buffer, layer.name + ".", layer.image);

    MemoryOutput out;
    {
        // No OpenEXR threads. The destructor completes the file.
        Imf::OutputFile file(out, header, 0);
        file.setFrameBuffer(buffer);
        file.writePixels(image.height);
    }
    return out.take();
}

} // namespace

std::vector<std::byte> encode_exr(const Image& image, const PictureOptions& options) {
    try {
        return encode(image, options);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error(ErrorKind::internal, std::string("cannot encode the EXR: ") + problem.what());
    }
}

} // namespace glint::formats
