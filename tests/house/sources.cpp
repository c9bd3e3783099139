// Reads files, blanks comments and literals, finds includes.

#include "sources.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace glint::house {

namespace fs = std::filesystem;

std::string read_project_file(const std::string& path) {
    std::ifstream in(fs::path(GLINT_SOURCE_DIR) / path, std::ios::binary);
    if (!in) throw std::runtime_error("cannot read " + path);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
}

std::vector<Source> sources_under(const std::vector<std::string>& folders,
                                  const std::vector<std::string>& extensions) {
    std::vector<Source> sources;
    const fs::path root = GLINT_SOURCE_DIR;
    for (const std::string& folder : folders) {
        if (!fs::exists(root / folder)) continue;
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (!entry.is_regular_file() ||
                std::find(extensions.begin(), extensions.end(), extension) == extensions.end())
                continue;
            const std::string path = fs::relative(entry.path(), root).generic_string();
            sources.push_back({path, read_project_file(path)});
        }
    }
    std::sort(sources.begin(), sources.end(),
              [](const Source& a, const Source& b) { return a.path < b.path; });
    return sources;
}

namespace {

/// Walks over a text and blanks what is not code.
class Blanker {
  public:
    explicit Blanker(const std::string& text) : text_(text), code_(text) {}

    std::string run() {
        while (at_ < text_.size()) {
            if (starts("//")) {
                blank_to(text_.find('\n', at_));
            } else if (starts("/*")) {
                blank_to(after(text_.find("*/", at_ + 2), 2));
            } else if (starts("R\"") && (at_ == 0 || !is_word(text_[at_ - 1]))) {
                raw_string();
            } else if (text_[at_] == '"' || (text_[at_] == '\'' && !is_digit_separator())) {
                literal(text_[at_]);
            } else if (text_[at_] == '`') {
                template_literal();
            } else {
                ++at_;
            }
        }
        return code_;
    }

  private:
    bool starts(const char* what) const { return text_.compare(at_, 2, what) == 0; }
    static std::size_t after(std::size_t found, std::size_t length) {
        return found == std::string::npos ? found : found + length;
    }
    bool is_digit_separator() const { return at_ > 0 && is_word(text_[at_ - 1]); }

    void blank_to(std::size_t end) {
        end = std::min(end, text_.size());
        for (; at_ < end; ++at_)
            if (text_[at_] != '\n') code_[at_] = ' ';
    }

    void literal(char quote) {
        std::size_t end = at_ + 1;
        while (end < text_.size() && text_[end] != quote && text_[end] != '\n')
            end += text_[end] == '\\' ? 2 : 1;
        ++at_;
        blank_to(end);
        ++at_; // the closing quote stays
    }

    /// Of JavaScript; may span lines. None within another's `${}`.
    void template_literal() {
        std::size_t end = at_ + 1;
        while (end < text_.size() && text_[end] != '`') end += text_[end] == '\\' ? 2 : 1;
        ++at_;
        blank_to(end);
        ++at_;
    }

    void raw_string() {
        const std::size_t open = text_.find('(', at_);
        if (open == std::string::npos) return blank_to(open);
        const std::string close = ")" + text_.substr(at_ + 2, open - at_ - 2) + "\"";
        const std::size_t end = text_.find(close, open);
        at_ += 2;
        blank_to(end == std::string::npos ? end : end + close.size() - 1);
        ++at_;
    }

    const std::string& text_;
    std::string code_;
    std::size_t at_ = 0;
};

} // namespace

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

std::string code_only(const std::string& text) { return Blanker(text).run(); }

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

int line_at(const std::string& text, std::size_t position) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(position, text.size()));
    return 1 + static_cast<int>(std::count(text.begin(), end, '\n'));
}

std::vector<Include> includes_of(const std::string& text) {
    std::vector<Include> includes;
    const std::vector<std::string> written = lines_of(text);
    const std::vector<std::string> code = lines_of(code_only(text));
    for (std::size_t i = 0; i < code.size(); ++i) {
        // The name is read from the written line: literals are blank in code.
        std::size_t at = code[i].find_first_not_of(" \t");
        if (at == std::string::npos || code[i][at] != '#') continue;
        at = code[i].find_first_not_of(" \t", at + 1);
        if (at == std::string::npos || code[i].compare(at, 7, "include") != 0) continue;
        const std::size_t open = written[i].find_first_of("\"<", at);
        if (open == std::string::npos) continue;
        const bool angled = written[i][open] == '<';
        const std::size_t close = written[i].find(angled ? '>' : '"', open + 1);
        includes.push_back({static_cast<int>(i) + 1, written[i].substr(open + 1, close - open - 1), angled});
    }
    return includes;
}

} // namespace glint::house
