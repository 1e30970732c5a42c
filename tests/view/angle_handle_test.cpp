// The rings around the selected section.
#include "view/gizmo.h"

#include <gtest/gtest.h>

#include "base/portable_math.h"
#include "edit/session_fixture.h"
#include "sim/shape/rails.h"
#include "view/marks.h"
#include "world/panel_settings.h"
#include "world/sections.h"

namespace coaster::view {
namespace angle_handle_test {

class AngleHandles : public test::SessionTest {
 protected:
  AngleHandles() : SessionTest(world::Document{}) {
    for (const char* line :
         {"element straight length 30", "element curve left radius 25 angle 90 bank 40",
          "element helix right radius 16 turns 1.25 height -4 bank 30",
          "element s_bend left radius 30 angle 40 bank 20", "element curve right radius 25 angle 60 speed 14",
          "element overbanked_turn left radius 20 angle 180"})
      good(line);
  }
  std::vector<AngleHandle> handles(const char* name) {
    return angle_handles(session.document, session.derived, entity(name));
  }
  AngleHandle handle(const char* name, PickKind kind) {
    const auto found = angle_handle(session.document, session.derived, entity(name), kind);
    EXPECT_TRUE(found) << name;
    return found.value_or(AngleHandle{});
  }
  // Seen from aside of the ring's axis.
  static std::optional<double> angle_at(const AngleHandle& of, glm::dvec3 place, double near) {
    const glm::dvec3 eye = place + 40.0 * of.axis + 1.3 * of.zero;
    return angle_under(of, {glm::vec3(eye), glm::vec3(glm::normalize(place - eye))}, near);
  }
};

TEST_F(AngleHandles, what_turns_and_banks_has_them) {
  EXPECT_TRUE(handles("q1").empty()) << "a straight";
  ASSERT_EQ(handles("q2").size(), 2u);
  EXPECT_EQ(handles("q2")[0].parameter, "angle");
  EXPECT_EQ(handles("q2")[1].parameter, "bank");
  EXPECT_EQ(handles("q3")[0].parameter, "turns");
  EXPECT_NEAR(handles("q3")[0].angle, 450, 1e-9);
  ASSERT_EQ(handles("q4").size(), 1u) << "its two turns end as it began";
  EXPECT_EQ(handles("q4")[0].kind, PickKind::bank);
  ASSERT_EQ(handles("q5").size(), 1u) << "banked for a speed";
  EXPECT_EQ(handles("q5")[0].kind, PickKind::turn);
  EXPECT_EQ(handles("q6").size(), 2u);
}

// The spoke of a turn is parallel to the radius at its end, as the heading turned by the same angle.
TEST_F(AngleHandles, a_turn_s_spoke_follows_the_heading) {
  for (const char* name : {"q2", "q3", "q5", "q6"}) {
    const AngleHandle turn = handle(name, PickKind::turn);
    const world::SectionRun run = world::run_of(session.document, entity(name));
    const glm::dvec3 start = curve::unit_tangent(session.derived.shape_at(run.first).key.cubic, 0.0),
                     end = curve::unit_tangent(session.derived.shape_at(run.end() - 1).key.cubic, 1.0);
    const auto heading = [](glm::dvec3 v) { return std::atan2(-v.z, v.x); };
    const auto spoke = [&](double deg) { return turn.at(deg) - turn.centre; };
    EXPECT_NEAR(glm::dot(spoke(0), start), 0, 1e-9) << name;
    const double turned = heading(spoke(turn.angle)) - heading(spoke(0)), ridden = heading(end) - heading(start);
    EXPECT_NEAR(std::remainder(turned - ridden, 2 * base::kPi), 0, 1e-3) << name;
  }
}

// The spoke of a bank is the rider's up there.
TEST_F(AngleHandles, a_bank_s_spoke_is_the_rider_s_up) {
  for (const char* name : {"q2", "q3", "q4", "q6"}) {
    const AngleHandle bank = handle(name, PickKind::bank);
    const world::SectionRun run = world::run_of(session.document, entity(name));
    const glm::dvec3 spoke = glm::normalize(bank.at(bank.angle) - bank.centre);
    double nearest = 1e9;
    glm::dvec3 up(0);
    for (std::size_t i = run.first; i < run.end(); ++i) {
      const sim::SegmentShape& shape = session.derived.shape_at(i);
      for (int k = 0; k <= 64; ++k) {
        const double s = shape.arc.length() * k / 64;
        const double away = glm::distance(sim::rails_point(shape, shape.arc.parameter(s)), bank.centre);
        if (away < nearest) nearest = away, up = sim::frame_at(shape, s).up;
      }
    }
    EXPECT_LT(glm::distance(up, spoke), 0.06) << name;
  }
}

TEST_F(AngleHandles, a_ray_finds_the_angle_of_its_turn) {
  for (const char* name : {"q2", "q3", "q6"})
    for (const PickKind kind : {PickKind::turn, PickKind::bank}) {
      const AngleHandle of = handle(name, kind);
      for (const double deg : {-170.0, -20.0, 10.0, 100.0, 350.0, 451.0, 800.0}) {
        const auto found = angle_at(of, of.at(deg), deg + 130);
        ASSERT_TRUE(found) << name;
        EXPECT_NEAR(*found, deg, 1e-3) << name;
      }
      const glm::vec3 along(glm::normalize(of.zero));
      EXPECT_FALSE(angle_under(of, {glm::vec3(of.centre) - 50.0f * along, along}, 0)) << "edge-on";
    }
}

TEST_F(AngleHandles, the_selected_one_s_are_picked_and_drawn_in_build_alone) {
  good("select @q2");
  const Viewport viewport{0, 0, 800, 600};
  const View view = orbit_view(frame_all({}, session.document, viewport), viewport);
  for (const PickKind kind : {PickKind::turn, PickKind::bank}) {
    session.settings.panels->workspace = world::Workspace::all;
    const AngleHandle of = handle("q2", kind);
    const auto pixel = project(view, glm::vec3(of.at(of.angle)));
    ASSERT_TRUE(pixel);
    const auto picked = [&] {
      return pick(session.document, session.derived, session.motion, session.settings, view, glm::vec2(*pixel)).kind;
    };
    const auto lines = [&] {
      return build_overlay(session.document, session.derived, session.settings, view, {}).lines.size();
    };
    EXPECT_NE(picked(), kind);
    const std::size_t before = lines();
    session.settings.panels->workspace = world::Workspace::build;
    EXPECT_EQ(picked(), kind);
    EXPECT_GT(lines(), before + 96);
  }
}

}  // namespace angle_handle_test
}  // namespace coaster::view
