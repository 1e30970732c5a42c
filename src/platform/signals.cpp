#include "platform/signals.h"

#include <sys/time.h>

#include <csignal>
#include <initializer_list>

#include "base/crash_guard.h"

namespace coaster::platform {
namespace {

// A handler may access only such flags and gets no argument: global variables that cannot be avoided.
volatile std::sig_atomic_t came = 0, asked_for = 0;

// Sets the time until SIGALRM, us.
void set_alarm(int microseconds) {
  const itimerval timer{{0, 0}, {0, microseconds}};
  (void)::setitimer(ITIMER_REAL, &timer, nullptr);
}

constexpr int kPatience = 700'000;  // us

extern "C" void note_signal(int number) {
  if (came == 0) set_alarm(kPatience);
  came = number;
}

// The program is in one long step and has not asked for a signal, or takes long to end: it ends as by a crash, with the
// copy of the changes that is ready.
extern "C" void end_long_step(int) {
  if (came != 0) base::end_at_once("error: stopped by a signal in a long step.", 128 + came);
}

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
  action.sa_handler = end_long_step;
  (void)::sigaction(SIGALRM, &action, nullptr);
  action.sa_handler = note_signal;
  action.sa_flags = SA_RESTART;  // each line printed to a closed pipe is another one, each second beyond the limit, too
  for (const int number : {SIGPIPE, SIGXCPU}) watch(number, action);
}

int pending_signal() {
  if (came != 0 && asked_for == 0) asked_for = 1, set_alarm(kPatience);
  return came;
}

}  // namespace coaster::platform
