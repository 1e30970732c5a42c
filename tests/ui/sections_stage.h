// A stage in the workspace Build with planned sections: straight q1, climb q2, dive q3, loop q4.
#pragma once

#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "ui/stage.h"
#include "world/element_rows.h"
#include "world/equipment_rows.h"
#include "world/panel_settings.h"
#include "world/sections.h"

namespace coaster::ui {

class SectionsStage : public Stage {
 protected:
  void SetUp() override {
    Stage::SetUp();
    good(edit::NewTrack{});
    for (const world::ElementKind kind :
         {world::ElementKind::straight, world::ElementKind::climb, world::ElementKind::dive, world::ElementKind::loop})
      good(edit::PlaceElement{world::usual_element(kind)});
    good(edit::Select{});
    good(edit::Set<&world::Panels::workspace>{world::Workspace::build});
    frames(3);
    look_at_all();
    commands_.clear();
  }
  void good(const edit::Command& command) {
    const base::Status status = edit::apply(session_, files_, command);
    EXPECT_TRUE(status.ok()) << status.message;
  }
  void look_at_all() {
    good(edit::set_camera(view::frame_all(session_.settings.camera, session_.document, host_->view().viewport)));
    frames(2);
  }

  world::Entity section(std::uint32_t number) const { return entity(world::EntityKind::section, number); }
  const world::Section& value(std::uint32_t number) const { return world::section(session_.document, section(number)); }
  world::SectionRun run(std::uint32_t number) const { return world::run_of(session_.document, section(number)); }
  double parameter(std::uint32_t number, std::string_view name) const {
    return world::value_of(value(number).element, name);
  }
  // The equipment of a section's segments, "lift lift " or "- - ".
  std::string equipment(std::uint32_t number) const {
    std::string all;
    for (std::size_t i = run(number).first; i < run(number).end(); ++i) {
      const auto* const e = session_.document.entities.find<world::Equipment>(session_.document.track.segments[i]);
      all += e ? std::string(base::name_of(e->kind)) + ' ' : "- ";
    }
    return all;
  }
  bool all_equipped(std::uint32_t number, std::string_view kind) const {
    std::string expected;
    for (std::size_t i = 0; i < run(number).count; ++i) expected += std::string(kind) + ' ';
    return equipment(number) == expected;
  }
  glm::dvec3 end() const {
    return glm::dvec3(world::knot(session_.document, session_.document.track.knots.back()).position);
  }
  // A place on the section's middle segment, and its first knot, on the screen.
  glm::vec2 pixel_on(std::uint32_t number) const { return pixel(place_on(number)); }
  glm::vec3 place_on(std::uint32_t number) const {
    const std::size_t middle = run(number).first + run(number).count / 2;
    return glm::vec3(curve::point(session_.derived.shape_at(middle).key.cubic, 0.4));
  }
  glm::vec2 pixel_of_knot(std::size_t index) const {
    return pixel(world::knot(session_.document, session_.document.track.knots[index]).position);
  }
  glm::vec2 pixel(glm::vec3 place) const {
    const auto at = view::project(host_->view(), place);
    EXPECT_TRUE(at.has_value());
    return at ? glm::vec2(*at) : glm::vec2(0);
  }
  void rest() { frames(40); }  // the next click is no double click
};

}  // namespace coaster::ui
