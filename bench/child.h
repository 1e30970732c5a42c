// Measurements in a child process, so that memory is what the work adds to it.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <ctime>
#include <fstream>

namespace coaster::bench {

inline double cpu_seconds() {  // of all threads
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

inline double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

inline double most_resident_mb() {  // since the start of the process
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024 / 1e6;
}

// Fills `figures`, which are plain data, with what work() returns in a child process. Returns false if it ended early.
template <class Figures>
bool in_child(Figures& figures, auto work) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  const pid_t child = fork();
  if (child == 0) {
    figures = work();
    (void)!write(ends[1], &figures, sizeof figures);
    _exit(0);
  }
  close(ends[1]);
  const bool whole = read(ends[0], &figures, sizeof figures) == static_cast<ssize_t>(sizeof figures);
  waitpid(child, nullptr, 0);
  close(ends[0]);
  return whole;
}

}  // namespace coaster::bench
