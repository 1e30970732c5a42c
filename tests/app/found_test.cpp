// What a long job finds, as text.
#include "app/long_job.h"

#include <gtest/gtest.h>

#include "exchange/formats.h"
#include "sim/study/closing_replan.h"

namespace coaster::app {
namespace found_test {

// As a worker hands it over.
base::Result<JobResult> sent(const base::Result<JobResult>& found) { return parse_job_result(print_job_result(found)); }

TEST(found, a_track_arrives_whole) {
  base::Files files;
  auto track = exchange::load_track(files, std::filesystem::path(COASTER_SOURCE_DIR) / "tracks/loop.json");
  ASSERT_TRUE(track.ok());
  track->warnings = {"first: 1 2", "", "zweite\nZeile \xc3\xbc"};
  track->note = "The train completes the ride with a start speed of 0.1 m/s.";
  track->knows_speed = true;
  track->import = exchange::ImportReport{0.1, 1e-300, 7, 1.0 / 3, 12345.678901234567, 5e-324};
  track->content = 0xfedcba9876543210;
  track->version = 3;
  const base::Result<JobResult> arrived = sent(JobResult(*track));
  ASSERT_TRUE(arrived.ok()) << arrived.status().message;
  const auto& read = std::get<exchange::LoadedTrack>(*arrived);
  EXPECT_EQ(world::hash(read.document), world::hash(track->document));
  EXPECT_EQ(read.warnings, track->warnings);
  EXPECT_EQ(read.note, track->note);
  EXPECT_EQ(read.knows_speed, track->knows_speed);
  EXPECT_EQ(read.import, track->import);
  EXPECT_EQ(read.content, track->content);
  EXPECT_EQ(read.version, track->version);
}

TEST(found, a_search_and_a_failure_arrive_whole) {
  const edit::SeekResult sought{{0.1, -1.0 / 3, 1e300}, "ride.lap_time is 40 s."};
  const base::Result<JobResult> arrived = sent(JobResult(sought));
  ASSERT_TRUE(arrived.ok());
  EXPECT_EQ(std::get<edit::SeekResult>(*arrived).values, sought.values);
  EXPECT_EQ(std::get<edit::SeekResult>(*arrived).note, sought.note);
  const base::Status failed{base::Code::bad_file, "rows.csv:4: error: expected 13 numbers"};
  EXPECT_EQ(sent(failed).status(), failed);
  EXPECT_EQ(parse_job_result("6 failed1 55 grave").status(), (base::Status{base::Code::io, "grave"}))
      << "as a page's script writes it";
}

TEST(found, a_closing_section_arrives_with_what_a_command_needs) {
  sim::ClosingReplanResult way;
  way.closing = {.first = 180.1, .second = -1.0 / 3, .radius = 31, .level = true, .height = 1e-300, .coasts = false};
  way.another = true;
  for (const float x : {0.1f, -7e-20f}) {
    world::Knot& knot = way.fit.knots.emplace_back();
    knot.position = {x, 1 - x, 3e5f}, knot.in_length = x * 2, knot.spin = 0.123456789f;
    knot.joint = world::JointKind::aligned;
  }
  const base::Result<JobResult> arrived = sent(JobResult(way));
  ASSERT_TRUE(arrived.ok()) << arrived.status().message;
  const auto& read = std::get<sim::ClosingReplanResult>(*arrived);
  EXPECT_EQ(read.closing, way.closing);
  EXPECT_EQ(read.fit.knots, way.fit.knots);
  EXPECT_TRUE(read.another);
  EXPECT_EQ(
      std::get<sim::ClosingReplanResult>(*sent(JobResult(sim::ClosingReplanResult{.refusal = "no room"}))).refusal,
      "no room");
}

TEST(found, a_damaged_text_is_refused) {
  const std::string whole = print_job_result(JobResult(edit::SeekResult{{0.1, 2}, "a note"}));
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_FALSE(parse_job_result(whole.substr(0, size)).ok()) << size;
  EXPECT_FALSE(parse_job_result(whole + "1 x").ok());
  EXPECT_FALSE(parse_job_result("6 sought1 x99999999999 1").ok());
}

}  // namespace found_test
}  // namespace coaster::app
