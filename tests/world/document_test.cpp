#include "world/document.h"

#include <gtest/gtest.h>

#include <vector>

#include "world/sample_documents.h"

namespace coaster::world {
namespace document_test {

TEST(document, find_and_name_are_inverse) {
  const Document d = test::sample_document();
  for (const Entity e : d.track.knots) EXPECT_EQ(find(d, name_of(d, e)), e);
  for (const Entity e : d.track.segments) EXPECT_EQ(find(d, name_of(d, e)), e);
  EXPECT_EQ(find(d, {EntityKind::knot, 6}), kNone);
  EXPECT_EQ(find(d, {EntityKind::segment, 5}), kNone);
  EXPECT_EQ(label_of(d, d.track.segments[2]), "s3");
  EXPECT_EQ(label_of(d, kNone), "-");
}

TEST(document, the_first_train_is_that_of_the_least_number_however_they_are_stored) {
  Document d = test::sample_document();
  for (const Entity cart :
       std::vector(d.entities.pool<Train>().entities().begin(), d.entities.pool<Train>().entities().end()))
    d.entities.destroy(cart);
  EXPECT_EQ(first_cart(d), kNone);
  for (const unsigned number : {7u, 3u, 9u}) {
    const Entity cart = d.entities.create();
    d.entities.put(cart, EntityName{EntityKind::cart, number}), d.entities.put(cart, Train{d.track.segments[0], 0.5});
  }
  EXPECT_EQ(name_of(d, first_cart(d)), (EntityName{EntityKind::cart, 3}));
}

TEST(document, a_segment_meets_its_knots_exactly_and_leaves_along_their_tangents) {
  const Document d = test::sample_document();
  for (const Entity e : d.track.segments) {
    const curve::Cubic c = cubic_of(d, e);
    const Knot &from = knot(d, segment(d, e).from), &to = knot(d, segment(d, e).to);
    EXPECT_EQ(c.p0, from.position);
    EXPECT_EQ(c.p3, to.position);
    // A handle is rounded once to float at coordinates below 256: half an ulp is 8e-6 m an axis.
    EXPECT_NEAR(glm::distance(c.p0, c.p1), from.out_length, 3e-5);
    EXPECT_NEAR(glm::dot(glm::normalize(c.p1 - c.p0), from.tangent), 1.0f, 1e-5);
    EXPECT_NEAR(glm::dot(glm::normalize(c.p3 - c.p2), to.tangent), 1.0f, 1e-5);
  }
}

TEST(document, neighbours_end_where_an_open_track_ends) {
  Document d = test::sample_document();
  const auto &k = d.track.knots, &s = d.track.segments;
  EXPECT_EQ(neighbours(d, k.front()).before, kNone);
  EXPECT_EQ(neighbours(d, k.front()).after, s.front());
  EXPECT_EQ(neighbours(d, k[2]).before, s[1]);
  EXPECT_EQ(neighbours(d, k[2]).after, s[2]);
  EXPECT_EQ(neighbours(d, k.back()).after, kNone);
  set_closed(d, true);
  EXPECT_EQ(neighbours(d, k.front()).before, s.back());
  EXPECT_EQ(neighbours(d, k.back()).after, s.back());
}

TEST(document, exact_length_agrees_with_a_fine_chord_sum) {
  const Document d = test::sample_document();
  double chords = 0;
  for (const Entity e : d.track.segments) {
    constexpr int kSteps = 20'000;
    glm::dvec3 last = curve::point(cubic_of(d, e), 0);
    for (int i = 1; i <= kSteps; ++i) {
      const glm::dvec3 next = curve::point(cubic_of(d, e), double(i) / kSteps);
      chords += glm::distance(last, next), last = next;
    }
  }
  // A chord is shorter than its arc by h^3 K^2 / 24: here below 1e-8 of the length.
  EXPECT_NEAR(exact_length(d), chords, 1e-6);
}

}  // namespace document_test
}  // namespace coaster::world
