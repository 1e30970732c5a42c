// Whatever the scan accepts, the library accepts with the same events.
#include "exchange/own/json_scan.h"

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/files.h"
#include "base/tries.h"
#include "exchange/own/json.h"
#include "exchange/own/track_file.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace json_scan_test {

// The events as a text.
struct Recorder {
  std::string events;
  bool add(const std::string& event) { return events += event + "\n", true; }

  bool null() { return add("null"); }
  bool boolean(bool value) { return add(value ? "true" : "false"); }
  bool number_integer(std::int64_t value) { return add(fmt::format("integer {}", value)); }
  bool number_unsigned(std::uint64_t value) { return add(fmt::format("unsigned {}", value)); }
  bool number_float(double value, const std::string&) { return add(fmt::format("float {:a}", value)); }
  bool string(std::string& value) { return add("string " + value); }
  bool binary(Json::binary_t&) { return false; }
  bool start_object(std::size_t) { return add("{"); }
  bool start_array(std::size_t) { return add("["); }
  bool end_object() { return add("}"); }
  bool end_array() { return add("]"); }
  bool key(std::string& key) { return add("key " + key); }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) { return false; }
};

// Returns whether the scan accepts a text, and checks its events if it does.
bool is_plain(const std::string& text) {
  Recorder scanned, parsed;
  const bool plain = scan_json(text, scanned), good = Json::sax_parse(text, &parsed);
  EXPECT_TRUE(good || !plain) << text;
  if (plain) {
    EXPECT_EQ(scanned.events, parsed.events) << text;
  }
  return plain;
}

TEST(json_scan, knows_what_files_are_made_of) {
  for (const char* text :
       {"{}", "[]", " \r\n\t[ 1 , 2 ]\n", R"({"a":[1,-2,0,-0,3.5,-1e-7,2E+9,0.0,-0.0,true,false,null,"x",{},[[]]]})",
        R"({"ä":"日本 🎢","":""})", "123456789012345678", "-123456789012345678", "\"\x7f\"", "1.7976931348623157e308"})
    EXPECT_TRUE(is_plain(text)) << text;
  base::Files files;
  for (const char* track : {"helix", "loop", "old_timber"}) {
    const auto text = files.read(std::filesystem::path(COASTER_SOURCE_DIR) / "tracks" / (std::string(track) + ".json"));
    ASSERT_TRUE(text) << track;
    EXPECT_TRUE(is_plain(*text)) << track;
  }
}

TEST(json_scan, leaves_the_rest_to_the_library) {
  for (const char* text : {"",
                           " ",
                           "{",
                           "[1,]",
                           R"({"a":1,})",
                           "[,]",
                           "[1 2]",
                           R"({"a" 1})",
                           R"({"a":})",
                           "{1:2}",
                           "01",
                           "-",
                           "-01",
                           ".5",
                           "1.",
                           "1e",
                           "1e+",
                           "+1",
                           "1e999",
                           "1e-999",
                           "1234567890123456789",
                           "nul",
                           "nan",
                           "tru",
                           R"("a)",
                           R"("a\n")",
                           "\"\n\"",
                           "\"\xff\"",
                           "\"\xc0\x80\"",
                           "\"\xed\xa0\x80\"",
                           "[1]]",
                           "1 1",
                           "\xef\xbb\xbf{}",
                           "/**/1"})
    EXPECT_FALSE(is_plain(text)) << text;
}

TEST(json_scan, agrees_with_the_library_on_mutated_files) {
  std::vector<std::string> texts{print_track(test::sample_document()), R"([1,-2.5e3,"ä",{"a":[true,null]}, 0.1 ])"};
  base::Files files;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(COASTER_SOURCE_DIR) / "tests/fuzz/corpus/json"))
    if (const auto text = files.read(entry.path()); text && text->size() < 20'000) texts.push_back(*text);
  ASSERT_GT(texts.size(), 10u);
  std::mt19937 bits(9);
  int plain = 0, others = 0;
  for (const std::string& text : texts) {
    (void)is_plain(text);
    for (int i = 0; i < test::tries(300); ++i) {
      std::string changed = text.substr(bits() % (text.size() + 1), 1 + bits() % 200);
      constexpr std::string_view kBytes = "{}[]\":,.-+eE0123456789 \\tfnu\xc3\xa4\x01";
      for (auto k = bits() % 3; k > 0 && !changed.empty(); --k)
        changed[bits() % changed.size()] = kBytes[bits() % kBytes.size()];
      ++(is_plain(changed) ? plain : others);
      std::string whole = text;
      if (!whole.empty()) whole[bits() % whole.size()] = kBytes[bits() % kBytes.size()];
      ++(is_plain(whole) ? plain : others);
    }
  }
  EXPECT_GT(plain, test::tries(500));
  EXPECT_GT(others, test::tries(500));
}

}  // namespace json_scan_test
}  // namespace coaster::exchange
