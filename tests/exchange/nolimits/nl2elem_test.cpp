#include "exchange/nolimits/nl2elem.h"

#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_rule.h"
#include "exchange/nolimits/nl2_spline.h"
#include "sim/tracks.h"

namespace coaster::exchange {
namespace nl2elem_test {

using glm::dvec3;

using Vertex = test::RuleVertex;
using test::encode;

std::vector<Vertex> wandering(std::mt19937& bits, std::size_t count, double strict_share) {
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  std::vector<Vertex> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 12.3 + 9.7 * static_cast<double>(i), y = uniform(3, 9), z = uniform(-5, 5);
    all.push_back({{x, y, z}, uniform(0, 1) < strict_share});
  }
  return all;
}

// Strict vertices that are in line with their neighbours, so that the curve has no corner there.
void straighten(std::vector<Vertex>& vertices) {
  for (std::size_t i = 1; i + 1 < vertices.size(); ++i)
    if (vertices[i].strict && !vertices[i - 1].strict)
      vertices[i + 1].p = vertices[i].p + 0.83 * (vertices[i].p - vertices[i - 1].p);
    else if (vertices[i].strict) vertices[i + 1].p = vertices[i].p + 1.3 * (vertices[i].p - vertices[i - 1].p);
}

// The segments are the rule's pieces one by one, at equal parameters. Places up to 400 m round by 1.5e-5 m, tangents
// turn handles by 1e-7.
void expect_by_the_rule(const world::Document& d, const std::vector<Vertex>& vertices) {
  const std::vector<test::RuleSpan> spans = test::rule_spans(vertices);
  ASSERT_EQ(d.track.segments.size(), spans.size());
  for (std::size_t i = 0; i < spans.size(); ++i)
    for (int k = 0; k <= 8; ++k)
      ASSERT_LT(glm::distance(curve::point(world::cubic_of(d, d.track.segments[i]), k / 8.0), spans[i].at(k / 8.0)),
                5e-5)
          << vertices.size() << " vertices, segment " << i << ", " << k << "/8";
}

TEST(nl2elem, a_run_is_a_clamped_b_spline_to_rounding) {
  std::mt19937 bits(2);
  for (const std::size_t count : {2, 3, 4, 5, 6, 7, 20, 40}) {
    std::vector<Vertex> vertices = wandering(bits, count, 0);
    for (const bool strict_ends : {false, true}) {
      vertices.front().strict = vertices.back().strict = strict_ends;
      const auto loaded = parse_nl2elem(encode(vertices), "made.nl2elem");
      ASSERT_TRUE(loaded) << loaded.status().message;
      const world::Document& d = loaded->document;
      EXPECT_EQ(d.track.segments.size(), count < 5 ? 1 : count - 3);
      EXPECT_EQ(d.name, "made");
      EXPECT_EQ(world::broken_invariant(d), std::nullopt);
      EXPECT_TRUE(loaded->warnings.empty());
      ASSERT_TRUE(loaded->import);
      EXPECT_EQ(loaded->import->knots, static_cast<int>(d.track.knots.size()));
      EXPECT_LT(loaded->import->max_error, 5e-5);
      expect_by_the_rule(d, vertices);
    }
  }
}

TEST(nl2elem, strict_vertices_end_runs_and_neighbours_are_joined_by_a_line) {
  std::mt19937 bits(3);
  for (const double share : {0.1, 0.3, 0.6}) {
    std::vector<Vertex> vertices = wandering(bits, 24, share);
    straighten(vertices);
    const auto loaded = parse_nl2elem(encode(vertices), "x");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_TRUE(loaded->warnings.empty()) << loaded->warnings.front();
    expect_by_the_rule(loaded->document, vertices);
    EXPECT_LT(loaded->import->max_error, 1e-4);
  }
  // Without the vertex between them, two strict ones are neighbours; their cubic is straight, at an even speed.
  const auto line = parse_nl2elem(encode({{{1.3, 4, 2}, true}, {{9.7, 6, -3}, true}}), "x");
  ASSERT_TRUE(line);
  const curve::Cubic cubic = world::cubic_of(line->document, line->document.track.segments[0]);
  EXPECT_LT(glm::distance(curve::point(cubic, 0.25), dvec3(3.4, 4.5, 0.75)), 1e-5);
  EXPECT_LT(curve::curvature(cubic, 0.3), 1e-6);
}

TEST(nl2elem, a_tag_of_very_many_attributes_is_refused_at_once) {
  std::string many = "<root>\n<element";
  for (int i = 0; i < 300'000; ++i) many += " a" + std::to_string(i) + "='>\"'";
  const auto loaded = parse_nl2elem(many + "/>\n</root>", "x");
  EXPECT_EQ(loaded.status().message, "x:2: error: expected tags of at most 4096 bytes, found a longer one");
  const std::string comment = "<root><!-- " + std::string(9000, '-') + " --><element a='1'/></root>";
  EXPECT_EQ(parse_nl2elem(comment, "x").status().message.find("4096"), std::string::npos);
}

TEST(nl2elem, a_last_vertex_on_the_first_closes_the_track) {
  // Through the middles of a square's sides, strict, where the sides are tangents: no corner, not at the seam either.
  std::vector<Vertex> ring{{{31.7, 8.3, 0}, true},  {{31.7, 8.3, 30}},       {{1.7, 8.3, 30}, true},
                           {{-28.3, 8.3, 30}},      {{-28.3, 8.3, 0}, true}, {{-28.3, 8.3, -30}},
                           {{1.7, 8.3, -30}, true}, {{31.7, 8.3, -30}},      {{31.7, 8.3, 0}, true}};
  const auto loaded = parse_nl2elem(encode(ring), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_TRUE(loaded->document.track.closed);
  EXPECT_TRUE(loaded->warnings.empty());
  EXPECT_EQ(loaded->document.track.knots.size(), 4u);
  expect_by_the_rule(loaded->document, ring);
  // One run from a vertex back to it: a corner, and two knots even so.
  const auto drop = parse_nl2elem(encode({{{0, 5, 0}, false}, {{30, 5, 9}}, {{30, 5, -30}}, {{0, 5, 0}}}), "x");
  EXPECT_FALSE(drop.ok());
  EXPECT_NE(drop.status().message.find("degrees at vertex 1"), std::string::npos) << drop.status().message;
  const auto bean = parse_nl2elem(
      encode({{{0, 5, 0}}, {{30, 5, 9}}, {{30, 5, -30}}, {{-30, 5, -30}}, {{-30, 5, 0}}, {{0, 5, 0}}}), "x");
  ASSERT_TRUE(bean) << bean.status().message;
  EXPECT_TRUE(bean->document.track.closed);
  EXPECT_EQ(bean->warnings.size(), 1u);
  EXPECT_EQ(bean->document.track.knots.size(), 4u);
}

TEST(nl2elem, handles_out_of_bounds_are_lengthened_or_the_segment_is_halved) {
  const auto tiny = parse_nl2elem(encode({{{0, 5, 0}, true}, {{0.02, 5, 0}, true}, {{9, 5, 0}, true}}), "x");
  ASSERT_TRUE(tiny);
  ASSERT_EQ(tiny->warnings.size(), 1u);
  EXPECT_NE(tiny->warnings[0].find("2 handles shorter than 0.01 m"), std::string::npos) << tiny->warnings[0];
  const std::vector<Vertex> vast{{{-9e4, 5, 0}}, {{9e4, 5, 0}}, {{9e4, 5, 9e4}}};
  const auto halved = parse_nl2elem(encode(vast), "x");
  ASSERT_TRUE(halved) << halved.status().message;
  EXPECT_GT(halved->document.track.segments.size(), 8u) << "each is at most 30 km long";
  EXPECT_LT(halved->import->max_error, 0.02) << "positions round by 4 mm there";
}

dvec3 tilted(double degrees) { return {0, std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180)}; }

// Through 0, 0, 60 and 60 degrees at thirds of the length the spline's rates are 0, r, r and 0 with 5 r = 3 * 60 a
// third.
TEST(nl2elem, four_rolls_on_a_straight_are_joined_by_the_clamped_spline) {
  std::vector<Vertex> straight;
  for (int i = 0; i < 10; ++i) straight.push_back({{10.0 * i, 5, 0}});
  // Unordered, as files may have them; 420 degrees are 60.
  const auto loaded = parse_nl2elem(
      encode(straight, {{1, tilted(420)}, {0, tilted(0)}, {2 / 3.0, tilted(60)}, {1 / 3.0, tilted(0)}}), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  EXPECT_TRUE(loaded->warnings.empty());
  EXPECT_EQ(loaded->document.track.knots.size(), 8u) << "none is added where a span ends at a roll";
  EXPECT_LT(loaded->import->frame_error, 1e-3);
  const sim::DerivedTrack derived = test::derived_of(loaded->document);
  for (int k = 0; k <= 900; ++k) {
    const double u = k / 300.0, in = u - std::clamp(std::ceil(u) - 1, 0.0, 2.0), rest = 1 - in, rate = 3 * 60 / 5.0;
    const double wanted = u <= 1   ? -rate * in * in * rest
                          : u <= 2 ? 60 * in * in * (3 - 2 * in) + in * rest * (rest - in) * rate
                                   : 60 + rate * in * rest * rest;
    const dvec3 up = place_on(derived, 0.1 * k).frame.up;
    EXPECT_NEAR(std::atan2(up.z, up.y) * 180 / M_PI, wanted, 0.02) << k;
  }
}

// Every frame of tracks through random vertices and few rolls, against curve, lengths, frames of least rotation and
// spline of the rule. Closed tracks have a roll at the seam, or none: then the spline is that of many laps.
TEST(nl2elem, few_rolls_give_the_frames_of_the_rule) {
  std::mt19937 bits(12);
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  for (int run = 0; run < 12; ++run) {
    const bool closed = run % 3 > 0, seam = run % 3 < 2;
    std::vector<Vertex> vertices = wandering(bits, 9, 0);
    if (closed) {
      vertices.clear();
      for (int i = 0; i <= 12; ++i) {
        const double a = i * M_PI / 6;
        vertices.push_back({{40 * std::cos(a), i % 12 ? uniform(4, 14) : 9, 40 * std::sin(a)}});
      }
      vertices[1].p = {vertices[0].p.x + 5, 9, 20}, vertices[11].p = {vertices[0].p.x - 5, 9, -20};
    }
    const std::vector<test::RuleFrame> frames = test::rule_frames(vertices, 3000);
    const double length = frames.back().s;
    std::vector<std::pair<double, dvec3>> rolls;
    std::vector<bool> strict;
    std::vector<double> s, angle;
    const int count = 5;
    for (int i = 0; i < count; ++i) {
      const bool end = seam && (i == 0 || i + 1 == count);
      const double coord =
          seam ? (end ? i / (count - 1.0) : (i + uniform(-0.3, 0.3)) / (count - 1)) : (i + uniform(0.2, 0.8)) / count;
      const auto frame = std::lower_bound(frames.begin(), frames.end() - 1, coord * length,
                                          [](const test::RuleFrame& f, double at) { return f.s < at; });
      const dvec3 level = glm::normalize(dvec3(0, 1, 0) - frame->forward.y * frame->forward);
      const dvec3 up = closed && end ? level : curve::rotate(level, frame->forward, uniform(-1.2, 1.2));
      rolls.emplace_back(coord, up), strict.push_back(!end && i == 2 && run % 2 == 1);
      s.push_back(coord * length);
      angle.push_back(curve::signed_angle(frame->up, up, frame->forward));
      if (i > 0) angle.back() += 2 * M_PI * std::round((angle[angle.size() - 2] - angle.back()) / (2 * M_PI));
    }
    const auto loaded = parse_nl2elem(encode(vertices, rolls, strict), "x");
    ASSERT_TRUE(loaded) << loaded.status().message;
    // Spins match rolls within 0.05 degrees along the vertices' curve; the document's own lengths move them a little.
    EXPECT_LT(loaded->import->frame_error, 0.1);
    if (closed && !seam) {
      double lap = curve::signed_angle(frames.back().up, frames.front().up, frames.front().forward);
      lap += 2 * M_PI * std::round((angle.back() - angle.front() - lap) / (2 * M_PI));
      const std::vector<double> places = s, angles = angle;
      const std::vector<bool> are = strict;
      s.clear(), angle.clear(), strict.clear();
      for (int k = -4; k <= 4; ++k)
        for (std::size_t i = 0; i < places.size(); ++i)
          s.push_back(places[i] + k * length), angle.push_back(angles[i] + k * lap), strict.push_back(are[i]);
    }
    const test::RuleRollSpline rule(s, angle, strict);
    const sim::DerivedTrack derived = test::derived_of(loaded->document);
    for (std::size_t i = 0; i < frames.size(); i += 37) {
      const test::RuleFrame& f = frames[i];
      const PlaceOnTrack at = place_on(derived, f.s * derived.length / length * (1 - 1e-9));
      const dvec3 wanted = curve::rotate(f.up, f.forward, rule.angle(f.s));
      ASSERT_LT(curve::angle_between(at.frame.up, wanted) * 180 / M_PI, 0.15) << run << ", " << f.s << " m";
    }
  }
}

TEST(nl2elem, rolls_that_the_track_meets_anyway_add_no_knot_and_whole_turns_are_counted) {
  std::vector<std::pair<double, dvec3>> rolls;
  const auto up = [](double degrees) {
    return dvec3(0, std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
  };
  // 800 degrees at an even rate over the first half, then none.
  for (int i = 0; i <= 40; ++i) rolls.emplace_back(i / 40.0, up(i < 20 ? 40.0 * i : 800.0));
  const auto loaded = parse_nl2elem(encode({{{1.3, 7, 2}}, {{41.3, 7, 2}}}, rolls), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  const world::Document& d = loaded->document;
  ASSERT_LE(d.track.knots.size(), 14u) << "the spline rings where the rate starts, changes and ends";
  const sim::DerivedTrack derived = test::derived_of(d);
  EXPECT_NEAR(std::abs(derived.twists.back()) * 180 / M_PI, 800, 1e-3);
  EXPECT_LT(loaded->import->frame_error, 0.05);
  // 20 turns are over the limit of a segment.
  rolls.clear();
  for (int i = 0; i <= 80; ++i) rolls.emplace_back(i / 80.0, up(90.0 * i));
  const auto spun = parse_nl2elem(encode({{{1.3, 7, 2}}, {{41.3, 7, 2}}}, rolls), "x");
  ASSERT_TRUE(spun);
  EXPECT_LE(spun->document.track.knots.size(), 11u) << "one in the middle, the others at the ends, where it rings";
  EXPECT_LT(spun->import->frame_error, 0.05);
}

// Of the rolls within 3 cm of the seam, on either side, the nearest counts, whichever comes first in the file.
TEST(nl2elem, the_nearest_roll_counts_at_the_seam_of_a_closed_track) {
  std::vector<Vertex> ring;
  for (int i = 0; i <= 12; ++i) {
    const double a = i * M_PI / 6;
    ring.push_back({{40 * std::cos(a), 9, 40 * std::sin(a)}});
  }
  // In line at the seam, so that there is no corner.
  ring[1].p = {ring[0].p.x, 9, 20}, ring[11].p = {ring[0].p.x, 9, -20};
  const double length = test::rule_frames(ring, 3000).back().s;
  const auto lean = [](double degrees) {  // towards the middle
    return dvec3(-std::sin(degrees * M_PI / 180), std::cos(degrees * M_PI / 180), 0);
  };
  for (const auto& [before, behind] : {std::pair{0.02, 0.01}, {0.01, 0.02}, {0.005, 0.028}, {0.028, 0.005}}) {
    const double wanted = before < behind ? 35 : 10;
    for (const bool swapped : {false, true}) {
      std::vector<std::pair<double, dvec3>> rolls{{1 - before / length, lean(35)}, {behind / length, lean(10)}};
      if (swapped) std::swap(rolls[0], rolls[1]);
      const auto loaded = parse_nl2elem(encode(ring, rolls), "x");
      ASSERT_TRUE(loaded) << loaded.status().message;
      const world::Document& d = loaded->document;
      ASSERT_TRUE(d.track.closed);
      const glm::vec3 up = world::knot(d, d.track.knots.front()).up;
      EXPECT_NEAR(std::atan2(-up.x, up.y) * 180 / M_PI, wanted, 0.05) << before << ' ' << behind;
    }
  }
}

TEST(nl2elem, rolls_that_contradict_each_other_are_told_of) {
  const std::vector<Vertex> straight{{{1.3, 7, 2}}, {{41.3, 7, 2}}};
  const auto upright = parse_nl2elem(encode(straight, {{0.5, {0, 1, 0}}, {0.5, {0, 1, 0}}}), "x");
  ASSERT_TRUE(upright);
  EXPECT_TRUE(upright->warnings.empty());
  const auto both = parse_nl2elem(encode(straight, {{0.5, {0, 1, 0}}, {0.5, {0, 0, 1}}}), "x");
  ASSERT_TRUE(both);
  EXPECT_NEAR(both->import->frame_error, 90, 1e-3);
  ASSERT_EQ(both->warnings.size(), 1u);
  EXPECT_NE(both->warnings[0].find("the track is up to 90 degrees off the file's rolls"), std::string::npos)
      << both->warnings[0];
}

TEST(nl2elem, a_roll_whose_up_is_along_the_track_is_told_of) {
  std::vector<Vertex> vertical;
  for (int i = 0; i < 5; ++i) vertical.push_back({{3.1, 2.0 + 8 * i, -7.7}, false});
  const dvec3 level(0.6, 0, 0.8), upright(0, 1, 0);
  const auto sound = parse_nl2elem(encode(vertical, {{0.25, level}, {0.75, level}}), "x");
  ASSERT_TRUE(sound) << sound.status().message;
  EXPECT_TRUE(sound->warnings.empty()) << sound->warnings[0];
  const auto along =
      parse_nl2elem(encode(vertical, {{0.25, level}, {0.75, glm::normalize(0.6 * level + 0.8 * upright)}}), "x");
  ASSERT_TRUE(along) << along.status().message;
  ASSERT_EQ(along->warnings.size(), 1u);  // asin 0.8
  EXPECT_NE(along->warnings[0].find("the up of the roll at coord 0.75 is 53 degrees off perpendicular to the track"),
            std::string::npos)
      << along->warnings[0];
}

TEST(nl2elem, tags_in_any_case_and_numbers_around_comments_mean_the_same) {
  std::mt19937 bits(8);
  std::vector<Vertex> vertices = wandering(bits, 9, 0.3);
  straighten(vertices);
  const std::string text = encode(vertices);
  const auto expected = parse_nl2elem(text, "x");
  ASSERT_TRUE(expected) << expected.status().message;
  const auto with = [&](const std::vector<std::pair<std::string, std::string>>& changes) {
    std::string changed = text;
    for (const auto& [from, to] : changes)
      for (std::size_t at = changed.find(from, changed.find('\n')); at != std::string::npos;
           at = changed.find(from, at + to.size()))
        changed.replace(at, from.size(), to);
    EXPECT_NE(changed, text);
    const auto loaded = parse_nl2elem(changed, "x");
    ASSERT_TRUE(loaded) << loaded.status().message;
    EXPECT_TRUE(loaded->document == expected->document) << changed;
  };
  with({{"<vertex>", "<Vertex>"}, {"</vertex>", "</Vertex>"}});
  with({{"<strict>", "<STRICT>"}, {"</strict>", "</STRICT>"}, {"true", "True"}, {"false", "FALSE"}});
  with({{"<root>", "<Root>"}, {"</root>", "</Root>"}, {"<element>", "<ELEMENT>"}, {"</element>", "</ELEMENT>"}});
  with({{"<x>", "<X>"}, {"</x>", "</X>"}, {"<vertex>", "<vertex><!-- here -->"}});
  with({{".", "<!-- point -->."}});
}

TEST(nl2elem, bad_files_are_refused_with_line_and_reason) {
  const std::string vertex = "<vertex><x>1</x>\n<y>2</y>\n<z>3</z></vertex>\n",
                    other = "<vertex><x>9</x><y>2</y><z>3</z></vertex>\n";
  const auto with = [](const std::string& inner) { return "<root>\n<element>\n" + inner + "</element>\n</root>\n"; };
  const std::string frame = "<ux>0</ux><uy>1</uy><uz>0</uz><rx>0</rx><ry>0</ry><rz>1</rz>";
  const std::pair<std::string, std::string> cases[]{
      {"", "x:1: error: expected XML, found an empty file"},
      {"<root>\n<element>\n", "x:2: error: expected well-formed XML, found a tag that is not closed"},
      {"<a/>", "x:1: error: expected <root>"},
      {"<root>\n</root>", "x:1: error: expected <element>"},
      {with(""), "x:2: error: expected at least 2 vertices, found 0"},
      {with(vertex), "expected at least 2 vertices, found 1"},
      {with(vertex + "<vertex><x>1</x>\n<z>3</z></vertex>"), "x:6: error: expected <y> in <vertex>, found none"},
      {with(vertex + "<vertex><x>1</x>\n<x>1</x><y>2</y><z>3</z></vertex>"),
       "x:7: error: expected one <x>, found a second one"},
      {with(vertex + "<vertex><x>1</x>\n<y>two</y><z>3</z></vertex>"),
       "x:7: error: expected a finite number in <y>, found \"two\""},
      {with(vertex + "<vertex><x>nan</x><y>2</y><z>3</z></vertex>"), "x:6: error: expected a finite number in <x>"},
      {with(vertex + "<vertex><x>1e999</x><y>2</y><z>3</z></vertex>"), "x:6: error: expected a finite number in <x>"},
      {with(vertex + "<vertex><x>1e006</x><y>2</y><z>3</z></vertex>"),
       "x:6: error: expected a position within 100000 m in <x>"},
      {with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><strict>maybe</strict></vertex>"),
       "expected true or false in <strict>"},
      {with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><strict>false</strict>\n<Strict>true</Strict></vertex>"),
       "x:7: error: expected one <strict>, found a second one"},
      {with(vertex + "<vertex><x>1<b/>0</x><y>2</y><z>3</z></vertex>"),
       "x:6: error: expected a finite number in <x>, found \"1<b>0\""},
      {with(vertex + vertex), "x:3: error: expected vertices at different places, found all at one"},
      {with(vertex + "<vertex><x>5</x>\n<y>2</y><z>3</z><weight>0</weight></vertex>"),
       "x:7: error: expected a weight from 0.01 to 100 in <weight>, found \"0\""},
      {with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><w>nan</w></vertex>"),
       "expected a weight from 0.01 to 100 in <w>"},
      {with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><w>-1</w></vertex>"),
       "expected a weight from 0.01 to 100 in <w>"},
      {with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><w/></vertex>"), "expected a weight from 0.01 to 100 in <w>"},
      {with("<vertex><x>5</x><y>2</y><z>3</z><w>1e7</w></vertex>" + vertex),
       "x:3: error: expected a weight from 1e-06 to "},
      {with("<vertex><x>5</x><y>2</y><z>3</z><w>4</w></vertex>" + vertex +
            "<vertex W='401'><x>9</x><y>2</y><z>3</z></vertex>"),
       "x:6: error: expected a weight from 0.04 to 400 in the attribute W, found \"401\""},
      {with(vertex + "<vertex w='1'><x>5</x><y>2</y><z>3</z>\n<w>1</w></vertex>"),
       "x:7: error: expected one weight, found a second one"},
      {with(vertex + "<vertex\nvertexWeight=' 2'><x>5</x><y>2</y><z>3</z></vertex>"),
       "x:7: error: expected weights in <w> or <weight>, found the attribute vertexWeight of \"2\""},
      {with(vertex + other + "<roll>" + frame + "</roll>"), "x:7: error: expected <coord> in <roll>, found none"},
      {with(vertex + other + "<roll>" + frame + "<coord>1.5</coord></roll>"), "expected a number within 1 in <coord>"},
      {with(vertex + other + "<roll>" + frame + "<coord>-0.5</coord></roll>"), "expected a <coord> from 0 to 1"},
      {with(vertex + other +
            "<roll><ux>0</ux><uy>0.5</uy><uz>0</uz><rx>0</rx><ry>0</ry><rz>1</rz><coord>0</coord></roll>"),
       "expected unit vectors"},
      {with(vertex + other +
            "<roll><ux>0</ux><uy>1</uy><uz>0</uz><rx>0</rx><ry>1</ry><rz>0</rz><coord>0</coord></roll>"),
       "expected perpendicular vectors"},
  };
  for (const auto& [text, message] : cases) {
    const auto loaded = parse_nl2elem(text, "x");
    ASSERT_FALSE(loaded.ok()) << text;
    EXPECT_EQ(loaded.status().code, base::Code::bad_file);
    EXPECT_NE(loaded.status().message.find(message), std::string::npos) << loaded.status().message << "\nfor\n"
                                                                        << message;
    EXPECT_EQ(loaded.status().message.find('\n'), std::string::npos);
  }
  // A weight of 1 is no weight.
  EXPECT_TRUE(parse_nl2elem(with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><Weight>1.0</Weight></vertex>"), "x"));
  EXPECT_TRUE(parse_nl2elem(with(vertex + "<vertex w='1'><x>5</x><y>2</y><z>3</z></vertex>"), "x"));
  // Cut anywhere: refused or, within the end tags alone, an XML error all the same; never a crash.
  const std::string whole = with(vertex + other + "<roll>" + frame + "<coord>0</coord></roll>\n");
  ASSERT_TRUE(parse_nl2elem(whole, "x"));
  for (std::size_t cut = 0; cut + 8 < whole.size(); ++cut)
    EXPECT_FALSE(parse_nl2elem(std::string_view(whole).substr(0, cut), "x").ok()) << cut;
}

}  // namespace nl2elem_test
}  // namespace coaster::exchange
