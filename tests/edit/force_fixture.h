// A session with a force section behind a drop, and what its riders miss.
#pragma once

#include "curve/continuity.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/session_fixture.h"
#include "sim/plan/force_plan.h"
#include "world/sections.h"

namespace coaster::test {

class Forces : public SessionTest {
 protected:
  Forces() : SessionTest(world::Document{}) {}

  // A drop from 35 m, so that the train comes with some 24 m/s, and a force section of 60 m.
  void drop_and_force() {
    for (const char* const line : {"start_speed 5", "element climb height 32 equipment lift speed 5",
                                   "element straight length 8", "element dive height 28", "force.add length 60"})
      good(line);
    section = world::label_of(session.document, last());
  }
  world::Entity last() const {
    return world::segment(session.document, session.document.track.segments.back()).section;
  }
  const world::Section& value() { return world::section(session.document, entity(section.c_str())); }
  const world::ForceProgram& program() { return value().force; }
  const sim::ForcePlan& plan() { return *edit::SessionFindings(session).force(entity(section.c_str())); }
  // Returns the knots from the section's end on, without the handle before it, which is the section's own.
  std::vector<world::Knot> knots_behind() {
    const auto& order = session.document.track.knots;
    std::vector<world::Knot> knots;
    for (std::size_t i = world::run_of(session.document, entity(section.c_str())).end(); i < order.size(); ++i)
      knots.push_back(world::knot(session.document, order[i]));
    knots.front().in_length = 0;
    return knots;
  }
  void key(const std::string& words) { good("force @" + section + " " + words); }
  // Largest difference between what the plan asks for and what the first train's riders feel in the simulated ride.
  double missed() {
    const sim::SimulatedRide& ride = *edit::SessionFindings(session).ride();
    const sim::RailTables& tables = edit::SessionFindings(session).tables();
    const sim::ForcePlan& planned = plan();
    const double start = session.derived.starts[world::run_of(session.document, entity(section.c_str())).first];
    double most = 0;
    std::size_t index = 0;
    for (std::size_t i = 0; i + 1 < planned.path.points.size(); ++i) {
      const double place = start + planned.path.curve.points[i].s;
      const auto passing = sim::passing(ride, place);
      if (!passing) return 1e9;
      const double s = tables.locate(place, index);
      const glm::vec3 felt =
          sim::felt_at(tables.segment(index), s, static_cast<float>(passing->along / world::kGravity),
                       static_cast<float>(passing->speed * passing->speed / world::kGravity));
      most = std::max(
          {most, std::abs(felt.z - planned.path.points[i].up), std::abs(felt.y - planned.path.points[i].side)});
    }
    return most;
  }
  void expect_g2() {
    for (std::size_t i = 1; i < session.derived.order.size(); ++i) {
      const curve::JointContinuity joint =
          curve::joint(session.derived.shape_at(i - 1).key.cubic, session.derived.shape_at(i).key.cubic);
      EXPECT_EQ(joint.geometric, curve::GeometricContinuity::g2)
          << "knot " << i << " jumps by " << joint.curvature_jump;
    }
  }

  std::string section;
};

}  // namespace coaster::test
