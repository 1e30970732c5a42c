// The end of memory: what was not saved is saved, and the program ends with one line and an exit code of its own.
#pragma once

#include <functional>
#include <string>

namespace coaster::base {

inline constexpr int kMemoryExitCode = 70;
inline constexpr std::size_t kMemoryReserve = 64u << 20;  // bytes of address space; no page of it is touched

// Keeps a reserve from now on. An allocation by `new` that fails then frees it, calls the function of on_memory_end(),
// prints "Out of memory." and what that returned, and ends with kMemoryExitCode, without destructors. Libraries that
// crash instead end it so, too, but nothing is saved (base/crash_guard.h).
void guard_memory();

// `save` runs when memory ends: on the thread that called guard_memory() alone, as it reads that thread's state, and
// once. It returns what is to be said. Empty: nothing is saved.
void on_memory_end(std::function<std::string()> save);

}  // namespace coaster::base
