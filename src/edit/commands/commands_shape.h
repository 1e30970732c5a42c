// The commands that shape several knots at once, and the whole track. See command.h.
#pragma once

#include <glm/glm.hpp>

#include "edit/commands/command_fields.h"
#include "world/settings.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Shape);

// `from_start on` starts from the knots' state when the open gesture began: if a drag sends several commands, only the
// last one counts.
struct Translate {
  Knots knots;
  glm::vec3 by{0};
  bool from_start = false;
  COASTER_COMMAND(Translate, "translate",
                  "Move knots by a distance (m). With from_start on, from where they were when the gesture began.",
                  Effect::document, "Moved {}");
  COASTER_FIELDS(visit("", self.knots), visit("by", self.by), visit("from_start?|anew", self.from_start))
};
struct Rotate {
  Knots knots;
  double by = 0;
  glm::vec3 about{0}, axis{0, 1, 0};
  bool from_start = false;
  COASTER_COMMAND(Rotate, "rotate", "Turn knots by an angle (degrees, right-handed) about a point and an axis.",
                  Effect::document, "Rotated {} by {by}\u00B0");
  COASTER_FIELDS(visit("", self.knots), visit("by", self.by), visit("about", self.about), visit("axis?", self.axis),
                 visit("from_start?|anew", self.from_start))
};
struct Scale {
  Knots knots;
  glm::vec3 by{1}, about{0};
  bool from_start = false;
  COASTER_COMMAND(Scale, "scale_knots", "Scale knots and their handles along x, y and z about a point.",
                  Effect::document, "Scaled {}");
  COASTER_FIELDS(visit("", self.knots), visit("by", self.by), visit("about", self.about),
                 visit("from_start?|anew", self.from_start))
};
struct Mirror {
  Knots knots;
  glm::vec3 across{1, 0, 0}, about{0};
  COASTER_COMMAND(Mirror, "mirror", "Mirror knots across the plane through a point with a normal.", Effect::document,
                  "Mirrored {}");
  COASTER_FIELDS(visit("", self.knots), visit("across", self.across), visit("about", self.about))
};
struct Align {
  Knots knots;
  world::Axis axis = world::Axis::y;
  double to = 0;
  COASTER_COMMAND(Align, "align", "Give knots one coordinate (m): x, y or z.", Effect::document,
                  "Aligned {} at {axis} = {to} m");
  COASTER_FIELDS(visit("", self.knots), visit("axis", self.axis), visit("to", self.to))
};
struct Smooth {
  Knots knots;
  world::SplineSteps by = world::SplineSteps::chord;
  COASTER_COMMAND(Smooth, "smooth",
                  "Give knots the direction and handles of the natural C2 spline through them, with chords or equal "
                  "steps as the parameter.",
                  Effect::document, "Smoothed {}");
  COASTER_FIELDS(visit("", self.knots), visit("by?", self.by))
};
struct Equalise {
  Knots knots;
  COASTER_COMMAND(Equalise, "equalise", "Make both handles of knots as long as they are on average: C1.",
                  Effect::document, "Equalised the handles of {}");
  COASTER_FIELDS(visit("", self.knots))
};
struct Straighten {
  Knots knots;
  COASTER_COMMAND(Straighten, "straighten", "Put neighbouring knots on the line from the first to the last of them.",
                  Effect::document, "Straightened {}");
  COASTER_FIELDS(visit("", self.knots))
};
struct SetRadius {
  Knots knots;
  double to = 20;
  COASTER_COMMAND(SetRadius, "radius", "Set the radius of curvature at knots (m), by the lengths of their handles.",
                  Effect::document, "Set the radius at {} to {to} m");
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct DropToGround {
  Knots knots;
  double to = 0;
  COASTER_COMMAND(DropToGround, "drop", "Put knots on the ground (or at a height, m), level.", Effect::document,
                  "Put {} at height {to} m");
  COASTER_FIELDS(visit("", self.knots), visit("to?", self.to))
};
struct Reverse {
  COASTER_COMMAND(Reverse, "reverse", "Reverse the direction of travel; the shape stays.", Effect::document,
                  "Reversed the track");
  COASTER_FIELDS()
};
struct Duplicate {
  Knots knots;
  COASTER_COMMAND(
      Duplicate, "duplicate",
      "Copy the track between neighbouring knots to the end of an open track, turned to continue from there.",
      Effect::document, "Duplicated {}");
  COASTER_FIELDS(visit("", self.knots))
};
struct CloseExactly {
  double within = 2;
  COASTER_COMMAND(
      CloseExactly, "close",
      "Close the track: ends within a distance (m) of each other become one knot, others get a segment between them.",
      Effect::document, "Closed the track");
  COASTER_FIELDS(visit("within?", self.within))
};

COASTER_COMMAND_LIST(Shape, Translate, Rotate, Scale, Mirror, Align, Smooth, Equalise, Straighten, SetRadius,
                     DropToGround, Reverse, Duplicate, CloseExactly);

}  // namespace coaster::edit
