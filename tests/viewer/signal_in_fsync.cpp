// Loaded into a program (LD_PRELOAD): while it writes a file, somebody ends it.

#include <csignal>

extern "C" int fsync(int) { return std::raise(SIGTERM); }
