// The command `glint`.
#include "run.h"

int main(int argc, char** argv) { return glint::cli::run({argv + 1, argv + argc}); }
