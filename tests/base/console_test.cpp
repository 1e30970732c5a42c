#include "base/console.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>

#include "base/text.h"

namespace coaster::base {
namespace console_test {

TEST(console, no_file_gets_the_number_of_a_closed_stream) {
  const auto first_free = [] {
    for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(fd);
    hold_streams();
    if (::write(STDOUT_FILENO, "x", 1) != -1) std::_Exit(101);
    std::_Exit(::open("/dev/null", O_RDONLY));
  };
  EXPECT_EXIT(
      first_free(),
      [](int status) { return WIFEXITED(status) && WEXITSTATUS(status) > STDERR_FILENO && WEXITSTATUS(status) < 100; },
      "");
}

TEST(console, what_controls_a_terminal_is_shown_as_text) {
  EXPECT_EQ(visible_text("\x1b[31mred\x1b[0m"), "\\u001b[31mred\\u001b[0m");
  EXPECT_EQ(visible_text("a\rb\bc\x07"), "a\\u000db\\u0008c\\u0007");
  EXPECT_EQ(visible_text("\xc2\x9b"
                         "31m"),
            "\\u009b31m")
      << "CSI of eight bits";
  EXPECT_EQ(visible_text("\x9b"
                         "31m"),
            "\\x9b31m");
  EXPECT_EQ(visible_text("\xe2\x80\xae"
                         "gpj.exe"),
            "\\u202egpj.exe")
      << "right to left";
  EXPECT_EQ(visible_text(std::string_view("\0", 1)), "\\u0000");
  EXPECT_EQ(visible_text("end\r\n\rstart\x7f"), "end\r\n\\u000dstart\\u007f") << "a file's line end";
  EXPECT_EQ(visible_text("two\n\tlines, Stra\xc3\x9f"
                         "e, \xf0\x9f\x8e\xa2"),
            "two\n\tlines, Stra\xc3\x9f"
            "e, \xf0\x9f\x8e\xa2");
}

// Bytes below 0x20 but line ends and tabs, 0x7f, and C1 controls, in both forms, never come out.
RC_GTEST_PROP(console, no_bytes_whatsoever_control_the_terminal, (const std::string& text)) {
  const std::string visible = visible_text(text);
  for (std::size_t i = 0; i < visible.size(); ++i) {
    const auto byte = static_cast<unsigned char>(visible[i]);
    RC_ASSERT((byte >= 0x20 && byte != 0x7f) || byte == '\n' || byte == '\t' || visible.compare(i, 2, "\r\n") == 0);
    if (byte == 0xc2) RC_ASSERT(static_cast<unsigned char>(visible.at(i + 1)) >= 0xa0);
  }
  RC_ASSERT(visible_text(visible) == visible);
}

}  // namespace console_test
}  // namespace coaster::base
