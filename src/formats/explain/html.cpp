// The interactive HTML page.

#include "formats/explain/formula.h"
#include "formats/explain/markup.h"
#include "formats/explain/page.h"
#include "formats/picture/codecs.h"
#include "glint/explanation_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <span>
#include <utility>
#include <vector>

namespace glint {
namespace {

std::string base64(std::span<const std::byte> bytes) {
    static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t n = std::min<std::size_t>(3, bytes.size() - i);
        unsigned word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < n ? std::to_integer<unsigned>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k) out += k <= n ? digits[word >> (18 - 6 * k) & 63u] : '=';
    }
    return out;
}

/// The cell of the grid that is shown first.
PixelCoord first_cell(const ExplanationPage& page) {
    if (!page.pixel) return {page.columns / 2, page.rows / 2};
    return {page.pixel->x * page.columns / page.image.width, page.pixel->y * page.rows / page.image.height};
}

/// The pixels of one grid row.
std::vector<PixelCoord> grid_row(const ExplanationPage& page, int row) {
    std::vector<PixelCoord> all;
    for (int column = 0; column < page.columns; ++column)
        all.push_back({(2 * column + 1) * page.image.width / (2 * page.columns),
                       (2 * row + 1) * page.image.height / (2 * page.rows)});
    const PixelCoord first = first_cell(page);
    if (page.pixel && first.y == row) all[static_cast<std::size_t>(first.x)] = *page.pixel;
    return all;
}

/// The first cell, and with it the pixel that was asked for, if any.
std::string first_of(const ExplanationPage& page) {
    const auto pair = [](const PixelCoord& at) {
        return "[" + std::to_string(at.x) + "," + std::to_string(at.y) + "]";
    };
    return "\"first\":" + pair(first_cell(page)) + ",\"pixel\":" + (page.pixel ? pair(*page.pixel) : "null");
}

std::string picture(const std::string& id, const Image& image) {
    return "<img id=\"" + id + "\" alt=\"\" hidden src=\"data:image/png;base64," +
           base64(formats::encode_png(image, {})) + "\">\n";
}

bool is_black(const Image& image) {
    return std::all_of(image.pixels.begin(), image.pixels.end(), [](float x) { return x == 0.0f; });
}

/// The non-zero terms; the clamp is shown as a positive value.
std::string layers(const std::array<Image, term_count>& terms) {
    std::string out;
    for (int i = 0; i < term_count; ++i) {
        Image image = terms[static_cast<std::size_t>(i)];
        if (is_black(image)) continue;
        const auto term = static_cast<Term>(i);
        if (term == Term::clamp)
            for (float& x : image.pixels) x = -x;
        out += picture(std::string("png-") + term_name(term), image);
    }
    return out;
}

/// Description of the backend, and the difference of the graphics card.
std::string backends(const ExplanationPage& page) {
    const std::string own = "The numbers are the CPU's. ";
    if (page.gpu.empty()) return own;
    const std::size_t pixels = page.image.pixels.size() / 3;
    const Comparison found = compare(page.gpu_image, page.image, 1.0 / 255, 1);
    char figures[128];
    std::snprintf(figures, sizeof figures,
                  "%.0f of %zu pixels are off by more than 1/255, the furthest by %.3g. ",
                  found.share * static_cast<double>(pixels), pixels, found.max);
    return own + "On " + formats::escape_markup(page.gpu) + " " + figures;
}

/// The card's values at the grid pixels.
std::string gpu_of(const ExplanationPage& page) {
    if (page.gpu.empty()) return "null";
    nlohmann::json colors = nlohmann::json::array();
    for (int row = 0; row < page.rows; ++row)
        for (const auto& [x, y] : grid_row(page, row)) {
            const float* pixel = page.gpu_image.at(x, y);
            for (int channel = 0; channel < 3; ++channel) colors.push_back(pixel[channel]);
        }
    return "{\"device\":" + formats::json_text(page.gpu) + ",\"colors\":" + colors.dump() + "}";
}

std::string before_data(const ExplanationPage& page) {
    const std::string title = formats::escape_markup(page.scene);
    return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
           "style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n"
           "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
           title + ", explained</title>\n<style>\n" + std::string(formats::page_style()) +
           "</style></head><body>\n<div id=\"left\"><h1>" + title +
           "</h1>\n<div id=\"picture\"><canvas id=\"canvas\"></canvas><div id=\"mark\"></div></div>\n"
           "<div id=\"layers\"></div>\n<div class=\"note\">"
           "Move over the picture: the rays of the pixel are shown beside it. Click to keep a pixel; "
           "<kbd>←</kbd> <kbd>→</kbd> <kbd>↑</kbd> <kbd>↓</kbd> step from pixel to pixel. "
           "Switch the terms off and on to see what each adds. " +
           std::to_string(page.columns) + "×" + std::to_string(page.rows) + " pixels. " + backends(page) +
           "</div></div>\n"
           "<div id=\"tree\"><div id=\"pixel\"></div><div id=\"rays\"></div></div>\n" +
           picture("final", page.image) + layers(page.terms) + "<script id=\"data\" type=\"text/plain\">";
}

/// How samples are combined, and what positions are relative to.
std::string rule_of(const Explanation& any) {
    const std::string rule = any.samples.size() == 1
                                 ? any.rule
                                 : "the pixel is made of " + std::to_string(any.samples.size()) + " samples";
    const std::string origin = formats::origin_text(any);
    return origin.empty() ? rule : rule + "; " + origin;
}

std::string head_of(const ExplanationPage& page, const Explanation& any) {
    return "{\"width\":" + std::to_string(page.image.width) +
           ",\"height\":" + std::to_string(page.image.height) +
           ",\"columns\":" + std::to_string(page.columns) + ",\"rows\":" + std::to_string(page.rows) +
           ",\"samples\":" + std::to_string(any.samples.size()) +
           ",\"rule\":" + formats::json_text(rule_of(any)) + "," + first_of(page) +
           ",\"gpu\":" + gpu_of(page) + ",";
}

/// Packs as many rays as fit the size limit.
std::string packed(const formats::PageData& data, const std::string& head, std::size_t room) {
    // Initial estimate that rarely omits too much, as packing is slow.
    constexpr std::size_t min_bytes_per_ray = 22;
    std::size_t count = std::min(data.rays(), room / min_bytes_per_ray);
    std::string bytes = data.packed(head, count);
    for (int tries = 0; tries < 8 && bytes.size() > room; ++tries) {
        const double share = static_cast<double>(room) / static_cast<double>(bytes.size());
        count = static_cast<std::size_t>(static_cast<double>(count) * std::min(0.95, 0.97 * share));
        bytes = data.packed(head, count);
    }
    return base64(std::as_bytes(std::span(bytes)));
}

} // namespace

std::string explanation_html(const ExplanationPage& request) {
    ExplanationPage page = request;
    page.columns = std::clamp(page.columns, 1, page.image.width);
    page.rows = std::clamp(page.rows, 1, page.image.height);
    if (page.pixel)
        page.pixel = {std::clamp(page.pixel->x, 0, page.image.width - 1),
                      std::clamp(page.pixel->y, 0, page.image.height - 1)};
    formats::PageData data;
    std::string head;
    for (int row = 0; row < page.rows; ++row)
        for (const Explanation& e : page.explain(grid_row(page, row))) {
            if (head.empty()) head = head_of(page, e);
            data.add(e);
        }
    std::string out = before_data(page);
    const std::string end =
        "</script>\n<script>\n" + std::string(formats::page_script()) + "</script>\n</body></html>\n";
    // Base64: four characters for three bytes.
    const std::size_t taken = out.size() + end.size() + 4;
    const std::size_t room = taken < page.max_bytes ? (page.max_bytes - taken) / 4 * 3 : 0;
    return out + packed(data, head, room) + end;
}

} // namespace glint
