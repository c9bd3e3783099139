#pragma once
// The project's files as text, and a scanner for includes, functions and types.

#include <string>
#include <vector>

namespace glint::house {

/// One source file.
struct Source {
    std::string path; ///< from the project's root, with '/': "src/math/vec.h"
    std::string text;
};

/// All files with these extensions under the given folders of the project, sorted by path. A folder that is
/// missing is empty.
std::vector<Source> sources_under(const std::vector<std::string>& folders,
                                  const std::vector<std::string>& extensions = {".h", ".cpp"});

/// A whole file of the project; throws std::runtime_error if it cannot be read.
std::string read_project_file(const std::string& path);

/// The text with comments and the insides of string and character literals replaced by spaces. Length and
/// line ends stay as they are. Knows raw strings, digit separators and the template literals of JavaScript.
std::string code_only(const std::string& text);

/// Whether a character may stand in a name.
bool is_word(char c);

/// The text split at line ends, without them.
std::vector<std::string> lines_of(const std::string& text);

/// The line, counted from 1, in which a position stands.
int line_at(const std::string& text, std::size_t position);

/// An #include that is code, not comment.
struct Include {
    int line = 0;     ///< from 1
    std::string name; ///< what stands between the quotes or brackets
    bool angled = false;
};

std::vector<Include> includes_of(const std::string& text);

/// A function of C++, GLSL or JavaScript with a body, lambdas inside it counted as part of it.
struct Function {
    std::string name; ///< the head, on one line, cut at 80 characters
    int first = 0;    ///< line on which the head starts, from 1
    int last = 0;     ///< line of the closing brace

    int lines() const { return last - first + 1; }
};

/// The functions of one file in the order in which they end.
std::vector<Function> functions_of(const std::string& text);

/// A class, struct, union or enum that is defined, not only declared, outside functions.
struct Type {
    std::string name; ///< with its namespaces and classes: "glint::bvh::Tree"
    int line = 0;     ///< of the head, from 1
};

/// The types of one file, without those in unnamed namespaces.
std::vector<Type> types_of(const std::string& text);

} // namespace glint::house
