#include "exchange/own/autosave.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>

#include "base/scratch_folder.h"
#include "exchange/formats.h"

namespace coaster::exchange {
namespace autosave_test {

namespace fs = std::filesystem;

world::Document document_named(std::string name) {
  world::Document document;
  document.name = std::move(name);
  return document;
}

class autosave : public testing::Test {
 protected:
  std::size_t entries() const {
    return fs::exists(folder)
               ? static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()))
               : 0;
  }
  std::string name_in(const FoundAutosave& found) {
    const auto track = load_track(files, found.info.track);
    return track ? track->document.name : track.status().message;
  }
  // A process that autosaves the given number of times and ends as by a crash.
  void crash(const std::string& name, const std::string& original, int times, std::int64_t time) {
    crash_after([&](Autosave& own) {
      for (int i = 0; i < times; ++i) (void)own.write(files, folder, document_named(name), original, time);
    });
  }
  template <class Work>
  void crash_after(Work work) {
    const pid_t child = ::fork();
    if (child < 0) std::abort();  // kill(-1) would end every process
    if (child == 0) {
      Autosave own;
      work(own);
      ::kill(::getpid(), SIGKILL);
    }
    ::waitpid(child, nullptr, 0);
  }

  test::ScratchFolder scratch;
  fs::path folder = scratch.path() / "autosaves";
  base::Files files;
};

TEST_F(autosave, what_a_crashed_program_left_is_found_with_all_that_is_known_the_newest_first) {
  fs::create_directories(folder);
  std::ofstream(folder / "track.json") << "x";
  crash("older", "", 1, 1000);
  crash("newer", (folder / "track.json").string(), 3, 2000);
  const auto found = find_autosaves(files, folder);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(name_in(found[0]), "newer");
  EXPECT_EQ(found[0].info.original, (folder / "track.json").string());
  EXPECT_EQ(found[0].info.time, 2000);
  EXPECT_GT(found[0].file_time, 1'600'000'000);
  EXPECT_EQ(name_in(found[1]), "older");
  EXPECT_EQ(found[1].file_time, 0);
}

TEST_F(autosave, that_of_a_running_program_is_not_found) {
  Autosave own;
  ASSERT_TRUE(own.write(files, folder, document_named("mine"), "", 1));
  EXPECT_TRUE(find_autosaves(files, folder).empty());
  EXPECT_TRUE(own.exists());
}

TEST_F(autosave, who_has_found_one_keeps_it_from_others_until_it_is_let_go) {
  crash("one", "", 1, 1);
  {
    const auto first = find_autosaves(files, folder);
    ASSERT_EQ(first.size(), 1u);
    EXPECT_TRUE(find_autosaves(files, folder).empty());
  }
  auto again = find_autosaves(files, folder);
  ASSERT_EQ(again.size(), 1u);
  discard(files, again.front());
  EXPECT_EQ(entries(), 0u);
}

TEST_F(autosave, writing_again_leaves_one_and_removing_none) {
  Autosave own;
  for (const char* name : {"a", "b", "c"}) ASSERT_TRUE(own.write(files, folder, document_named(name), "", 1));
  EXPECT_EQ(entries(), 3u) << "the track, what it is, and the lock";
  own.remove();
  EXPECT_EQ(entries(), 0u);
  EXPECT_FALSE(own.exists());
}

TEST_F(autosave, each_failing_operation_leaves_the_one_before_readable) {
  for (std::size_t operation = 0; operation < base::kIoOperationNames.size(); ++operation)
    for (int nth = 1; nth <= 4; ++nth) {
      fs::remove_all(folder);
      const pid_t child = ::fork();  // it has to end for its autosave to be found
      if (child == 0) {
        base::Files faulty;
        Autosave own;
        const bool first = own.write(faulty, folder, document_named("first"), "", 1).ok();
        faulty.inject(static_cast<base::IoOperation>(operation), nth);
        (void)own.write(faulty, folder, document_named("second"), "", 2);
        faulty.inject(static_cast<base::IoOperation>(operation), 0);
        const bool third = own.write(faulty, folder, document_named("third"), "", 3).ok();
        faulty.inject(static_cast<base::IoOperation>(operation), nth);
        (void)own.write(faulty, folder, document_named("fourth"), "", 4);
        ::_exit(first && third ? 0 : 1);
      }
      int status = 0;
      ::waitpid(child, &status, 0);
      ASSERT_EQ(status, 0) << base::kIoOperationNames[operation] << " " << nth;
      const auto found = find_autosaves(files, folder);
      ASSERT_EQ(found.size(), 1u) << base::kIoOperationNames[operation] << " " << nth;
      const std::string name = name_in(found.front());
      EXPECT_TRUE(name == "third" || name == "fourth") << name;
      EXPECT_EQ(found.front().info.name, name) << "what it is said to be is what it is";
    }
}

TEST_F(autosave, what_a_crash_completes_replaces_the_one_before_and_is_removed_whole) {
  for (const bool earlier : {false, true}) {
    crash_after([&](Autosave& own) {
      (void)(earlier ? own.write(files, folder, document_named("before"), "", 1000) : own.reserve(files, folder));
      // As the handler of a crash does.
      for (base::CrashFile& file : crash_files(files, own.info(), document_named("at the crash"), "", 2000))
        (void)(file.file.write(file.text) && file.file.put_in_place());
    });
    auto found = find_autosaves(files, folder);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(name_in(found[0]), "at the crash");
    EXPECT_EQ(found[0].info.time, 2000);
    discard(files, found[0]);
    found.clear();
    EXPECT_EQ(entries(), 0u) << "the track before is removed, too";
  }
}

TEST_F(autosave, files_for_a_crash_that_does_not_come_leave_nothing) {
  Autosave own;
  ASSERT_TRUE(own.write(files, folder, document_named("before"), "", 1000));
  (void)crash_files(files, own.info(), document_named("later"), "", 2000);
  EXPECT_EQ(entries(), 3u) << "track, info file and its lock";
  EXPECT_TRUE(crash_files(files, folder / "no" / "4-1.info.json", document_named("later"), "", 2000).empty());
}

TEST_F(autosave, what_belongs_to_none_is_removed_and_what_cannot_be_read_stays) {
  fs::create_directories(folder);
  std::ofstream(folder / "1999999999-1.3.track.json") << "{}";
  std::ofstream(folder / "1999999998-1.info.json") << "garbage";
  std::ofstream(folder / "1999999998-1.1.track.json") << "{}";
  EXPECT_TRUE(find_autosaves(files, folder).empty());
  EXPECT_FALSE(fs::exists(folder / "1999999999-1.3.track.json"));
  EXPECT_TRUE(fs::exists(folder / "1999999998-1.info.json"));
  EXPECT_TRUE(fs::exists(folder / "1999999998-1.1.track.json"));
}

TEST_F(autosave, what_it_says_reads_back_and_names_no_other_folder) {
  const AutosaveInfo info{"1-1.1.track.json", "/a/\"b\".json", "n\n", 12345, 77, "0123456789abcdef"};
  const auto read = parse_autosave_info(print_autosave_info(info), "i");
  ASSERT_TRUE(read) << read.status().message;
  EXPECT_EQ(read->original, info.original);
  EXPECT_EQ(read->name, info.name);
  EXPECT_EQ(read->time, info.time);
  EXPECT_EQ(read->pid, 77);
  std::string evil = print_autosave_info(info);
  evil.replace(evil.find("1-1.1"), 0, "../");
  EXPECT_EQ(parse_autosave_info(evil, "i").status().code, base::Code::bad_file);
}

}  // namespace autosave_test
}  // namespace coaster::exchange
