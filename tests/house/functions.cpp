// Finds functions and types by counting braces, which suffices for code formatted by clang-format.

#include "sources.h"

#include <algorithm>
#include <cctype>

namespace glint::house {

namespace {

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

/// Preprocessor lines, with their continuations, become blank: braces in macros need not be balanced.
std::string without_directives(std::string code) {
    bool directive = false;
    for (std::size_t begin = 0; begin < code.size();) {
        const std::size_t end = std::min(code.find('\n', begin), code.size());
        const std::size_t first = code.find_first_not_of(" \t", begin);
        directive = directive || (first < end && code[first] == '#');
        const bool continues = directive && end > begin && code[end - 1] == '\\';
        if (directive)
            std::fill(code.begin() + static_cast<std::ptrdiff_t>(begin),
                      code.begin() + static_cast<std::ptrdiff_t>(end), ' ');
        directive = continues;
        begin = end + 1;
    }
    return code;
}

/// One line, single spaces.
std::string squeeze(const std::string& text) {
    std::string out;
    for (char c : text) {
        if (!is_space(c))
            out += c;
        else if (!out.empty() && out.back() != ' ')
            out += ' ';
    }
    if (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
}

bool starts_with_word(const std::string& text, const std::string& word) {
    return text.starts_with(word) && (text.size() == word.size() || !is_word(text[word.size()]));
}

/// The head without the template<...> before it.
std::string without_template(const std::string& head) {
    if (!starts_with_word(head, "template")) return head;
    int depth = 0;
    for (std::size_t i = head.find('<'); i < head.size(); ++i) {
        if (head[i] == '<') ++depth;
        if (head[i] == '>' && --depth == 0) return without_template(squeeze(head.substr(i + 1)));
    }
    return head;
}

/// The position of an '=' that starts an initialiser: none of "operator=", "==", "<=" and the like, nor
/// inside brackets.
std::size_t initialiser(const std::string& head) {
    int depth = 0;
    for (std::size_t i = 0; i < head.size(); ++i) {
        if (head[i] == '(' || head[i] == '<') ++depth;
        if (head[i] == ')' || (head[i] == '>' && depth > 0)) --depth;
        if (head[i] != '=' || depth > 0 || head.find("operator") < i) continue;
        if (i + 1 < head.size() && head[i + 1] != '=') return i;
        if (i + 1 == head.size()) return i;
    }
    return std::string::npos;
}

/// A function of JavaScript: "(a, b) =>".
bool is_arrow(const std::string& head) { return head.ends_with("=>"); }

enum class Brace { scope, function, data };

/// What a brace opens, judged by the text between it and the previous end of a declaration.
Brace classify(const std::string& full_head) {
    const std::string head = without_template(squeeze(full_head));
    for (const char* word :
         {"namespace", "struct", "class", "union", "enum", "extern", "inline namespace", "layout"})
        if (starts_with_word(head, word) &&
            (head.find('(') == std::string::npos || std::string(word) != "extern"))
            return Brace::scope;
    const std::size_t value = initialiser(head);
    if (is_arrow(head)) return Brace::function;
    if (value != std::string::npos) {
        const std::size_t first = head.find_first_not_of(" =", value);
        return first != std::string::npos && head[first] == '[' ? Brace::function : Brace::data;
    }
    return head.find('(') == std::string::npos ? Brace::data : Brace::function;
}

/// What everything in an unnamed namespace begins with.
const std::string unnamed = "(unnamed)";

struct Scope {
    std::string name; ///< empty where it has none
    bool is_namespace = false;
};

/// The scope that a head such as "struct alignas(32) Node : Base" or "namespace a::b" opens.
Scope scope_of(std::string head) {
    Scope scope;
    scope.is_namespace = starts_with_word(head, "namespace") || starts_with_word(head, "inline namespace") ||
                         starts_with_word(head, "extern");
    if (starts_with_word(head, "extern")) return scope;
    for (const char* word : {"inline", "namespace", "enum", "struct", "class", "union"})
        if (starts_with_word(head, word)) head = squeeze(head.substr(std::string(word).size()));
    if (starts_with_word(head, "alignas")) head = squeeze(head.substr(head.find(')') + 1));
    int depth = 0; // of template arguments
    std::size_t end = 0;
    for (; end < head.size() && (depth > 0 || head[end] != ' '); ++end)
        depth += head[end] == '<' ? 1 : head[end] == '>' ? -1 : 0;
    scope.name = head.substr(0, end);
    return scope;
}

/// Walks over code, file and class scope; bodies and data are passed over by counting braces.
class Scanner {
  public:
    explicit Scanner(const std::string& text) : code_(without_directives(code_only(text))) {}

    void run() {
        for (at_ = 0; at_ < code_.size(); ++at_) {
            const char c = code_[at_];
            if (c == '(') ++parens_;
            if (c == ')') --parens_;
            if (c == '{')
                open();
            else if (c == '}')
                close();
            else if (c == ';' && parens_ == 0)
                begin_head();
            else if (c == ':' && is_access_label())
                begin_head();
        }
    }

    std::vector<Function> functions;
    std::vector<Type> types;

  private:
    void begin_head() {
        head_ = at_ + 1;
        parens_ = 0;
    }

    std::string head() const { return code_.substr(head_, at_ - head_); }

    bool is_access_label() const {
        const std::string word = squeeze(head());
        return word == "public" || word == "private" || word == "protected";
    }

    /// In "A() : a_{1}, b_(2) {" the first brace starts a member, the second the body.
    bool is_member_initialiser() const {
        const std::string text = squeeze(head());
        std::size_t colon = text.find(") : ");
        if (colon == std::string::npos) colon = text.find(") noexcept : ");
        return colon != std::string::npos && (is_word(text.back()) || text.back() == '>') &&
               text.size() > colon + 3;
    }

    void open() {
        const bool is_argument = parens_ > 0;
        const bool arrow = is_arrow(squeeze(head()));
        const Brace brace =
            (is_argument || is_member_initialiser()) && !arrow ? Brace::data : classify(head());
        if (brace == Brace::scope) return enter();
        const std::size_t first = code_.find_first_not_of(" \t\r\n", head_);
        const std::size_t opening = at_;
        at_ = closing();
        if (brace == Brace::data) return;
        add(first, code_.substr(first, opening - first));
        if (!is_argument) begin_head();
    }

    /// A namespace or type begins.
    void enter() {
        const Scope scope = scope_of(without_template(squeeze(head())));
        std::string name = scopes_.empty() ? "" : scopes_.back();
        if (!name.empty() && !scope.name.empty()) name += "::";
        name = scope.name.empty() && scope.is_namespace ? unnamed : name + scope.name;
        if (!scope.is_namespace && !scope.name.empty() && name.find(unnamed) == std::string::npos)
            types.push_back({name, line_at(code_, code_.find_first_not_of(" \t\r\n", head_))});
        scopes_.push_back(name);
        begin_head();
    }

    void close() {
        if (!scopes_.empty()) scopes_.pop_back();
        begin_head();
    }

    std::size_t closing() const {
        int depth = 0;
        for (std::size_t i = at_; i < code_.size(); ++i) {
            if (code_[i] == '{') ++depth;
            if (code_[i] == '}' && --depth == 0) return i;
        }
        return code_.size();
    }

    void add(std::size_t first, const std::string& name) {
        functions.push_back({squeeze(name).substr(0, 80), line_at(code_, first), line_at(code_, at_)});
    }

    std::string code_;
    std::size_t at_ = 0;
    std::size_t head_ = 0; ///< where the declaration being read began
    int parens_ = 0;
    std::vector<std::string> scopes_; ///< full names of the namespaces and types around, outermost first
};

} // namespace

std::vector<Function> functions_of(const std::string& text) {
    Scanner scanner(text);
    scanner.run();
    return std::move(scanner.functions);
}

std::vector<Type> types_of(const std::string& text) {
    Scanner scanner(text);
    scanner.run();
    return std::move(scanner.types);
}

} // namespace glint::house
