#include "base/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <fmt/format.h>

#include "base/utf8.h"

namespace coaster::base {
namespace {

// Returns the code point of a well-formed character.
std::uint32_t code_point(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(character[i])); };
  if (character.size() == 1) return byte(0);
  std::uint32_t point = byte(0) & (0x7fu >> character.size());
  for (std::size_t i = 1; i < character.size(); ++i) point = point << 6 | (byte(i) & 0x3f);
  return point;
}

bool is_control(std::uint32_t point) {
  if (point == '\n' || point == '\t') return false;
  return point < 0x20 || (point >= 0x7f && point < 0xa0) || point == 0x61c || point == 0x200e || point == 0x200f ||
         (point >= 0x2028 && point <= 0x202e) || (point >= 0x2066 && point <= 0x2069);
}

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

std::string visible_text(std::string_view text) {
  std::string visible;
  visible.reserve(text.size());
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    const std::string_view character = text.substr(0, length == 0 ? 1 : length);
    if (length == 0) visible += fmt::format("\\x{:02x}", static_cast<unsigned char>(text[0]));
    else if (const std::uint32_t point = code_point(character); is_control(point))
      visible += fmt::format("\\u{:04x}", point);
    else visible += character;
    text.remove_prefix(character.size());
  }
  return visible;
}

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
  (void)put(stderr, line);
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
