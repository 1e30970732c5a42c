// Advice on overloads: src/sim/study/force_limits.
#include "edit/perform/apply.h"
#include "sim/study/force_limits.h"

#include <gtest/gtest.h>

#include "edit/commands/commands_document.h"
#include "edit/session/session.h"
#include "sim/tracks.h"

namespace coaster::sim {
namespace overload_advice_test {

struct Excess {
  double g_seconds = 0;  // of all red spans, g beyond the limit times how long
  double worst = 0;      // g beyond the limit
};

// A session whose document is `d` with a train on its first segment; moves go through the editor's own command.
struct Edited {
  base::Files files;
  edit::Session session = edit::make_session({});
  world::Entity cart;

  Edited(world::Document d, double speed) {
    cart = world::add_cart(d, d.track.segments.at(0), 0.2);
    d.start_speed = speed;
    session.document = std::move(d);
    EXPECT_TRUE(edit::apply(session, files, edit::SetDatum{0.25}).ok());
  }
  std::vector<Overload> red() {
    return red_spans(*edit::rides_of(session).ride(session.document, session.derived, cart), default_envelope());
  }
  void move(world::Entity knot, glm::vec3 by) {
    const world::EntityName name = world::name_of(session.document, knot);
    ASSERT_TRUE(
        edit::apply(session, files, edit::MoveKnot{{name}, world::knot(session.document, knot).position + by}).ok());
  }
};

Excess excess_of(const std::vector<Overload>& red, ForceAxis axis) {
  Excess sum;
  for (const Overload& span : red) {
    if (span.axis != axis) continue;
    sum.g_seconds += (span.worst - span.allowed) * (1.0 + span.to - span.from);
    sum.worst = std::max(sum.worst, span.worst - span.allowed);
  }
  return sum;
}

world::Document tight(world::JointKind joint) {
  // Up and down and through a valley that is too tight for the speed.
  world::Document d;
  const glm::vec3 at[] = {{0.3f, 30, 0.7f}, {22, 28, 1}, {45, 4, 2},   {52, 2, 2.2f},
                          {59, 4, 2.4f},    {82, 26, 3}, {110, 27, 4}, {140, 27, 5}};
  const glm::vec3 along[] = {{1, 0, 0},    {1, -0.4f, 0}, {1, -0.6f, 0}, {1, 0, 0},
                             {1, 0.6f, 0}, {1, 0.4f, 0},  {1, 0, 0},     {1, 0, 0}};
  for (int i = 0; i < 8; ++i)
    world::append_knot(
        d, test::skew_knot(at[i], along[i], i > 1 && i < 5 ? 3.1f : 8.3f, i > 1 && i < 5 ? 3.1f : 8.3f, joint));
  world::settle_joints(d);
  return d;
}

TEST(advice, the_move_that_it_names_lowers_the_excess_by_the_editors_own_command) {
  for (const world::JointKind joint :
       {world::JointKind::aligned, world::JointKind::smooth, world::JointKind::automatic}) {
    Edited edited(tight(joint), 17.3);
    const std::vector<Overload> before = edited.red();
    ASSERT_FALSE(before.empty());
    const Overload& span = before.front();
    const auto advice = advise(edited.session.document, edited.cart, default_envelope(), span);
    ASSERT_TRUE(advice);
    EXPECT_LT(advice->after, advice->before);
    EXPECT_NEAR(glm::length(advice->direction), 1, 1e-6);
    edited.move(advice->knot, kAdviceStep * advice->direction);
    const Excess was = excess_of(before, span.axis), is = excess_of(edited.red(), span.axis);
    EXPECT_LT(is.g_seconds, was.g_seconds);
    // One span of this axis: the numbers are the advice's own, so the tried ride is the one that the editor makes.
    EXPECT_NEAR(was.g_seconds, advice->before, 1e-6);
    EXPECT_NEAR(is.g_seconds, advice->after, 1e-6);
  }
}

TEST(advice, following_it_again_and_again_makes_the_span_fade) {
  Edited edited(tight(world::JointKind::aligned), 17.3);
  const double first = excess_of(edited.red(), ForceAxis::down).worst;
  for (int i = 0; i < 12; ++i) {
    const std::vector<Overload> red = edited.red();
    if (red.empty()) break;
    const auto advice = advise(edited.session.document, edited.cart, default_envelope(), red.front());
    if (!advice) break;
    edited.move(advice->knot, kAdviceStep * advice->direction);
  }
  EXPECT_LT(excess_of(edited.red(), ForceAxis::down).worst, 0.8 * first);
}

TEST(advice, changes_nothing_and_has_nothing_to_say_where_there_is_no_track) {
  Edited edited(tight(world::JointKind::aligned), 17.3);
  const world::Document before = edited.session.document;
  const auto red = edited.red();
  ASSERT_FALSE(red.empty());
  (void)advise(edited.session.document, edited.cart, default_envelope(), red.front());
  EXPECT_TRUE(edited.session.document == before);
  EXPECT_FALSE(advise(world::Document(), world::kNone, default_envelope(), red.front()));
}

}  // namespace overload_advice_test
}  // namespace coaster::sim
