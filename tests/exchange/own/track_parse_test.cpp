#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/hash.h"
#include "base/tries.h"
#include "exchange/bad_file.h"
#include "exchange/formats.h"
#include "exchange/own/track_file.h"
#include "world/element_rows.h"
#include "world/sample_documents.h"
#include "world/sections.h"

namespace coaster::exchange {
namespace track_parse_test {

std::string sample() { return print_track(test::sample_document()); }

std::string error_of(std::string_view text) {
  const auto loaded = parse_track(text, "t.json");
  return loaded ? "" : loaded.status().message;
}

// The sample with one piece of text replaced.
std::string with(const std::string& from, const std::string& to) {
  std::string text = sample();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  if (at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}
void expect_error(const std::string& text, std::string_view expected) {
  test::expect_bad_file(parse_track(text, "t.json"), "t.json", expected);
}

// A knot's line, all of it under the test's control.
std::string one_knot(const std::string& members) {
  return R"({"format":"coaster-track","version":1,"name":"n","closed":false,"start_speed":1,"datum":0,"knots":[{)" +
         members + R"(}],"segments":[],"carts":[]})";
}
constexpr const char* kGood =
    R"("id":"k1","position":[1,2,3],"tangent":[1,0,0],"up":[0,1,0],"in":5,"out":5,"joint":"smooth")";
std::string knot_with(const std::string& from, const std::string& to) {
  std::string members = kGood;
  members.replace(members.find(from), from.size(), to);
  return one_knot(members);
}

TEST(track_parse, a_file_written_by_hand_becomes_a_document) {
  const auto loaded = parse_track(R"({
    "format": "coaster-track", "version": 2, "name": "Two hills", "closed": false, "start_speed": 4, "datum": 0,
    "knots": [
      {"id": "k7", "position": [0, 12, 0], "tangent": [2, 0, 0], "up": [1, 1, 0], "in": 8, "out": 8, "joint": "smooth"},
      {"id": "k2", "position": [30, 3, 0], "tangent": [1, 0, 0], "up": [0, 1, 0], "in": 10, "out": 6, "joint": "aligned"}],
    "segments": [{"id": "s4", "from": "k7", "to": "k2", "turns": -2}],
    "carts": [{"id": "c3", "segment": "s4", "fraction": 0.25}]})",
                                  "t.json");
  ASSERT_TRUE(loaded) << loaded.status().message;
  const world::Document& d = loaded->document;
  EXPECT_EQ(world::broken_invariant(d), std::nullopt);
  EXPECT_TRUE(loaded->warnings.empty());
  const world::Knot& first = world::knot(d, world::find(d, {world::EntityKind::knot, 7}));
  EXPECT_EQ(first.tangent, glm::vec3(1, 0, 0));
  EXPECT_EQ(first.up, glm::vec3(0, 1, 0));
  EXPECT_EQ(d.last_number, (std::array<std::uint32_t, 4>{7, 4, 3, 1}));
  EXPECT_EQ(d.entities.get<world::Section>(world::segment(d, d.track.segments[0]).section), world::Section{});
  EXPECT_EQ(world::segment(d, d.track.segments[0]).turns, -2);
}

TEST(track_parse, every_truncation_is_refused_with_line_and_column) {
  const std::string text = sample();
  for (std::size_t size = 0; size + 2 < text.size();
       ++size) {  // the last two bytes are the closing brace and a newline
    const std::string error = error_of(std::string_view(text).substr(0, size));
    ASSERT_EQ(error.rfind("t.json:", 0), 0u) << size << ": " << error;
    ASSERT_TRUE(error.size() > 7 && error[7] >= '1' && error[7] <= '9') << size << ": " << error;
  }
  EXPECT_EQ(error_of(text), "");
}

TEST(track_parse, one_wrong_byte_never_crashes_and_never_breaks_an_invariant) {
  const std::string text = sample();
  int accepted = 0, k = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    for (const char c : {'\0', '"', '9', '-', '}', '\xff', 'e'}) {
      if (!test::tried(k++)) continue;
      std::string changed = text;
      changed[i] = c;
      const auto loaded = parse_track(changed, "t.json");
      if (!loaded) continue;
      ++accepted;
      ASSERT_EQ(world::broken_invariant(loaded->document), std::nullopt) << i;
    }
  }
  EXPECT_GT(accepted, test::tries(100));  // digits of positions and the like
}

TEST(track_parse, the_head_is_checked) {
  expect_error("[]", "t.json: error: expected an object, found an array of 0");
  expect_error("{}", "format: missing");
  expect_error(with("coaster-track", "other"), "format: expected \"coaster-track\", found \"other\"");
  expect_error(with("\"version\": 3", "\"version\": 5"), "version 5 is newer than this program supports (4)");
  expect_error(with("\"version\": 3", "\"version\": 0"), "version: expected a whole number");
  expect_error(with("\"version\": 3", "\"version\": 1.5"), "version: expected a whole number");
  expect_error(with("\"closed\": false", "\"closed\": 0"), "closed: expected true or false, found 0");
  expect_error(with("\"start_speed\": 3.3", "\"start_speed\": 151"), "start_speed: expected a number");
  expect_error(with("\"datum\": -1.7", "\"datum\": \"x\""), "datum: expected a number");
  expect_error(with("\"datum\": -1.7", "\"datum\": 1e999"), "1e999 is out of range");
  expect_error(with("\"datum\": -1.7", "\"datum\": NaN"), "t.json:");
  expect_error(with("\"knots\": [", "\"knots\": 3, \"x\": ["), "knots: expected an array, found 3");
}

TEST(track_parse, knots_are_checked) {
  EXPECT_EQ(error_of(one_knot(kGood)), "");
  expect_error(knot_with("\"k1\"", "\"s1\""), "knots[0].id: expected an id such as \"k3\", found \"s1\"");
  expect_error(knot_with("\"k1\"", "\"k0\""), "knots[0].id");
  expect_error(knot_with("\"k1\"", "1"), "knots[0].id: expected a text, found 1");
  expect_error(knot_with("\"k1\"", "\"k4000000000\""), "knots[0].id");
  expect_error(knot_with("[1,2,3]", "[1,2]"), "knots[0].position: expected 3 finite numbers, found an array of 2");
  expect_error(knot_with("[1,2,3]", "null"), "knots[0].position: expected 3 finite numbers, found null");
  expect_error(knot_with("[1,2,3]", "[1,null,3]"), "knots[0].position[1]: expected a finite number, found null");
  expect_error(knot_with("[1,2,3]", "[1,2,100001]"),
               "knots[0].position[2]: expected a number from -100000 to 100000, found 100001");
  expect_error(knot_with("[1,2,3]", "[1e39,2,3]"), "knots[0].position[0]");
  expect_error(knot_with("[1,0,0]", "[0,0,0]"), "knots[0].tangent: expected a vector with a direction");
  expect_error(knot_with("[1,0,0]", "[1e-300,0,0]"), "knots[0].tangent");
  expect_error(knot_with("[0,1,0]", "[0,0,0]"), "knots[0].up: expected a vector with a direction");
  expect_error(knot_with("[0,1,0]", "[-3,0,0]"), "knots[0].up: expected a vector that is not parallel");
  expect_error(knot_with("\"in\":5", "\"in\":0.009"),
               "knots[0].in: expected a length from 0.01 to 10000 m, found 0.009");
  expect_error(knot_with("\"out\":5", "\"out\":10001"), "knots[0].out: expected a length");
  expect_error(knot_with("\"out\":5", "\"out\":-5"), "knots[0].out: expected a length");
  expect_error(knot_with("\"in\":5", "\"in\":\"5\""), "knots[0].in: expected a length");
  expect_error(knot_with("\"in\":5", "\"in\":6"),
               "knots[0].joint: a smooth joint has equal handle lengths, found in 6 and out 5");
  expect_error(knot_with("\"smooth\"", "\"sharp\""),
               "knots[0].joint: expected \"smooth\", \"aligned\" or \"automatic\"");
  expect_error(knot_with("\"in\":5,", ""), "knots[0].in: missing");
  expect_error(knot_with("\"in\":5,", "\"in\":5,\"in\":5,"), "knots[0]: member \"in\" appears twice");
  expect_error(with("\"id\": \"k4\"", "\"id\": \"k2\""), "knots[3].id: \"k2\" is already used");
  EXPECT_EQ(error_of(knot_with("\"in\":5,\"out\":5", "\"in\":0.01,\"out\":0.01")), "");
  EXPECT_EQ(error_of(knot_with("\"in\":5,\"out\":5", "\"in\":10000,\"out\":10000")), "");
}

TEST(track_parse, segments_must_follow_the_order_of_the_knots) {
  expect_error(with("\"from\": \"k2\"", "\"from\": \"k3\""),
               "segments[1].from: expected \"k2\" (segments follow the order of the knots), found \"k3\"");
  expect_error(with("\"to\": \"k5\"", "\"to\": \"k9\""), "segments[3].to: expected \"k5\"");
  expect_error(with("\"closed\": false", "\"closed\": true"),
               "segments: expected 5 for 5 knots of a closed track, found an array of 4");
  expect_error(with("\"turns\": -1", "\"turns\": 17"),
               "segments[2].turns: expected a whole number from -16 to 16, found 17");
  expect_error(with("\"turns\": -1", "\"turns\": 0.5"), "segments[2].turns");
  expect_error(with("\"id\": \"s3\"", "\"id\": \"s1\""), "segments[2].id: \"s1\" is already used");
  std::string closed_alone = one_knot(kGood);
  closed_alone.replace(closed_alone.find("false"), 5, "true");
  expect_error(closed_alone, "closed: a closed track has at least 2 knots");
}

TEST(track_parse, sections_are_checked) {
  constexpr const char* kOne = R"({"id": "q1", "segments": 4, "kind": "free"})";
  const auto sections = [&](const std::string& lines) { return with(kOne, lines); };
  const auto one = [&](const std::string& members) {
    return sections(R"({"id": "q7", "segments": 4, )" + members + "}");
  };
  EXPECT_EQ(error_of(one(R"("kind": "helix")")), "");
  EXPECT_EQ(error_of(one(R"("kind": "helix", "side": "right", "turns": 0.25, "title": "")")), "");
  expect_error(with("\"sections\":", "\"parts\":"), "sections: missing; expected an array");
  expect_error(sections(""), "sections: expected 4 segments in all, found 0");
  expect_error(sections(R"({"id": "q1", "segments": 3, "kind": "free"})"),
               "sections: expected 4 segments in all, found 3");
  expect_error(sections(R"({"id": "q1", "segments": 5, "kind": "free"})"),
               "sections[0].segments: expected at most the 4 segments that are left, found 5");
  expect_error(sections(R"({"id": "q1", "segments": 4, "kind": "free"}, {"id": "q2", "segments": 1, "kind": "free"})"),
               "sections[1].segments: expected at most the 0 segments");
  expect_error(sections(R"({"id": "q1", "segments": 0, "kind": "free"})"), "sections[0].segments: expected a whole");
  expect_error(sections(R"({"id": "s1", "segments": 4, "kind": "free"})"),
               "sections[0].id: expected an id such as \"q3\", found \"s1\"");
  expect_error(sections(R"({"id": "q1", "segments": 2, "kind": "free"}, {"id": "q1", "segments": 2, "kind": "free"})"),
               "sections[1].id: \"q1\" is already used");
  expect_error(one(R"("kind": "spiral")"), "sections[0].kind: expected \"free\", \"straight\", ");
  for (const std::string kind : {"free", "curve", "helix", "brake_run", "complete", "force"})
    EXPECT_NE(error_of(one(R"("kind": "spiral")")).find('"' + kind + '"'), std::string::npos) << kind;
  expect_error(one(R"("kind": "loop", "side": "up")"),
               "sections[0].side: expected \"left\" or \"right\", found \"up\"");
  expect_error(one(R"("kind": "loop", "height": 101)"),
               "sections[0].height: expected a number from 3 to 100, found 101");
  constexpr const char* kProposal = R"("kind": "complete", "first": 90, "second": -90, "radius": 20, "before": 0,
      "after": 5, "level": true, "height": 12, "tight": false, "speed": 14, "coasts": true)";
  EXPECT_EQ(error_of(one(kProposal)), "");
  expect_error(one(R"("kind": "complete")"), "sections[0].first: missing; expected a number");
  const auto way_with = [&](std::string_view before, std::string_view after) {
    std::string way(kProposal);
    return one(way.replace(way.find(before), before.size(), after));
  };
  expect_error(way_with("-90", "-721"), "sections[0].second: expected a number from -720 to 720, found -721");
  expect_error(way_with("true", "1"), "sections[0].level: expected true or false, found 1");
  expect_error(one(R"("kind": "free", "title": "a\nb")"), "sections[0].title: expected a line of at most 200 bytes");
  expect_error(one(R"("kind": "free", "title": ")" + std::string(201, 'x') + "\""), "sections[0].title");
}

TEST(track_parse, the_samples_of_all_versions_open) {
  const auto sample_of = [](int version) {
    base::Files files;
    const auto loaded = load_track(files, fmt::format("{}/tests/tracks/version_{}.json", COASTER_SOURCE_DIR, version));
    EXPECT_TRUE(loaded) << loaded.status().message;
    EXPECT_EQ(loaded->version, version);
    EXPECT_TRUE(loaded->warnings.empty());
    EXPECT_EQ(loaded->document.track.knots.size(), 3u);
    return loaded->document;
  };
  for (const int version : {1, 2}) {
    const world::Document d = sample_of(version);
    ASSERT_EQ(world::sections_of(d).size(), 1u);
    EXPECT_EQ(world::section(d, world::sections_of(d)[0].section), world::Section{});
  }
  EXPECT_EQ(base::hex16(world::hash(sample_of(1))), "02344b93f6f5af73");
  EXPECT_EQ(base::hex16(world::hash(sample_of(2))), "b79461c039cf1013");
  const world::Document d = sample_of(3);
  const std::vector<world::SectionRun> runs = world::sections_of(d);
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(world::label_of(d, runs[0].section), "q4");
  EXPECT_EQ(world::title_of(world::section(d, runs[0].section)), "D\u00e9part");
  const world::Section& loop = world::section(d, runs[1].section);
  EXPECT_EQ(loop.element, (world::Element{world::ElementKind::loop, true, {18.5, 90, 4}}));
  EXPECT_EQ(base::hex16(world::hash(d)), "86c2ef1d14f0cbed");
}

TEST(track_parse, carts_are_checked) {
  expect_error(with("\"segment\": \"s2\"", "\"segment\": \"s12\""), "carts[0].segment: there is no segment \"s12\"");
  expect_error(with("\"segment\": \"s2\"", "\"segment\": \"k2\""), "carts[0].segment: expected an id such as \"s3\"");
  expect_error(with("\"fraction\": 0.37", "\"fraction\": 1"), "carts[0].fraction");
  expect_error(with("\"fraction\": 0.37", "\"fraction\": -0.1"),
               "carts[0].fraction: expected a number from 0 to 1, found -0.1");
  expect_error(with("\"id\": \"c2\"", "\"id\": \"c1\""), "carts[1].id: \"c1\" is already used");
}

TEST(track_parse, unknown_members_are_kept_and_warned_about) {
  std::string text = with("\"turns\": -1", "\"turns\": -1, \"wear\": {\"a\": [1.25, \"\\u00e9\"]}");
  text.replace(text.find("\"name\""), 6, "\"maker\": [\"Zoë\"], \"name\"");
  const auto loaded = parse_track(text, "t.json");
  ASSERT_TRUE(loaded) << loaded.status().message;
  ASSERT_EQ(loaded->warnings.size(), 2u);
  EXPECT_EQ(loaded->warnings[0], "t.json: warning: segments[2]: unknown member \"wear\" is kept");
  const std::string again = print_track(loaded->document);
  EXPECT_NE(again.find("\"wear\": {\"a\":[1.25,\"é\"]}"), std::string::npos) << again;
  EXPECT_NE(again.find("\"maker\": [\"Zoë\"]"), std::string::npos);
}

// A name of a megabyte took more than a minute to show.
TEST(track_parse, a_long_name_is_cut_between_characters_with_a_warning) {
  const std::string start(199, 'n');
  for (const auto& [name, wanted] : {std::pair{start + "n", start + "n"}, std::pair{start + "\u00e9", start},
                                     std::pair{std::string(1'000'000, 'n'), start + "n"}}) {
    world::Document d = test::sample_document();
    d.name = name;
    const auto loaded = parse_track(print_track(d), "t.json");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_EQ(loaded->document.name, wanted);
    const std::vector<std::string> warned{"t.json: warning: name: cut to 200 bytes"};
    EXPECT_EQ(loaded->warnings, name == wanted ? std::vector<std::string>() : warned);
  }
}

TEST(track_parse, warnings_are_few_however_many_members_are_unknown) {
  std::string members = kGood;
  for (int i = 0; i < 1000; ++i) members += ",\"x" + std::to_string(i) + "\":0";
  const auto loaded = parse_track(one_knot(members), "t.json");
  ASSERT_TRUE(loaded);
  EXPECT_EQ(loaded->warnings.size(), 21u);
  EXPECT_EQ(loaded->warnings.back(), "t.json: warning: and 980 more unknown members are kept");
}

TEST(track_parse, automatic_joints_are_settled) {
  const auto loaded = parse_track(with("\"joint\": \"aligned\"", "\"joint\": \"automatic\""), "t.json");
  ASSERT_TRUE(loaded);
  world::Document d = loaded->document;
  world::settle_joints(d);
  EXPECT_TRUE(d == loaded->document);
  EXPECT_NE(world::knot(d, d.track.knots[1]).tangent, world::knot(test::sample_document(), d.track.knots[1]).tangent);
}

}  // namespace track_parse_test
}  // namespace coaster::exchange
