// A pthread_create for LD_PRELOAD that refuses every thread, as a limit of processes (ulimit -u) does.
#include <cerrno>

extern "C" int pthread_create(void*, const void*, void* (*)(void*), void*) { return EAGAIN; }
