#include "base/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::base {
namespace {

// Returns the errno of the first write to stdout that failed: stdio records only that there was one.
int& output_error() {
  static int error = 0;
  return error;
}

// Returns false with errno.
bool put(std::FILE* to, std::string_view text) {
  const std::string visible = visible_text(text);
  return std::fwrite(visible.data(), 1, visible.size(), to) == visible.size();
}

}  // namespace

void hold_streams() {
  int fd = 0;
  do fd = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  while (fd >= 0 && fd <= STDERR_FILENO);
  if (fd > STDERR_FILENO) ::close(fd);
  (void)std::setvbuf(stdout, nullptr, _IOLBF, BUFSIZ);
}

void print(std::string_view text) {
  if (!put(stdout, text) && output_error() == 0) output_error() = errno;
}

void print_error(std::string_view line) {
  print_progress("");
  (void)put(stderr, line.find('\n') == line.npos ? cut_words(line) : line);  // of scripts they are cut already
  std::fputc('\n', stderr);
}

void print_progress(std::string_view text) {
  if (!::isatty(STDERR_FILENO)) return;
  std::fputc('\r', stderr);
  (void)put(stderr, text);
}

Status finish_printing() {
  if (std::fflush(stdout) != 0 && output_error() == 0) output_error() = errno;
  if (output_error() == 0) return {};
  return {Code::io, fmt::format("standard output cannot be written: {}", std::strerror(output_error()))};
}

}  // namespace coaster::base
