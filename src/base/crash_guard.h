// Handles crashes and the end of memory: writes unsaved work or its copy that is ready, says what failed, explains
// crashes of drivers at their start, and takes those of libraries that do not check their allocations for the end of
// memory.
#pragma once

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/enum_names.h"
#include "base/files.h"

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
inline constexpr std::size_t kLeastSpace = 64u << 20;   // bytes of address space; less counts as out of memory
inline constexpr std::size_t kLeastStack = 256u << 10;  // bytes, of the program and of each of its threads

// Returns what to print if the stack is limited to less than kLeastStack; empty if it is not. With less the program
// crashes.
std::string stack_problem();

// Installs handlers: a crash (SIGSEGV, SIGBUS, SIGABRT, SIGFPE, SIGILL, an unhandled exception) writes the files of
// keep_for_crash(), prints one line and goes to the previous handlers. If less than kLeastSpace is left, the line is
// "Out of memory." and the program ends with kMemoryExitCode. A signal that another process sent is treated alike.
void guard_crashes();

// Gives a thread its own stack for the handlers while the object lives: they work when the thread's stack overflows.
// guard_crashes() does it for the calling thread.
class HandlerStack {
 public:
  HandlerStack();
  ~HandlerStack();
  HandlerStack(const HandlerStack&) = delete;
  HandlerStack& operator=(const HandlerStack&) = delete;

 private:
  std::unique_ptr<char[]> stack_;
  [[maybe_unused]] stack_t before_{};
};

// A file that a crash completes. It has its name only then; without a crash it leaves nothing.
struct CrashFile {
  NewFile file;
  std::string text;
};

// From now on a crash writes these files in their order, up to the first that fails; none: nothing. Does not return
// while a crash is handled. Any thread may call it, one at a time.
void keep_for_crash(std::vector<CrashFile> files);

// Crashes with a reason in place of the signal's name: "scene.cpp:12: check failed: ...".
[[noreturn]] void crash_because(const char* reason);

// From now on, another crash prints `line` and ends the program with `exit_code`; with an empty line it goes to the
// previous handlers again.
void explain_crashes(const std::string& line, int exit_code);

// Ends the program as crashes do, with `line` ("Out of memory.") and without destructors. Calls only what a signal
// handler may call.
[[noreturn]] void end_at_once(std::string_view line, int exit_code);

// Ends the program in the same way if less than kLeastSpace is left. Call it before reporting a failure that lack of
// memory would explain.
void end_if_out_of_memory();
enum class CrashPlace : std::uint8_t { input, job, panels, command, ticks, findings, drawing, keeping };
inline constexpr NameRow kCrashPlaces[] = {{"input", "Input", "Reading the events of a frame."},
                                           {"job", "Job", "In the thread of an import or a search."},
                                           {"panels", "Panels", "Building the panels."},
                                           {"command", "Command", "Applying a command."},
                                           {"ticks", "Ticks", "Advancing the ride."},
                                           {"findings", "Findings", "Finding what the picture shows."},
                                           {"drawing", "Drawing", "Drawing the picture."},
                                           {"keeping", "Keeping", "Keeping settings and unsaved changes."}};
constexpr std::span<const NameRow> rows_of(CrashPlace) { return kCrashPlaces; }

enum class CrashCause : std::uint8_t { access, check, exception, stack, memory };
inline constexpr NameRow kCrashWays[] = {{"access", "Access", "Writes to an invalid address."},
                                         {"check", "Check", "Fails a check."},
                                         {"exception", "Exception", "Throws an exception that nobody handles."},
                                         {"stack", "Stack", "Calls itself until the stack ends."},
                                         {"memory", "Memory", "Takes all memory, then writes to an invalid address."}};
constexpr std::span<const NameRow> rows_of(CrashCause) { return kCrashWays; }

struct PlannedCrash {
  CrashPlace place = CrashPlace::input;
  CrashCause way = CrashCause::access;
};

// Crashes if that is planned for this place.
void crash_if_planned(const std::optional<PlannedCrash>& plan, CrashPlace place);

}  // namespace coaster::base
