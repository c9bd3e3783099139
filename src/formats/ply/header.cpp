// Parsing the header, with suggestions for misspelt names.

#include "formats/ply/header.h"

#include "scene/text.h"

#include <algorithm>
#include <iterator>
#include <set>

namespace glint::formats::ply {
namespace {

/// Two names of each type, in the order of Type.
constexpr std::string_view type_names[] = {"char",  "uchar",  "short",   "ushort", "int",   "uint",
                                           "float", "double", "int8",    "uint8",  "int16", "uint16",
                                           "int32", "uint32", "float32", "float64"};
constexpr std::size_t type_count = std::size(type_names) / 2;

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// A hint on the format of a file that is not PLY.
std::string other_kind(std::string_view text) {
    if (text.empty()) return "the file is empty";
    if (text.starts_with("\xff\xfe") || text.starts_with("\xfe\xff")) return "this one is UTF-16 text";
    if (text.starts_with("solid")) return "this one looks like STL";
    if (text.starts_with("glTF")) return "this one looks like glTF";
    return "a PLY file begins with a line that says 'ply'";
}

class HeaderParser {
  public:
    explicit HeaderParser(const Source& source) : source_(source), text_(source.text()) {}

    Header parse() {
        read_magic();
        while (true) {
            next_line();
            if (words_.empty() || words_[0] == "comment" || words_[0] == "obj_info") continue;
            if (words_[0] == "end_header") break;
            read_declaration();
        }
        expect_words(1, "end_header");
        if (!has_format_)
            fail(words_[0], "the header has no format line",
                 "expected 'format ascii 1.0' or a binary one after 'ply'");
        header_.end_header = source_.offset(words_[0]);
        header_.body = next_;
        return std::move(header_);
    }

  private:
    static constexpr std::size_t max_words = 6; // one more than the longest valid line has

    void read_magic() {
        if (text_.starts_with(byte_order_mark)) next_ = byte_order_mark.size();
        const std::string_view rest = text_.substr(next_);
        const std::size_t end = rest.find_first_not_of(" \t", 3);
        const bool is_ply =
            rest.starts_with("ply") && (end == rest.npos || rest[end] == '\r' || rest[end] == '\n');
        if (!is_ply) source_.fail_in_text(0, "this is not a PLY file", other_kind(rest));

        // If lines end in CR alone, a body that begins with the byte of LF must not lose it.
        cr_only_ = end != rest.npos && rest[end] == '\r' && rest.substr(end + 1, 1) != "\n";
        next_line();
    }

    /// Splits the next line into words, at most max_words.
    void next_line() {
        if (next_ >= text_.size())
            source_.fail_in_text(text_.size(), "the file ends within its header",
                                 "a header is closed by a line that says 'end_header'");
        const std::size_t end = std::min(text_.find_first_of("\r\n", next_), text_.size());
        std::string_view line = text_.substr(next_, end - next_);
        next_ = std::min(end + 1, text_.size());
        const bool crlf =
            end < text_.size() && text_[end] == '\r' && next_ < text_.size() && text_[next_] == '\n';
        if (crlf && !cr_only_) ++next_;

        words_.clear();
        while (words_.size() < max_words) {
            const std::size_t begin = line.find_first_not_of(" \t\v\f");
            if (begin == line.npos) break;
            line.remove_prefix(begin);
            words_.push_back(line.substr(0, line.find_first_of(" \t\v\f")));
            line.remove_prefix(words_.back().size());
        }
    }

    [[noreturn]] void fail(std::string_view word, std::string message, std::string hint) const {
        source_.fail_in_text(source_.offset(word), std::move(message), std::move(hint));
    }

    void expect_words(std::size_t count, const char* form) const {
        if (words_.size() < count) {
            const std::size_t end = source_.offset(words_.back()) + words_.back().size();
            source_.fail_in_text(end, "this header line is too short", std::string("expected: ") + form);
        }
        if (words_.size() > count)
            fail(words_[count], "unexpected " + quoted_word(words_[count]) + " in the header",
                 std::string("expected: ") + form);
    }

    void read_declaration() {
        if (words_[0] == "format") return read_format();
        if (words_[0] == "element") return read_element();
        if (words_[0] == "property") return read_property();
        fail(words_[0], "unknown header line " + quoted_word(words_[0]),
             suggestion(words_[0], {"format", "comment", "obj_info", "element", "property", "end_header"},
                        "expected format, element, property, comment, obj_info or end_header"));
    }

    void read_format() {
        expect_words(3, "format ascii|binary_little_endian|binary_big_endian 1.0");
        if (has_format_) fail(words_[0], "the header has a second format line", "remove one of them");
        const auto format = value_named<PlyFormat>(words_[1]);
        if (!format)
            fail(words_[1], "unknown format " + quoted_word(words_[1]),
                 suggestion(words_[1], {enum_names<PlyFormat>.begin(), enum_names<PlyFormat>.end()},
                            "expected ascii, binary_little_endian or binary_big_endian"));
        if (words_[2] != "1.0")
            fail(words_[2], "unknown PLY version " + quoted_word(words_[2]), "the only one is 1.0");
        header_.format = *format;
        has_format_ = true;
    }

    void read_element() {
        expect_words(3, "element NAME COUNT");
        const std::string_view digits = words_[2];
        const auto count = scene::parse_number<std::uint64_t>(digits);
        if (!count)
            fail(digits, quoted_word(digits) + " is not a number of elements",
                 "expected a whole number, 0 or more");
        header_.elements.push_back(
            {std::string(words_[1]), *count, source_.offset(words_[1]), source_.offset(digits), {}});
        names_in_element_.clear();
    }

    void read_property() {
        if (header_.elements.empty())
            fail(words_[0], "a property stands before any element",
                 "put an 'element NAME COUNT' line before it");
        Property property;
        const bool is_list = words_.size() > 1 && words_[1] == "list";
        if (is_list) {
            expect_words(5, "property list COUNT_TYPE TYPE NAME");
            property.count_type = parse_type(words_[2]);
            if (!is_integer(*property.count_type))
                fail(words_[2], "a list cannot be counted in " + quoted_word(words_[2]),
                     "expected an integer type, such as uchar");
        } else {
            expect_words(3, "property TYPE NAME");
        }
        const std::string_view type = words_[words_.size() - 2];
        const std::string_view name = words_.back();
        property.type = parse_type(type);
        property.type_offset = source_.offset(type);
        property.name = name;
        property.offset = source_.offset(name);
        Element& element = header_.elements.back();
        if (!names_in_element_.insert(name).second)
            fail(name, "element " + quoted_word(element.name) + " has a second property " + quoted_word(name),
                 "names of properties must differ");
        element.properties.push_back(std::move(property));
    }

    Type parse_type(std::string_view word) const {
        const auto found = std::find(std::begin(type_names), std::end(type_names), word);
        if (found != std::end(type_names))
            return static_cast<Type>(static_cast<std::size_t>(found - std::begin(type_names)) % type_count);
        fail(word, "unknown type " + quoted_word(word),
             suggestion(word, {std::begin(type_names), std::end(type_names)},
                        "expected char, uchar, short, ushort, int, uint, float or double"));
    }

    const Source& source_;
    std::string_view text_;
    std::size_t next_ = 0; ///< offset of the next line
    std::vector<std::string_view> words_;
    std::set<std::string_view> names_in_element_;
    bool cr_only_ = false;
    bool has_format_ = false;
    Header header_;
};

} // namespace

const char* type_name(Type type) { return type_names[static_cast<std::size_t>(type)].data(); }

Header parse_header(const Source& source) { return HeaderParser(source).parse(); }

} // namespace glint::formats::ply
