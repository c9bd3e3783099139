// Parsing the command line.

#include "request.h"

#include "scene/text.h"

#include <functional>
#include <numeric>
#include <utility>

namespace glint::meshgen {
namespace {

const std::vector<std::pair<std::string, Kind>>& kinds() {
    static const std::vector<std::pair<std::string, Kind>> all{
        {"gyroid", Kind::gyroid}, {"knot", Kind::knot},           {"torus", Kind::torus},
        {"shell", Kind::shell},   {"icosphere", Kind::icosphere}, {"terrain", Kind::terrain},
        {"flake", Kind::flake},   {"city", Kind::city},           {"spiral", Kind::spiral}};
    return all;
}

constexpr const char* see_help = "see glint-meshgen --help";

[[noreturn]] void refuse(const std::string& message, const std::string& hint) {
    throw Error(ErrorKind::usage, message, hint);
}

Kind parse_kind(const std::string& word) {
    std::vector<std::string> names;
    for (const auto& [name, kind] : kinds()) {
        if (name == word) return kind;
        names.push_back(name);
    }
    refuse("there is no shape called '" + word + "'", did_you_mean(word, names, see_help));
}

int parse_count(const std::string& option, const std::string& text, int min, int max) {
    const auto value = scene::parse_number<int>(text);
    if (!value || *value < min || *value > max)
        refuse("'" + text + "' is no value for " + option,
               "expected a whole number from " + std::to_string(min) + " to " + std::to_string(max));
    return *value;
}

PlyFormat parse_format(const std::string& text) {
    if (text == "ascii") return PlyFormat::ascii;
    if (text == "binary") return PlyFormat::binary_little_endian;
    if (text == "big-endian") return PlyFormat::binary_big_endian;
    refuse("'" + text + "' is no value for --format", "expected ascii, binary or big-endian");
}

// An option with a value, and its action.
struct Option {
    std::string name;
    std::function<void(Request&, const std::string&)> set;
};

Option counted(const std::string& name, int min, int max, std::function<void(Request&, int)> set) {
    return {name, [=](Request& r, const std::string& text) { set(r, parse_count(name, text, min, max)); }};
}

const std::vector<Option>& options() {
    static const std::vector<Option> all{
        {"-o", [](Request& r, const std::string& text) { r.output = text; }},
        {"--format", [](Request& r, const std::string& text) { r.format = parse_format(text); }},
        counted("--triangles", 20, 20'000'000, [](Request& r, int n) { r.triangles = n; }),
        counted("-p", 1, 50, [](Request& r, int n) { r.p = n; }),
        counted("-q", 1, 50, [](Request& r, int n) { r.q = n; }),
        counted("--seed", 0, 1'000'000'000, [](Request& r, int n) { r.seed = static_cast<unsigned>(n); }),
        counted("--levels", 0, 7, [](Request& r, int n) { r.levels = n; }),
        counted("--rings", 1, 100, [](Request& r, int n) { r.rings = n; }),
        counted("--count", 1, 100'000, [](Request& r, int n) { r.count = n; })};
    return all;
}

// Reads the option at `i` with its value; returns the index of the next one.
std::size_t read_option(Request& request, const std::vector<std::string>& arguments, std::size_t i) {
    const std::string& word = arguments[i];
    if (word == "--colors" || word == "--flat") {
        (word == "--flat" ? request.flat : request.colors) = true;
        return i + 1;
    }
    std::vector<std::string> names{"--colors", "--flat"};
    for (const Option& option : options()) {
        names.push_back(option.name);
        if (option.name != word) continue;
        if (i + 1 == arguments.size()) refuse(word + " needs a value", see_help);
        option.set(request, arguments[i + 1]);
        return i + 2;
    }
    refuse("unknown option " + word, did_you_mean(word, names, see_help));
}

} // namespace

bool is_scene(Kind kind) { return kind == Kind::flake || kind == Kind::city || kind == Kind::spiral; }

std::optional<Request> parse_request(const std::vector<std::string>& arguments) {
    if (arguments.empty()) refuse("no shape given", "expected glint-meshgen SHAPE -o FILE; see --help");
    for (const std::string& word : arguments) {
        if (word == "--help" || word == "-h") return std::nullopt;
    }
    Request request;
    request.kind = parse_kind(arguments[0]);
    for (std::size_t i = 1; i < arguments.size();) i = read_option(request, arguments, i);
    if (!is_scene(request.kind) && request.output.empty()) refuse("no output given", "add -o FILE.ply");
    if (std::gcd(request.p, request.q) != 1)
        refuse("-p and -q have a common divisor: that is a link of several knots",
               "take coprime numbers, such as 2 and 3");
    return request;
}

} // namespace glint::meshgen
