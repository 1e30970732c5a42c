// Handles crashes of libraries that do not check their allocations: OpenGL drivers and their compilers. Explains
// crashes of drivers at their start.
#pragma once

#include <cstddef>
#include <string>

namespace coaster::base {

inline constexpr std::size_t kLeastSpace = 64u << 20;  // bytes of address space; less counts as out of memory

inline constexpr std::size_t kLeastStack = 256u << 10;  // bytes, of the program and of each of its threads

// Returns what to print if the stack is limited to less than kLeastStack; empty if it is not. With less the program
// crashes.
std::string stack_problem();

// Installs handlers: a crash (SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL) prints "Out of memory." and ends the program
// with kMemoryExitCode if less than kLeastSpace is left. Other crashes go to the previous handlers.
void guard_crashes();

// From now on, another crash prints `line` and ends the program with `exit_code`; with an empty line it goes to the
// previous handlers again.
void explain_crashes(const std::string& line, int exit_code);

// Ends the program in the same way if less than kLeastSpace is left. Call it before reporting a failure that lack of
// memory would explain.
void end_if_out_of_memory();

}  // namespace coaster::base
