#include "world/force_program.h"

#include <gtest/gtest.h>

#include "exchange/own/track_file.h"
#include "world/sample_documents.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::world {
namespace force_program_test {

ForceProgram sample() {
  ForceProgram program;
  program.over = ForceDomain::time, program.length = 3.5, program.tolerance = 0.1, program.speed = 21.25;
  program.keys(ForceChannel::vertical) = {{0, 1}, {1.25, 3.5, 0.5, 0.25, 0.125}, {3, 0.75}};
  program.keys(ForceChannel::roll) = {{0.5, -60, 0, 0, 0.5}, {2, 0}};
  return program;
}

Document with(const ForceProgram& program) {
  Document document = test::sample_document();
  make_section(document, 0, 2, {"Hop", SectionKind::force, {}, {}, program});
  return document;
}

// Each changes a program so that it is another one within the limits.
const auto kChanges = [] {
  std::vector<void (*)(ForceProgram&)> changes;
  changes.push_back([](ForceProgram& p) { p.over = ForceDomain::distance; });
  changes.push_back([](ForceProgram& p) { p.length = 3.25; });
  changes.push_back([](ForceProgram& p) { p.tolerance = 0.2; });
  changes.push_back([](ForceProgram& p) { p.speed += 1e-9; });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::lateral) = {{1, 0}}; });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::vertical).pop_back(); });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::vertical)[1].at += 1e-9; });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::vertical)[1].value += 1e-9; });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::vertical)[1].slope += 1e-9; });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::vertical)[1].before += 1e-9; });
  changes.push_back([](ForceProgram& p) { p.keys(ForceChannel::vertical)[1].after += 1e-9; });
  return changes;
}();

TEST(force, every_number_counts_in_hashes_and_is_kept_in_files) {
  const std::uint64_t before = hash(with(sample()));
  for (std::size_t i = 0; i < kChanges.size(); ++i) {
    ForceProgram program = sample();
    kChanges[i](program);
    const bool apart = program.over == ForceDomain::time;  // keys 0.25 s apart are too near in metres
    if (!apart) program.length = 30, program.channels = {};
    ASSERT_EQ(broken(program), std::nullopt) << i;
    const Document document = with(program);
    EXPECT_EQ(broken_invariant(document), std::nullopt) << i;
    EXPECT_NE(hash(document), before) << i;
    const auto loaded = exchange::parse_track(exchange::print_track(document), "text");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_EQ(hash(loaded->document), hash(document)) << i;
    EXPECT_EQ(section(loaded->document, sections_of(loaded->document)[0].section).force, program) << i;
  }
}

TEST(force, files_with_bad_programs_are_refused_with_the_reason) {
  const std::string text = exchange::print_track(with(sample()));
  const auto refused = [&](const std::string& from, const std::string& to, const std::string& why) {
    std::string bad = text;
    ASSERT_NE(bad.find(from), std::string::npos) << from;
    bad.replace(bad.find(from), from.size(), to);
    const auto loaded = exchange::parse_track(bad, "text");
    ASSERT_FALSE(loaded) << to;
    EXPECT_NE(loaded.status().message.find(why), std::string::npos) << loaded.status().message;
  };
  refused("[0, 1]", "[0]", "vertical[0]: expected 2 or 5 numbers");
  refused("[0, 1]", "[0, \"1\"]", "vertical[0]: expected 2 or 5 numbers");
  refused("[0, 1]", "[1.22, 1]", "vertical has two keys within 0.05 s at 1.25 s");
  refused("[0, 1]", "[2, 1]", "the keys of vertical do not ascend: 1.25 s follows 2");
  refused("[0, 1]", "[0, 11]", "has the value 11 g, expected -10 to 10");
  refused("\"length\": 3.5", "\"length\": 100", "the length is 100 s, expected 0.2 to 60");
  refused("\"length\": 3.5, ", "", "length: missing");
  refused("\"over\": \"time\"", "\"over\": \"space\"", "expected \"distance\" or \"time\"");
  std::string many = "[0, 1]";
  for (int i = 0; i < 10'000; ++i) many += ", [0, 1]";
  refused("[0, 1]", many, "more than the limit of 200");
}

TEST(force, sections_without_a_program_have_none_and_others_within_the_limits) {
  Document document = with(sample());
  Section& value = document.entities.get<Section>(sections_of(document)[0].section);
  value.kind = SectionKind::free;
  EXPECT_NE(broken_invariant(document), std::nullopt);
  value.kind = SectionKind::force, value.force.length = std::nan("");
  EXPECT_NE(broken_invariant(document), std::nullopt);
}

TEST(force, handles_never_cross) {
  const ForceKey a{0, 1, 0.5, 0, 9}, b{10, 2, -0.5, 9, 0};
  const auto p = curve_between(a, b);
  EXPECT_NEAR(p[1].x, 5, 1e-12);
  EXPECT_NEAR(p[2].x, 5, 1e-12);
  EXPECT_NEAR(p[1].y, 1 + 5 * 0.5, 1e-12) << "along the same line";
  const auto usual = curve_between({0, 1}, {9, 2});
  EXPECT_EQ(usual[1], glm::dvec2(3, 1));
  EXPECT_EQ(usual[2], glm::dvec2(6, 2));
}

// Before the first key and behind the last a channel keeps their values, so it is level there.
TEST(force, curves_begin_and_end_level_where_keys_leave_room) {
  ForceProgram program;
  program.length = 40;
  program.keys(ForceChannel::vertical) = {{5, 1, 0.3, 2, 2}, {20, 2, 0.2, 2, 2}, {35, 3, 0.1, 2, 2}};
  const auto slopes = [&] {
    std::vector<double> out;
    for (const ForceKey& key : shaping_keys(program, ForceChannel::vertical)) out.push_back(key.slope);
    return out;
  };
  EXPECT_EQ(slopes(), (std::vector<double>{0, 0.2, 0}));
  program.keys(ForceChannel::vertical).front().at = 0, program.keys(ForceChannel::vertical).back().at = 40;
  EXPECT_EQ(slopes(), (std::vector<double>{0.3, 0.2, 0.1}));
}

}  // namespace force_program_test
}  // namespace coaster::world
