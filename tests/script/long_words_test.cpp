// Messages stay short whatever is written: a word of 100 kB anywhere in a line is shown by its first 200 bytes.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "edit/commands/codec.h"
#include "script/fake_host.h"
#include "script/grammar.h"

namespace coaster::script {
namespace long_words_test {

constexpr std::size_t kWord = 100'000, kMost = 1500;  // bytes; of a message with its line

std::vector<std::string> beginnings() {
  std::vector<std::string> all{"",
                               "expect",
                               "expect knots ==",
                               "expect knots",
                               "expect position",
                               "expect visible",
                               "expect file",
                               "expect error",
                               "expect error load",
                               "expect toast ~",
                               "wait",
                               "wait ride.lap == 1 max",
                               "repeat",
                               "seek",
                               "seek length == 3 by",
                               "seek length == 3 by height of",
                               "env",
                               "env size",
                               "env msaa",
                               "env home",
                               "key",
                               "aim.click",
                               "aim.drag @k1 to",
                               "ui.click",
                               "ui.check \"A\"",
                               "ui.type \"A\"",
                               "ui.drag \"A\" by",
                               "log",
                               "log position",
                               "include",
                               "fault",
                               "fault io.open fail",
                               "shot",
                               "snap",
                               "dump",
                               "sheet",
                               "resize",
                               "raw.key",
                               "movie.start",
                               "load",
                               "load \"a.xyz\" up",
                               "save",
                               "challenge",
                               "camera",
                               "camera yaw"};
  for (const edit::CommandHelp& row : edit::command_table()) {
    const std::string command(row.usage.substr(0, row.usage.find(' ')));
    all.push_back(command), all.push_back(command + " @k1");
  }
  return all;
}

TEST(long_words, messages_cut_every_word_to_200_bytes) {
  const std::string letters(kWord, 'a'), digits = '1' + std::string(kWord, '7');
  int errors = 0;
  for (const std::string& beginning : beginnings())
    for (const std::string& word : {letters, digits, '"' + letters + '"', '@' + letters, letters + " 1",
                                    '"' + letters + "\" \"" + letters + '"', "@k1 " + letters, "1 2 " + letters}) {
      FakeHost fake;
      base::Files files;
      const std::string line = beginning + ' ' + word;
      const ParsedScript parsed = parse_script("coaster-script 1\n" + line + '\n', "a.coaster", test_folder(), files);
      std::vector<std::string> messages = parsed.errors;
      if (messages.empty())
        if (const base::Status status = run_lines(fake, line + '\n'); !status) messages = {status.message};
      for (const std::string& message : messages) {
        ++errors;
        EXPECT_LE(message.size(), kMost) << beginning << ": " << message.substr(0, 300);
      }
    }
  EXPECT_GT(errors, 500);
}

}  // namespace long_words_test
}  // namespace coaster::script
