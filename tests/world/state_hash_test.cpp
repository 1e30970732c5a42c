// Hash of the state: src/world/document.
#include <gtest/gtest.h>

#include "base/hash.h"
#include "world/element_rows.h"
#include "world/motion.h"
#include "world/sample_documents.h"

namespace coaster::world {
namespace state_hash_test {

// Built without any arithmetic, so that the constants below depend on the hash alone.
Document plain_document() {
  Document d;
  d.name = "Fixed";
  d.start_speed = 2.5, d.datum = 0.1;
  Knot a, b;
  a.position = {1.1f, 2.2f, -3.3f}, b.position = {40.7f, 5.3f, 6.1f};
  b.tangent = {0, 0, 1};
  b.joint = JointKind::aligned, b.in_length = 7.7f;
  append_knot(d, a), append_knot(d, b);
  add_cart(d, d.track.segments[0], 0.25);
  return d;
}

// Scripts and bug reports contain such hashes: a change here changes them all.
TEST(state_hash, the_hash_of_a_document_is_fixed) {
  EXPECT_EQ(base::hex16(hash(plain_document())), "4ad13f3896ea9e17");
  EXPECT_EQ(base::hex16(hash(Document{})), "d615b7336fc9e6d6");
}

TEST(state_hash, every_member_counts) {
  const auto differs = [](auto change) {
    Document d = test::sample_document();
    const std::uint64_t before = hash(d);
    change(d);
    return hash(d) != before;
  };
  const auto k = [](Document& d) -> Knot& { return d.entities.get<Knot>(d.track.knots[2]); };
  EXPECT_TRUE(differs([](Document& d) { d.name += "!"; }));
  EXPECT_TRUE(differs([](Document& d) { d.start_speed += 1e-9; }));
  EXPECT_TRUE(differs([](Document& d) { d.datum += 1e-9; }));
  EXPECT_TRUE(differs([](Document& d) { d.extra.json = "{}"; }));
  EXPECT_TRUE(differs([](Document& d) { d.track.closed = true; }));
  EXPECT_TRUE(differs([&](Document& d) { k(d).position.z += 1e-3f; }));
  EXPECT_TRUE(differs([&](Document& d) { k(d).tangent.z += 1e-3f; }));
  EXPECT_TRUE(differs([&](Document& d) { k(d).up.z += 1e-3f; }));
  EXPECT_TRUE(differs([&](Document& d) { k(d).in_length += 1e-3f; }));
  EXPECT_TRUE(differs([&](Document& d) { k(d).out_length += 1e-3f; }));
  EXPECT_TRUE(differs([&](Document& d) { k(d).joint = JointKind::automatic; }));
  EXPECT_TRUE(differs([](Document& d) { std::swap(d.track.knots[0], d.track.knots[1]); }));
  EXPECT_TRUE(differs([](Document& d) { d.entities.get<Segment>(d.track.segments[0]).turns = 1; }));
  EXPECT_TRUE(differs([](Document& d) { d.entities.put(d.track.segments[0], UnknownMembers{"{}"}); }));
  EXPECT_TRUE(differs([](Document& d) { d.entities.get<Train>(find(d, {EntityKind::cart, 1})).fraction += 1e-9; }));
  EXPECT_TRUE(differs([](Document& d) {
    d.entities.get<Train>(find(d, {EntityKind::cart, 1})).segment = d.track.segments[0];
  }));
  EXPECT_TRUE(differs([](Document& d) { add_cart(d, d.track.segments[0], 0); }));
}

// Tracks without explicit sections keep the hash from before sections existed.
TEST(state_hash, sections_count_where_somebody_made_one) {
  const Document plain = test::sample_document();
  const auto differs = [&](Section value, std::size_t first, std::size_t count) {
    Document d = plain;
    make_section(d, first, count, std::move(value));
    return hash(d) != hash(plain);
  };
  EXPECT_FALSE(differs({}, 0, 4));
  EXPECT_TRUE(differs({}, 0, 3));
  EXPECT_TRUE(differs({"Hill", {}, {}}, 0, 4));
  const Section loop{{}, SectionKind::element, usual_element(ElementKind::loop)};
  EXPECT_TRUE(differs(loop, 0, 4));
  Document d = plain;
  make_section(d, 0, 4, loop);
  const std::uint64_t before = hash(d);
  Section& section = d.entities.pool<Section>().items().front();
  section.element.values[2] += 1e-9;
  EXPECT_NE(hash(d), before);
  section.element = loop.element, section.element.right = true;
  EXPECT_NE(hash(d), before);
  section.element = usual_element(ElementKind::corkscrew);
  EXPECT_NE(hash(d), before);
  section = loop;
  EXPECT_EQ(hash(d), before);
  d.entities.put(segment(d, d.track.segments[0]).section, UnknownMembers{"{}"});
  EXPECT_NE(hash(d), before);
}

TEST(state_hash, slots_and_numbers_to_come_do_not_count) {
  // The same content by another way: two carts taken away and added in the other order.
  Document a = plain_document(), b = plain_document();
  add_cart(a, a.track.segments[0], 0.5);
  b.entities.destroy(find(b, {EntityKind::cart, 1}));
  const Entity second = b.entities.create(), spare = b.entities.create(), first = b.entities.create();
  b.entities.put(second, EntityName{EntityKind::cart, 2}), b.entities.put(second, Train{b.track.segments[0], 0.5});
  b.entities.put(first, EntityName{EntityKind::cart, 1}), b.entities.put(first, Train{b.track.segments[0], 0.25});
  b.entities.destroy(spare);
  b.last_number[2] = 9;
  EXPECT_FALSE(a == b);
  EXPECT_EQ(hash(a), hash(b));
}

TEST(state_hash, the_hash_of_motion_is_fixed_and_takes_carts_by_name) {
  const Document d = test::sample_document();
  const Entity c1 = find(d, {EntityKind::cart, 1}), c2 = find(d, {EntityKind::cart, 2});
  const TrainMotion one{d.track.segments[1], 3.7, 11.3, 30.1, 41.9, 5.5, 1, 60.3, 55.1};
  const TrainMotion two{d.track.segments[3], 0.7, -1.3, 20.3, 99.1, -5.5, -2, 61.7, 50.9};
  Motion a, b;
  a.carts.put(c1, one), a.carts.put(c2, two);
  b.carts.put(c2, two), b.carts.put(c1, one);
  EXPECT_EQ(hash(d, a), hash(d, b));
  EXPECT_EQ(base::hex16(hash(d, a)), "00fcadfca18ae2ea");
  b.carts.get(c1).speed = -11.3;
  EXPECT_NE(hash(d, a), hash(d, b));
  a.state = RideState::running;
  EXPECT_NE(base::hex16(hash(d, a)), "00fcadfca18ae2ea");
}

}  // namespace state_hash_test
}  // namespace coaster::world
