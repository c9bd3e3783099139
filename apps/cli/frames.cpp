// Parses ranges of frames and patterns of file names.
#include "frames.h"

#include "glint/error.h"

#include <fmt/format.h>

#include <cstdlib>

namespace glint::cli {
namespace {

constexpr int max_frame_number = 1'000'000;

std::optional<int> frame_number(std::string_view text) {
    const auto number = whole_number(text);
    return number && std::abs(*number) <= max_frame_number ? std::optional(static_cast<int>(*number))
                                                           : std::nullopt;
}

/// A file name, split at its %d.
struct Pattern {
    std::string before;
    std::string after;
    bool numbered = false;
    std::size_t width = 0;
};

Pattern parse_pattern(const std::string& text) {
    Pattern pattern;
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::usage, fmt::format("\"{}\" {}", text, why),
                    "the frame's number goes where %d or %04d stands, once; %% is a percent sign");
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        std::string& part = pattern.numbered ? pattern.after : pattern.before;
        if (text[i] != '%' || text.compare(i, 2, "%%") == 0) {
            part += text[i];
            i += text[i] == '%' ? 1 : 0;
            continue;
        }
        const std::size_t end = text.find_first_not_of("0123456789", i + 1);
        const std::string digits = text.substr(i + 1, end == std::string::npos ? end : end - i - 1);
        const bool number = end != std::string::npos && text[end] == 'd';
        if (!number || (!digits.empty() && (digits[0] != '0' || digits.size() != 2)))
            refuse(fmt::format("has \"{}\", which is no frame's number",
                               text.substr(i, end == std::string::npos ? end : end - i + 1)));
        if (pattern.numbered) refuse("has the frame's number twice");
        pattern.numbered = true;
        pattern.width = digits.empty() ? 0 : static_cast<std::size_t>(digits[1] - '0');
        i = end;
    }
    return pattern;
}

} // namespace

std::vector<int> FrameRange::of(const Animation& animation) const {
    std::vector<int> frames;
    for (int frame = all ? animation.first : first; frame <= (all ? animation.last : last); frame += step)
        frames.push_back(frame);
    return frames;
}

std::optional<FrameRange> frame_range(const Arguments& arguments) {
    const auto given = arguments.text("frames");
    if (!given) return std::nullopt;
    if (*given == "all") return FrameRange{true, 0, 0, 1};
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::usage, fmt::format("--frames \"{}\" {}", *given, why),
                    "expected FIRST..LAST such as 0..119, FIRST..LAST:STEP, one frame, or all");
    };
    const std::size_t colon = given->find(':');
    const std::string range = given->substr(0, colon);
    const std::size_t dots = range.find("..");
    const auto first = frame_number(std::string_view(range).substr(0, dots));
    const auto last =
        dots == std::string::npos ? first : frame_number(std::string_view(range).substr(dots + 2));
    const auto step =
        colon == std::string::npos ? 1 : frame_number(std::string_view(*given).substr(colon + 1));
    if (!first || !last || !step) refuse("is no range of frames");
    if (*last < *first) refuse("ends before it begins");
    if (*step < 1) refuse("needs a step of at least 1");
    return FrameRange{false, *first, *last, *step};
}

std::string frame_name(const std::string& pattern, int frame) {
    const Pattern parts = parse_pattern(pattern);
    return parts.before + (parts.numbered ? fmt::format("{:0{}}", frame, parts.width) : "") + parts.after;
}

bool has_frame_number(const std::string& pattern) { return parse_pattern(pattern).numbered; }

SceneDescription at_frame(const Arguments& arguments, const LoadedScene& loaded) {
    const auto frame = arguments.integer("frame", -max_frame_number, max_frame_number);
    return frame ? scene_at(loaded, static_cast<double>(*frame)) : loaded.description;
}

} // namespace glint::cli
