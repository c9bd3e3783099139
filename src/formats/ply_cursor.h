#pragma once
// Two ways to take values from the body of a PLY file, with one face to the reader: bytes and text.
//
// Both check every step against the end of the file and throw Error(input) with the place. Rows and
// properties are named in messages by the element and row given to begin_row().

#include "formats/ply_header.h"

#include <bit>
#include <cstdint>
#include <cstring>

namespace glint::ply {

/// "face 3": a row for a message, counted from 0 as vertex indices are.
std::string row_name(const Element& element, std::uint64_t row);

/// Values as bytes in the given order.
template <std::endian order>
class BinaryCursor {
  public:
    BinaryCursor(const Source& source, std::size_t offset) : source_(source), at_(offset) {}

    /// The fewest bytes that a value can take, and how many bytes are left for values.
    static std::size_t least_bytes(Type type) { return size_of(type); }
    std::size_t room() const { return source_.size() - at_; }
    /// Where the value taken last begins.
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

    /// Calls visit(value) for each of the next values of an integer type.
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
        if (count > room() / size_of(type)) fail_cut();
        at_ += static_cast<std::size_t>(count) * size_of(type);
    }

    /// How many bytes follow the last row.
    std::size_t trailing() const { return room(); }

    [[noreturn]] void fail(std::size_t offset, std::string message, std::string hint) const {
        source_.fail_at_byte(offset, std::move(message), std::move(hint));
    }
    /// Where to point when the header promises more than the file holds.
    std::size_t promise_offset(const Element&) const { return source_.size(); }

  private:
    template <class Bits>
    Bits take() {
        if (room() < sizeof(Bits)) fail_cut();
        value_ = at_;
        at_ += sizeof(Bits);
        const char* bytes = source_.text().data() + value_;
        Bits bits;
        std::memcpy(&bits, bytes, sizeof bits);
        if constexpr (order == std::endian::native) return bits;
        std::uint64_t turned = 0;
        for (std::size_t i = 0; i < sizeof(Bits); ++i) turned = turned << 8 | (bits >> 8 * i & 0xff);
        return static_cast<Bits>(turned);
    }

    template <class Bits, class Value, class Visit>
    void take_each(std::uint64_t count, Visit& visit) {
        for (std::uint64_t i = 0; i < count; ++i)
            visit(static_cast<std::int64_t>(static_cast<Value>(take<Bits>())));
    }

    [[noreturn]] void fail_cut() const {
        fail(source_.size(), "the file ends within " + row_name(*element_, row_),
             "its header promises " + std::to_string(element_->count) + "; the file seems to be cut");
    }

    const Source& source_;
    std::size_t at_;
    std::size_t value_ = 0;
    const Element* element_ = nullptr;
    std::uint64_t row_ = 0;
};

/// Values as words. A row begins on a line of its own and may go on over further lines; lines that are blank
/// or begin with `comment` or `obj_info` may stand between rows. Numbers are read the same in every locale.
class TextCursor {
  public:
    TextCursor(const Source& source, std::size_t offset)
        : source_(source), text_(source.text()), at_(offset) {}

    /// A digit and what parts it from the next value; the last value needs no such thing.
    static std::size_t least_bytes(Type) { return 2; }
    std::size_t room() const { return text_.size() - at_ + 1; }
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
    std::size_t promise_offset(const Element& element) const { return element.count_offset; }

  private:
    void skip_to_row();
    std::string_view take_word();

    const Source& source_;
    std::string_view text_;
    std::size_t at_;
    std::size_t value_ = 0;
    std::size_t row_begin_ = 0;
    const Element* element_ = nullptr;
    std::uint64_t row_ = 0;
};

} // namespace glint::ply
