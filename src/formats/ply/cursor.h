#pragma once
// Cursors over the body of a PLY file with a common interface: bytes and text.
//
// Both check every step against the end of the file and throw Error(input) with the location. Messages name
// rows and properties by the element and row given to begin_row().

#include "formats/ply/header.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace glint::formats::ply {

/// Name of a row for messages, such as "face 3", counted from 0 like vertex indices.
std::string row_name(const Element& element, std::uint64_t row);

/// Reads binary values in the given byte order.
template <std::endian order>
class BinaryCursor {
  public:
    BinaryCursor(const Source& source, std::size_t offset) : source_(source), at_(offset) {}

    /// Minimum size of a value, and number of bytes left.
    static std::size_t min_bytes(Type type) { return size_of(type); }
    std::size_t remaining() const { return source_.size() - at_; }
    /// Offset of the last value read.
    std::size_t value_offset() const { return value_; }

    void begin_row(const Element& element, std::uint64_t row) {
        element_ = &element;
        row_ = row;
    }
    void end_row() {}

    double number(Type type) {
        if (type == Type::float32) return static_cast<double>(std::bit_cast<float>(take<std::uint32_t>()));
        if (type == Type::float64) return std::bit_cast<double>(take<std::uint64_t>());
        return static_cast<double>(integer(type));
    }

    /// `type` must be an integer type.
    std::int64_t integer(Type type) {
        std::int64_t value = 0;
        integers(type, 1, [&](std::int64_t taken) { value = taken; });
        return value;
    }

    /// Calls visit(value) for each of the next `count` values of an integer type.
    template <class Visit>
    void integers(Type type, std::uint64_t count, Visit visit) {
        switch (type) {
        case Type::int8:
            return take_each<std::uint8_t, std::int8_t>(count, visit);
        case Type::uint8:
            return take_each<std::uint8_t, std::uint8_t>(count, visit);
        case Type::int16:
            return take_each<std::uint16_t, std::int16_t>(count, visit);
        case Type::uint16:
            return take_each<std::uint16_t, std::uint16_t>(count, visit);
        case Type::int32:
            return take_each<std::uint32_t, std::int32_t>(count, visit);
        default:
            return take_each<std::uint32_t, std::uint32_t>(count, visit);
        }
    }

    void skip(Type type, std::uint64_t count = 1) {
        if (count > remaining() / size_of(type)) fail_truncated();
        at_ += static_cast<std::size_t>(count) * size_of(type);
    }

    /// Number of bytes after the last row.
    std::size_t trailing() const { return remaining(); }

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint) const {
        source_.fail_at_byte(offset, std::move(message), std::move(hint));
    }
    /// Location for the error that the header declares more rows than the file contains.
    std::size_t count_error_offset(const Element&) const { return source_.size(); }

  private:
    template <class Bits>
    Bits take() {
        if (remaining() < sizeof(Bits)) fail_truncated();
        value_ = at_;
        at_ += sizeof(Bits);
        const char* bytes = source_.text().data() + value_;
        Bits bits;
        std::memcpy(&bits, bytes, sizeof bits);
        if constexpr (order == std::endian::native) return bits;
        std::uint64_t swapped = 0;
        for (std::size_t i = 0; i < sizeof(Bits); ++i) swapped = swapped << 8 | (bits >> 8 * i & 0xff);
        return static_cast<Bits>(swapped);
    }

    template <class Bits, class Value, class Visit>
    void take_each(std::uint64_t count, Visit& visit) {
        for (std::uint64_t i = 0; i < count; ++i)
            visit(static_cast<std::int64_t>(static_cast<Value>(take<Bits>())));
    }

    [[noreturn]] void fail_truncated() const {
        fail(source_.size(), "the file ends within " + row_name(*element_, row_),
             "its header promises " + std::to_string(element_->count) + "; the file seems to be cut");
    }

    const Source& source_;
    std::size_t at_;
    std::size_t value_ = 0;
    const Element* element_ = nullptr;
    std::uint64_t row_ = 0;
};

/// Reads values as words. A row starts on a new line and may continue on further lines; blank lines and lines
/// starting with `comment` or `obj_info` may appear between rows. Parsing does not depend on the locale.
class TextCursor {
  public:
    TextCursor(const Source& source, std::size_t offset)
        : source_(source), text_(source.text()), at_(offset) {}

    /// One digit and a separator; the last value of a file needs no separator.
    static std::size_t min_bytes(Type) { return 2; }
    std::size_t remaining() const { return text_.size() - at_ + 1; }
    std::size_t value_offset() const { return value_; }

    void begin_row(const Element& element, std::uint64_t row);
    void end_row();
    double number(Type type);
    std::int64_t integer(Type type);
    template <class Visit>
    void integers(Type type, std::uint64_t count, Visit visit) {
        for (std::uint64_t i = 0; i < count; ++i) visit(integer(type));
    }
    void skip(Type type, std::uint64_t count = 1);
    std::size_t trailing();

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint) const {
        source_.fail_in_text(offset, std::move(message), std::move(hint));
    }
    std::size_t count_error_offset(const Element& element) const { return element.count_offset; }

  private:
    void skip_to_row();
    std::string_view next_word();

    const Source& source_;
    std::string_view text_;
    std::size_t at_;
    std::size_t value_ = 0;
    std::size_t row_begin_ = 0;
    const Element* element_ = nullptr;
    std::uint64_t row_ = 0;
};

} // namespace glint::formats::ply
