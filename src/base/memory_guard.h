// Handles the end of memory: saves unsaved work, and ends the program with one line and its own exit code.
#pragma once

#include <functional>
#include <string>

namespace coaster::base {

inline constexpr int kMemoryExitCode = 70;
inline constexpr std::size_t kMemoryReserve = 64u << 20;  // bytes of address space; its pages are never touched

// Allocates a reserve. An allocation by `new` that fails then frees it, calls the function of on_memory_end(), prints
// "Out of memory." and the returned text, and ends with kMemoryExitCode, without destructors. On another thread, at the
// end of memory while it saves, and in libraries that crash instead, what is ready for a crash is written
// (base/crash_guard.h).
void guard_memory();

// Sets the function that saves at the end of memory. It runs once, and only on the thread that called guard_memory(),
// because it reads that thread's state. It returns the text to print. Empty: nothing is saved so.
void on_memory_end(std::function<std::string()> save);

}  // namespace coaster::base
