#include "exchange/nolimits/nl2elem.h"

#include <gtest/gtest.h>

#include "exchange/nolimits/nl2_spline.h"
#include "sim/tracks.h"

namespace coaster::exchange {
namespace nl2elem_test {

using glm::dvec3;

struct Vertex {
  dvec3 p;
  bool strict = false;
};

// As NoLimits 2 writes on Windows: CRLF, exponents of three digits.
std::string number(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9e", x);
  std::string out = text;
  out.insert(out.find('e') + 2, "0");
  return out;
}

std::string encode(const std::vector<Vertex>& vertices, const std::vector<std::pair<double, dvec3>>& rolls = {}) {
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\r\n<root>\r\n<element>\r\n<description>made by "
      "hand</description>\r\n";
  for (const Vertex& v : vertices)
    out += "<vertex><x>" + number(v.p.x) + "</x><y>" + number(v.p.y) + "</y>\r\n<z> " + number(v.p.z) + " </z>" +
           (v.strict ? "<strict>true</strict>" : "") + "</vertex>\r\n";
  for (const auto& [coord, up] : rolls) {
    const dvec3 right = glm::normalize(glm::cross(std::abs(up.x) < 0.9 ? dvec3(1, 0, 0) : dvec3(0, 1, 0), up));
    out += "<roll><ux>" + number(up.x) + "</ux><uy>" + number(up.y) + "</uy><uz>" + number(up.z) + "</uz><rx>" +
           number(right.x) + "</rx><ry>" + number(right.y) + "</ry><rz>" + number(right.z) + "</rz>\r\n<coord>" +
           number(coord) + "</coord><strict>false</strict></roll>\r\n";
  }
  return out + "</element>\r\n</root>\r\n";
}

std::vector<Vertex> wandering(std::mt19937& bits, std::size_t count, double strict_share) {
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  std::vector<Vertex> all;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 12.3 + 9.7 * static_cast<double>(i), y = uniform(3, 9), z = uniform(-5, 5);
    all.push_back({{x, y, z}, uniform(0, 1) < strict_share});
  }
  return all;
}

// The uniform cubic B-spline by the recurrence of Cox and de Boor, over control vertices at integer knots.
double basis(int i, int degree, double x) {
  if (degree == 0) return x >= i && x < i + 1 ? 1 : 0;
  return (x - i) / degree * basis(i, degree - 1, x) + (i + degree + 1 - x) / degree * basis(i + 1, degree - 1, x);
}

TEST(nl2elem, control_vertices_make_their_b_spline_to_rounding) {
  std::mt19937 bits(2);
  for (const std::size_t count : {2, 3, 4, 9, 40}) {
    const std::vector<Vertex> vertices = wandering(bits, count, 0);
    const auto loaded = parse_nl2elem(encode(vertices), "made.nl2elem");
    ASSERT_TRUE(loaded) << loaded.status().message;
    const world::Document& d = loaded->document;
    ASSERT_EQ(d.track.knots.size(), count);
    EXPECT_EQ(d.name, "made");
    EXPECT_EQ(world::broken_invariant(d), std::nullopt);
    ASSERT_TRUE(loaded->import);
    EXPECT_EQ(loaded->import->knots, static_cast<int>(count));
    EXPECT_LT(loaded->import->max_error, 1e-4);
    // One more control vertex at each end, so that the curve starts and ends at the vertices.
    std::vector<dvec3> controls{2.0 * vertices[0].p - vertices[1].p};
    for (const Vertex& v : vertices) controls.push_back(v.p);
    controls.push_back(2.0 * vertices[count - 1].p - vertices[count - 2].p);
    for (std::size_t s = 0; s + 1 < count; ++s)
      for (int k = 0; k <= 8; ++k) {
        const double x = static_cast<double>(s) + k / 8.0 * (1 - 1e-12) + 3;
        dvec3 wanted(0);
        for (std::size_t i = 0; i < controls.size(); ++i) wanted += basis(static_cast<int>(i), 3, x) * controls[i];
        // Places up to 400 m round by 1.5e-5 m, tangents turn handles by 1e-7.
        EXPECT_LT(glm::distance(curve::point(world::cubic_of(d, d.track.segments[s]), k / 8.0), wanted), 5e-5)
            << count << " " << s;
      }
  }
}

TEST(nl2elem, strict_vertices_are_on_the_curve_among_others_too) {
  std::mt19937 bits(3);
  for (const double share : {0.3, 1.0}) {
    const std::vector<Vertex> vertices = wandering(bits, 30, share);
    const auto loaded = parse_nl2elem(encode(vertices), "x");
    ASSERT_TRUE(loaded);
    for (std::size_t i = 0; i < 30; ++i) {
      const double off =
          glm::distance(dvec3(world::knot(loaded->document, loaded->document.track.knots[i]).position), vertices[i].p);
      if (vertices[i].strict || i == 0 || i == 29) EXPECT_LT(off, 3e-5) << i;
      else EXPECT_GT(off, 1e-3) << i;
    }
  }
}

TEST(nl2elem, a_last_vertex_on_the_first_closes_the_track) {
  std::vector<Vertex> ring;
  for (int i = 0; i < 12; ++i)
    ring.push_back({{30 * std::cos(i * M_PI / 6) + 1.7, 8.3, 30 * std::sin(i * M_PI / 6)}, true});
  ring.push_back(ring.front());
  const auto loaded = parse_nl2elem(encode(ring), "x");
  ASSERT_TRUE(loaded);
  EXPECT_TRUE(loaded->document.track.closed);
  EXPECT_EQ(loaded->document.track.knots.size(), 12u);
  // By symmetry every handle is as long as the others.
  for (const world::Entity e : loaded->document.track.knots)
    EXPECT_NEAR(world::knot(loaded->document, e).out_length,
                world::knot(loaded->document, loaded->document.track.knots[0]).out_length, 1e-5);
}

TEST(nl2elem, rolls_turn_the_track_evenly_and_add_knots_between_vertices) {
  std::vector<Vertex> straight;
  for (int i = 0; i < 5; ++i) straight.push_back({{1.3 + 10 * i, 7, 2}, true});
  const auto up = [](double degrees) {
    return dvec3(0, std::cos(degrees * M_PI / 180), std::sin(degrees * M_PI / 180));
  };
  // 38 % of 40 m is 5.2 m into the second span. Unordered, as files may have them; 350 degrees are -10.
  const auto loaded = parse_nl2elem(encode(straight, {{1, up(350)}, {0, up(20)}, {0.38, up(80)}}), "x");
  ASSERT_TRUE(loaded) << loaded.status().message;
  const world::Document& d = loaded->document;
  ASSERT_EQ(d.track.knots.size(), 6u);
  const auto rolled = [&](std::size_t i) {
    const glm::vec3 u = world::knot(d, d.track.knots[i]).up;
    return std::atan2(u.z, u.y) * 180 / M_PI;
  };
  EXPECT_NEAR(rolled(0), 20, 1e-3);
  EXPECT_NEAR(rolled(1), 20 + 60 * 10 / 15.2, 1e-3);
  EXPECT_NEAR(world::knot(d, d.track.knots[2]).position.x, 1.3 + 15.2, 1e-4);
  EXPECT_NEAR(rolled(2), 80, 1e-3);
  EXPECT_NEAR(rolled(3), 80 - 90 * 4.8 / 24.8, 1e-3);
  EXPECT_NEAR(rolled(5), -10, 1e-3);
  EXPECT_LT(loaded->import->frame_error, 0.01);
  EXPECT_LT(loaded->import->max_error, 1e-5);
}

TEST(nl2elem, exported_tracks_come_back_within_a_centimetre_and_half_a_degree) {
  std::vector<world::Document> documents{test::sample_document(), test::ring_document(9, 23.1),
                                         test::circle_document(11, {3, 4, 5}, {1, 0, 0.3}),
                                         test::straight_document({-20, 5, 1}, {20, 9, 1}, 3)};
  for (const world::Document& d : documents) {
    ASSERT_TRUE(check_nl2elem(d).ok());
    const std::string text = print_nl2elem(d);
    EXPECT_EQ(text, print_nl2elem(d));
    const auto again = parse_nl2elem(text, "x");
    ASSERT_TRUE(again) << again.status().message;
    EXPECT_EQ(again->document.track.closed, d.track.closed);
    EXPECT_LT(again->import->frame_error, 0.05);
    const sim::Derived before = test::derived_of(d), after = test::derived_of(again->document);
    EXPECT_NEAR(before.length, after.length, 1e-3 * before.length);
    for (int i = 0; i < 400; ++i) {
      const auto at = [&](const sim::Derived& of, double share) {
        const sim::TrackPlace place = sim::place_at(of, share * of.length);
        const sim::SegmentShape& shape = of.shape(of.order[place.index]);
        return std::pair(curve::point(shape.key.cubic, shape.arc.parameter(place.s)), sim::frame_at(shape, place.s));
      };
      const auto [p, frame] = at(before, i / 400.0);
      // The nearest place of the other, near the same share of the length.
      double nearest = 1e9, angle = 0;
      for (int k = -20; k <= 20; ++k) {
        const auto [q, other] = at(after, std::clamp(i / 400.0 + k * 2e-5, 0.0, 1 - 1e-9));
        const double along = glm::dot(p - q, other.forward),
                     off = glm::length(p - q - std::clamp(along, -0.01, 0.01) * other.forward);
        if (off < nearest)
          nearest = off, angle = std::acos(std::clamp(glm::dot(frame.up, other.up), -1.0, 1.0)) * 180 / M_PI;
      }
      EXPECT_LT(nearest, 0.01) << i;
      EXPECT_LT(angle, 0.5) << i << " of " << before.length << " m, " << again->document.track.knots.size();
    }
  }
  EXPECT_FALSE(check_nl2elem(world::Document{}).ok());
}

TEST(nl2elem, bad_files_are_refused_with_line_and_reason) {
  const std::string vertex = "<vertex><x>1</x>\n<y>2</y>\n<z>3</z></vertex>\n",
                    other = "<vertex><x>9</x><y>2</y><z>3</z></vertex>\n";
  const auto with = [](const std::string& inner) { return "<root>\n<element>\n" + inner + "</element>\n</root>\n"; };
  const std::string frame = "<ux>0</ux><uy>1</uy><uz>0</uz><rx>0</rx><ry>0</ry><rz>1</rz>";
  const std::pair<std::string, std::string> cases[]{
      {"", "x:1: error: expected XML, found an empty file"},
      {"<root>\n<element>\n", "x:2: error: expected XML"},
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
       "x:6: error: expected a number within 1e+05 in <x>"},
      {with(vertex + "<vertex><x>5</x><y>2</y><z>3</z><strict>maybe</strict></vertex>"),
       "expected true or false in <strict>"},
      {with(vertex + vertex), "expected a direction from vertex to vertex"},
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
  // Cut anywhere: refused or, within the end tags alone, an XML error all the same; never a crash.
  const std::string whole = with(vertex + other + "<roll>" + frame + "<coord>0</coord></roll>\n");
  ASSERT_TRUE(parse_nl2elem(whole, "x"));
  for (std::size_t cut = 0; cut + 8 < whole.size(); ++cut)
    EXPECT_FALSE(parse_nl2elem(std::string_view(whole).substr(0, cut), "x").ok()) << cut;
}

}  // namespace nl2elem_test
}  // namespace coaster::exchange
