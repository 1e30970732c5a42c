#include "platform/signals.h"

#include <csignal>
#include <initializer_list>

namespace coaster::platform {
namespace {

// A handler may access only such a flag and gets no argument: the one global variable that cannot be avoided.
volatile std::sig_atomic_t came = 0;

extern "C" void note_signal(int number) { came = number; }

void watch(int number, const struct sigaction& action) {
  struct sigaction before {};
  if (::sigaction(number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN) return;
  (void)::sigaction(number, &action, nullptr);
}

}  // namespace

void watch_signals() {
  struct sigaction action {};
  action.sa_handler = note_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigemptyset(&action.sa_mask);
  for (const int number : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2}) watch(number, action);
#ifdef SIGPWR
  watch(SIGPWR, action);
#endif
  action.sa_flags = SA_RESTART;  // each line printed to a closed pipe is another one, each second beyond the limit, too
  for (const int number : {SIGPIPE, SIGXCPU}) watch(number, action);
}

int pending_signal() { return came; }

}  // namespace coaster::platform
