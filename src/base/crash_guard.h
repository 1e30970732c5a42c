// The crashes that libraries end in which do not check their allocations: OpenGL drivers and the compilers in them.
#pragma once

#include <cstddef>

namespace coaster::base {

inline constexpr std::size_t kLeastSpace = 64u << 20;  // bytes of address space: less is the end of memory

// From now on a crash (SIGSEGV, SIGBUS, SIGABRT) prints "Out of memory." and ends the program with kMemoryExitCode
// where less than kLeastSpace is left. Other crashes go to whoever handled them before.
void guard_crashes();

// Ends the program so where that little is left: before a failure is told that lack of memory explains.
void end_if_out_of_memory();

}  // namespace coaster::base
