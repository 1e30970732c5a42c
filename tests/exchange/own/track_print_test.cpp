#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "base/tries.h"
#include "exchange/own/track_file.h"
#include "world/element_rows.h"
#include "world/sample_documents.h"

namespace coaster::exchange {
namespace track_print_test {

TEST(track_print, the_layout_is_one_knot_a_line) {
  world::Document d;
  d.name = "A \"b\"";
  world::Knot knot;
  knot.position = {0.1f, -0.0f, 100'000.0f};
  world::append_knot(d, knot);
  knot.position.x = 30;
  world::append_knot(d, knot);
  world::add_cart(d, d.track.segments[0], 0.25);
  world::Section bend{"Home \"bend\"", world::SectionKind::element, world::usual_element(world::ElementKind::curve)};
  bend.element.right = true, bend.element.values[0] = 30.5;
  world::make_section(d, 0, 1, bend);
  EXPECT_EQ(print_track(d), R"({
  "format": "coaster-track",
  "version": 3,
  "name": "A \"b\"",
  "closed": false,
  "start_speed": 1,
  "datum": 0,
  "knots": [
    {"id": "k1", "position": [0.1, 0, 1e+05], "tangent": [1, 0, 0], "up": [0, 1, 0], "in": 5, "out": 5, "joint": "smooth"},
    {"id": "k2", "position": [30, 0, 1e+05], "tangent": [1, 0, 0], "up": [0, 1, 0], "in": 5, "out": 5, "joint": "smooth"}
  ],
  "segments": [
    {"id": "s1", "from": "k1", "to": "k2", "turns": 0}
  ],
  "sections": [
    {"id": "q1", "segments": 1, "kind": "curve", "side": "right", "radius": 30.5, "angle": 90, "bank": 40, "speed": 0, "ramp": 0, "title": "Home \"bend\""}
  ],
  "carts": [
    {"id": "c1", "segment": "s1", "fraction": 0.25}
  ]
}
)");
}

TEST(track_print, a_thousand_random_tracks_read_back_keep_hash_and_bytes) {
  for (int seed = 0; seed < test::tries(1000); ++seed) {
    const world::Document d = test::random_document(static_cast<std::uint32_t>(seed));
    const std::string text = print_track(d);
    const auto loaded = parse_track(text, "t.json");
    ASSERT_TRUE(loaded.ok()) << seed;
    ASSERT_EQ(world::hash(loaded->document), world::hash(d)) << seed;
    ASSERT_EQ(print_track(loaded->document), text) << seed;
  }
}

TEST(track_print, floats_of_all_sizes_keep_their_bits) {
  world::Document d;
  std::mt19937 bits(7);
  for (int i = 0; i < 2000; ++i) {
    world::Knot knot;
    for (int axis = 0; axis < 3; ++axis) {
      const double exponent = bits() % 50;
      knot.position[axis] = static_cast<float>((bits() / 4294967296.0 - 0.5) * 2e5 / std::exp2(exponent));
    }
    world::append_knot(d, knot);
  }
  const auto loaded = parse_track(print_track(d), "t.json");
  ASSERT_TRUE(loaded);
  for (std::size_t i = 0; i < d.track.knots.size(); ++i)
    ASSERT_EQ(world::knot(loaded->document, loaded->document.track.knots[i]), world::knot(d, d.track.knots[i]));
}

}  // namespace track_print_test
}  // namespace coaster::exchange
