// Commands of elements: src/edit/perform/sections.
#include <gtest/gtest.h>

#include "base/hash.h"
#include "base/tries.h"
#include "curve/continuity.h"
#include "edit/commands/commands_sections.h"
#include "edit/session_fixture.h"
#include "sim/random_elements.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"

namespace coaster::edit {
namespace perform_elements_test {

class PerformElementsTest : public test::SessionTest {
 protected:
  PerformElementsTest() : SessionTest(world::Document{}) {}

  // Every joint of the track, by the program's own classes.
  void expect_g2() const {
    const auto& segments = session.document.track.segments;
    for (std::size_t i = 1; i < segments.size(); ++i) {
      const curve::JointContinuity joint = curve::joint(world::cubic_of(session.document, segments[i - 1]),
                                                        world::cubic_of(session.document, segments[i]));
      EXPECT_EQ(joint.geometric, curve::GeometricContinuity::g2)
          << world::label_of(session.document, segments[i]) << " jumps by " << joint.curvature_jump;
    }
  }
};

TEST_F(PerformElementsTest, an_empty_track_gets_its_first_knots_and_a_cart) {
  good("element straight length 20");
  EXPECT_EQ(session.document.track.knots.size(), 2u);
  EXPECT_EQ(knot(1).position, glm::vec3(0, 2, 0));
  EXPECT_EQ(knot(2).position, glm::vec3(20, 2, 0));
  EXPECT_EQ(session.document.entities.pool<world::Train>().size(), 1u);
  EXPECT_EQ(session.notices.list.back().text, "Placed straight: 20.0 m, fit error 0.0 mm.");
  EXPECT_EQ(session.settings.selected, entity("k2"));
}

TEST_F(PerformElementsTest, one_after_the_other_they_make_a_track_whose_every_joint_is_g2) {
  for (const char* line :
       {"element straight length 15", "element climb height 30", "element curve right radius 18 angle 180",
        "element dive height 25", "element camelback height 12 speed 21", "element loop left",
        "element corkscrew right height 7", "element helix left radius 14 turns 1.5 height -1"}) {
    good(line);
    expect_g2();
  }
  EXPECT_EQ(session.history.undo.size(), 8u);
  // Portable to the bit: gcc and clang, debug and release.
  EXPECT_EQ(base::hex16(hash()), "3ab85c4712c2c5a1");
  world::Document undivided = session.document;
  world::make_section(undivided, 0, undivided.track.segments.size(), {});
  EXPECT_EQ(base::hex16(world::hash(undivided)), "9fa8ec073e8bc0ca");
}

TEST_F(PerformElementsTest, undo_takes_a_whole_element_away_and_redo_brings_it_back) {
  test::RandomElements random(41);
  good("append at 0 5 0"), good("append at 20 8 5"), good("append at 41 6 1");
  for (int i = 0; i < test::tries(60); ++i) {
    const world::Document before = session.document;
    const std::size_t steps = session.history.undo.size();
    const PlaceElement command{random.any()};
    if (!apply(command)) {
      EXPECT_TRUE(session.document == before);
      continue;
    }
    ASSERT_EQ(world::broken_invariant(session.document), std::nullopt);
    EXPECT_EQ(session.history.undo.size(), steps + 1);
    // Nothing of the old track moves: only the handle at its end, and the class of its joint, may be new.
    for (std::size_t k = 0; k < before.track.knots.size(); ++k) {
      world::Knot was = world::knot(before, before.track.knots[k]);
      const world::Knot& is = world::knot(session.document, before.track.knots[k]);
      if (k + 1 == before.track.knots.size()) was.out_length = is.out_length, was.joint = world::JointKind::aligned;
      EXPECT_TRUE(was == is);
    }
    const world::Document after = session.document;
    good("undo");
    EXPECT_TRUE(session.document == before);
    good("redo");
    EXPECT_TRUE(session.document == after);
    if (i % 6 == 5) good("undo");  // not ever farther away
  }
}

TEST_F(PerformElementsTest, it_goes_on_from_a_bent_rolled_and_sloping_end_as_smoothly) {
  good("append at 0 20 0"), good("append at 20 24 5"), good("append at 41 31 -7");
  good("roll @k3 to 35");
  good("handle @k3.in to 35 28 -1");
  const glm::vec3 tangent = knot(3).tangent, up = knot(3).up;
  for (const world::ElementRow& row : world::elements()) {
    const std::string_view name = row.name;
    good("element " + std::string(name));
    EXPECT_EQ(knot(3).tangent, tangent) << name;
    EXPECT_EQ(knot(3).up, up) << name;
    const auto& segments = session.document.track.segments;
    const curve::JointContinuity joint =
        curve::joint(world::cubic_of(session.document, segments[1]), world::cubic_of(session.document, segments[2]));
    EXPECT_EQ(joint.geometric, curve::GeometricContinuity::g2) << name << " jumps by " << joint.curvature_jump;
    good("undo");
  }
}

TEST_F(PerformElementsTest, carts_under_way_stay_where_they_are) {
  good("element straight length 60");
  good("start_speed 10");
  good("ride.start");
  edit::advance(session, 120);
  const world::TrainMotion before = session.motion.carts.items().at(0);
  good("element loop");
  const world::TrainMotion& after = session.motion.carts.items().at(0);
  EXPECT_EQ(after.segment, before.segment);
  EXPECT_NEAR(after.s, before.s, 1e-9);
  EXPECT_EQ(after.speed, before.speed);
}

TEST_F(PerformElementsTest, what_cannot_be_placed_is_refused_and_limits_are_told) {
  clamped("element loop height 500", "Reduced height from 500 m to the limit of 100 m.");
  good("element dive height 300");
  EXPECT_EQ(session.notices.list.back().kind, NoticeKind::warning);
  EXPECT_NE(session.notices.list.back().text.find("below the ground"), std::string::npos)
      << session.notices.list.back().text;
  good("closed on");
  refused("element curve", "the track is closed");
  refused(PlaceElement{{static_cast<world::ElementKind>(99), false, {}}}, "no such element");
  refused(PlaceElement{{world::ElementKind::curve, false, {std::nan(""), 1, 1, 1, 1}}}, "finite");
  good("closed off");
  good("resolution 4096");
  good("vertex_budget 200000");
  refused("element helix turns 12 radius 30", "vertex budget");
}

TEST_F(PerformElementsTest, elements_bring_their_equipment) {
  // Returns the length of all segments with that equipment, m; they are straight or longer than their chords.
  const auto equipped = [&](world::EquipmentKind kind) {
    double sum = 0;
    for (const world::Entity segment : session.document.track.segments)
      if (const auto* found = session.document.entities.find<world::Equipment>(segment); found && found->kind == kind)
        sum += session.derived.shape(segment).arc.length();
    return sum;
  };
  good("element straight length 20 equipment launch speed 18 acceleration 4");
  EXPECT_NEAR(equipped(world::EquipmentKind::launch), 20, 1e-4);
  const auto* launch = session.document.entities.find<world::Equipment>(session.document.track.segments[0]);
  ASSERT_NE(launch, nullptr);
  EXPECT_EQ(launch->speed, 18);
  EXPECT_EQ(launch->acceleration, 4);
  const std::size_t before = session.document.track.segments.size();
  good("element climb height 30 angle 30 equipment lift");
  const std::size_t climb = session.document.track.segments.size() - before;
  EXPECT_GE(equipped(world::EquipmentKind::lift), 30 / std::sin(M_PI / 6));
  EXPECT_EQ(session.document.entities.pool<world::Equipment>().size(), 1 + climb);
  good("element curve");
  EXPECT_EQ(session.document.entities.pool<world::Equipment>().size(), 1 + climb) << "plain";
  good("element brake_run brakes 41 station 23 speed 3 acceleration 7");
  EXPECT_NEAR(equipped(world::EquipmentKind::brake), 41, 1e-3);
  EXPECT_NEAR(equipped(world::EquipmentKind::station), 23, 1e-3);
  expect_g2();
  good("undo");
  EXPECT_EQ(equipped(world::EquipmentKind::brake), 0);
}

TEST_F(PerformElementsTest, choosing_shows_the_preview_and_changes_no_document) {
  const std::uint64_t before = hash();
  EXPECT_FALSE(session.settings.aids->show_element);
  good("element.choose loop right height 22");
  EXPECT_TRUE(session.settings.aids->show_element);
  EXPECT_EQ(session.settings.element.kind, world::ElementKind::loop);
  EXPECT_TRUE(session.settings.element.right);
  EXPECT_EQ(session.settings.element.values[0], 22);
  EXPECT_EQ(session.settings.element.values[1], world::usual_element(world::ElementKind::loop).values[1])
      << "what is not named is usual";
  good("element.preview off");
  EXPECT_FALSE(session.settings.aids->show_element);
  EXPECT_EQ(hash(), before);
  EXPECT_TRUE(session.history.undo.empty());
}

TEST_F(PerformElementsTest, elements_read_and_print_in_their_own_words) {
  EXPECT_EQ(print(command("element loop height 20 right")), "element loop right height 20 top 90 shift 3.5");
  EXPECT_EQ(print(command("element dive angle 70 height 40 angle 60")), "element dive height 40 angle 60 radius 22");
  EXPECT_EQ(print(command("element climb equipment lift")),
            "element climb height 25 angle 35 radius 20 equipment lift speed 4");
  for (const auto& [line, message] : {std::pair{"element climb equipment chain", "expected none|station|lift"},
                                      {"element lopo", "did you mean \"loop\""},
                                      {"element dive left", "expected height|angle|radius"},
                                      {"element loop hight 3", "did you mean \"height\""},
                                      {"element loop height", "a number"},
                                      {"element", "straight|curve"}}) {
    std::vector<base::Token> tokens;
    base::TextError error;
    ASSERT_TRUE(base::tokenise(line, tokens, error));
    EXPECT_FALSE(parse(tokens, error)) << line;
    EXPECT_NE(error.message.find(message), std::string::npos) << line << ": " << error.message;
  }
}

}  // namespace perform_elements_test
}  // namespace coaster::edit
