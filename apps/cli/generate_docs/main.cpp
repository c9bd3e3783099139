// Writes the man page or a shell's completion to stdout, for the build.
#include "generate_docs.h"

#include <cstdio>
#include <string>

int main(int argc, char** argv) {
    using namespace glint::cli;
    const std::string what = argc > 1 ? argv[1] : "";
    std::string text;
    if (what == "man") text = man_page(GLINT_VERSION);
    if (what == "bash") text = bash_completion();
    if (what == "zsh") text = zsh_completion();
    if (what == "fish") text = fish_completion();
    if (text.empty()) {
        std::fputs("usage: glint_generate_docs man|bash|zsh|fish\n", stderr);
        return 2;
    }
    return std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0 ? 4 : 0;
}
