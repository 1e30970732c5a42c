// The handles of the selected section in the view: its height, length or radius on a line, its turn and bank on rings.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "view/camera.h"
#include "view/overlay.h"
#include "view/pick.h"

namespace coaster::view {

struct SectionHandle {
  world::Entity section;
  std::string_view parameter;  // "height", "length" or "radius"
  double value = 0;            // present value of the parameter
  glm::dvec3 from{0}, at{0};   // m: where the section begins, and the handle, on the rails' curve
};

// Returns the handle of a planned section: its height at the point farthest above or below its start, else its length
// or its radius at its end. Nothing for other sections.
std::optional<SectionHandle> section_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                            world::Entity section);
// True if handles show: in the workspace Build with one section selected.
bool section_handles_show(const world::Settings& settings);

// Returns the value of the parameter that puts the handle where the ray meets its line (height, length) or the level
// plane (radius); nothing if they do not meet. The position of a handle is proportional to its value.
std::optional<double> value_under(const SectionHandle& handle, const Ray& ray);

void add_section_handle(const SectionHandle& handle, float scale, bool hovered, Overlay& overlay);

struct AngleHandle {
  PickKind kind = PickKind::none;  // turn or bank
  world::Entity section;
  std::string_view parameter;  // "angle", "turns" or "bank"
  double angle = 0;            // deg, present value; a turn of 360 deg and more continues to count
  double whole = 1;            // value of the parameter divided by its angle in deg
  glm::dvec3 centre{0};        // m
  glm::dvec3 axis{0, 1, 0};    // unit, axis of positive angles
  glm::dvec3 zero{1, 0, 0};    // m, from the centre to the ring where the angle is 0
  glm::dvec3 at(double deg) const;
};

// Returns the handles of a planned section. An element that turns in plan has its turn, as a level ring about the
// centre of the turn at the height where it begins; one with a bank parameter has its bank, as a ring about the rails
// where it is steepest. A bank that follows from a speed has none.
std::vector<AngleHandle> angle_handles(const world::Document& document, const sim::DerivedTrack& derived,
                                       world::Entity section);
// Returns the handle of one kind.
std::optional<AngleHandle> angle_handle(const world::Document& document, const sim::DerivedTrack& derived,
                                        world::Entity section, PickKind kind);

// Returns the angle (deg) of the handle where the ray meets the ring's plane, with the whole turns that bring it
// nearest to `near`; nothing if the plane is seen edge-on.
std::optional<double> angle_under(const AngleHandle& handle, const Ray& ray, double near);

// Adds the ring, an arc from 0 to the angle, and the handle.
void add_angle_handle(const AngleHandle& handle, float scale, bool hovered, Overlay& overlay);

}  // namespace coaster::view
