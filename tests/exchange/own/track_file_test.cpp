#include "exchange/formats.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "base/scratch_folder.h"
#include "sim/tracks.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace track_file_test {

class TrackFile : public testing::Test {
 protected:
  test::ScratchFolder scratch_;
  std::filesystem::path folder_ = scratch_.path();
  base::Files files_;
};

TEST_F(TrackFile, what_is_saved_loads_again) {
  const world::Document d = test::sample_document();
  ASSERT_TRUE(save_track(files_, folder_ / "a.json", d));
  const auto loaded = load_track(files_, folder_ / "a.json");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(world::hash(loaded->document), world::hash(d));
}

TEST_F(TrackFile, other_endings_are_refused_with_the_known_ones) {
  const auto loaded = load_track(files_, folder_ / "a.doc");
  EXPECT_EQ(loaded.status().code, base::Code::bad_file);
  EXPECT_NE(loaded.status().message.find("a.doc: error: expected a file ending in .json"), std::string::npos);
  const auto folder = load_track(files_, folder_);
  EXPECT_NE(folder.status().message.find("this is a folder; expected a file ending in .json"), std::string::npos);
  EXPECT_FALSE(save_track(files_, folder_ / "a", {}));
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_F(TrackFile, either_case_of_an_ending_will_do) {
  const world::Document d = test::sample_document();
  ASSERT_TRUE(save_track(files_, folder_ / "A.JSON", d));
  const auto loaded = load_track(files_, folder_ / "A.JSON");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_EQ(world::hash(loaded->document), world::hash(d));
}

TEST_F(TrackFile, a_name_from_a_files_name_can_be_kept_in_any_file) {
  EXPECT_EQ(name_of_file("/a.b/Stra\xc3\x9f"
                         "e 7.nl2elem"),
            "Stra\xc3\x9f"
            "e 7");
  const world::Document line = test::straight_document({0, 10, 0}, {30, 10, 0}, 3);
  for (const std::string odd : {"a\tb\x7f", "a\xff", "\xc3", "\x80\x80"}) {
    for (const char* const ending : {".csv", ".nl2elem"}) {
      const base::Status saved = save_track(files_, folder_ / (odd + ending), line);
      ASSERT_TRUE(saved) << saved.message;
      const auto loaded = load_track(files_, folder_ / (odd + ending));
      ASSERT_TRUE(loaded) << loaded.status().message;
      const auto again = parse_track(print_track(loaded->document), "again");
      ASSERT_TRUE(again) << again.status().message;
      EXPECT_EQ(world::hash(again->document), world::hash(loaded->document)) << loaded->document.name;
    }
  }
  const std::string most(world::kMaxNameBytes, '\xff');
  EXPECT_EQ(name_of_file(most).size(), world::kMaxNameBytes / 3 * 3) << "each byte became three";
}

TEST_F(TrackFile, a_missing_file_is_a_bad_file) {
  EXPECT_EQ(load_track(files_, folder_ / "none.json").status().code, base::Code::bad_file);
}

TEST_F(TrackFile, a_failing_disk_leaves_the_old_file) {
  const world::Document d = test::sample_document();
  ASSERT_TRUE(save_track(files_, folder_ / "a.json", d));
  world::Document other = d;
  other.name = "other";
  for (const auto operation :
       {base::IoOperation::open, base::IoOperation::write, base::IoOperation::fsync, base::IoOperation::rename}) {
    files_.inject(operation, 1);
    EXPECT_EQ(save_track(files_, folder_ / "a.json", other).code, base::Code::io);
    files_.inject(operation, 0);
    const auto loaded = load_track(files_, folder_ / "a.json");
    ASSERT_TRUE(loaded);
    EXPECT_EQ(loaded->document.name, d.name);
  }
}

}  // namespace track_file_test
}  // namespace coaster::exchange
