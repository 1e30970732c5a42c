#include "base/memory_guard.h"

#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <string_view>
#include <thread>
#include <utility>

#include "base/console.h"
#include "base/crash_guard.h"

namespace coaster::base {
namespace {

// A new-handler gets no argument, so its state is global.
struct Guard {
  void* reserve = nullptr;
  std::thread::id owner;
  std::function<std::string()> save;
  std::atomic<std::thread::id> ending;  // the thread that ends the program
};
Guard& guard() {
  static Guard one;
  return one;
}

void end_of_memory() {
  Guard& g = guard();
  std::thread::id nobody;
  const std::thread::id here = std::this_thread::get_id();
  if (!g.ending.compare_exchange_strong(nobody, here)) {
    if (nobody == here) end_at_once("Out of memory.", kMemoryExitCode);  // again, while it saves
    for (;;) ::pause();                                                  // another thread is ending the program
  }
  std::free(std::exchange(g.reserve, nullptr));
  if (here != g.owner) end_at_once("Out of memory.", kMemoryExitCode);
  const std::string said = g.save ? g.save() : std::string();
  (void)finish_printing();
  print_error(said.empty() ? "Out of memory." : "Out of memory. " + said);
  std::_Exit(kMemoryExitCode);
}

}  // namespace

void guard_memory() {
  Guard& g = guard();
  if (g.reserve == nullptr) g.reserve = std::malloc(kMemoryReserve);
  g.owner = std::this_thread::get_id();
  std::set_new_handler(end_of_memory);
  guard_crashes();
}

void on_memory_end(std::function<std::string()> save) { guard().save = std::move(save); }

}  // namespace coaster::base
