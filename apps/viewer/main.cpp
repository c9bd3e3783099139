// The program `glint-view`.
#include "run.h"

int main(int argc, char** argv) { return glint::viewer::run({argv + 1, argv + argc}); }
