// Calls the shared library.
extern "C" int use_glint();

int main() { return use_glint(); }
