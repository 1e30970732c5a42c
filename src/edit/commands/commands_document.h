// The commands of knots, joints, carts and the document's own numbers. See command.h.
#pragma once

#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "edit/commands/command_fields.h"
#include "world/components.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Document);

struct MoveKnot {
  Target knot;
  glm::vec3 to{0};
  COASTER_COMMAND(MoveKnot, "move", "Move a knot to a position (m).", Effect::document, "Moved {}");
  COASTER_FIELDS(visit("", self.knot), visit("to", self.to))
};
struct MoveHandle {
  HandleTarget handle;
  glm::vec3 to{0};
  COASTER_COMMAND(MoveHandle, "handle",
                  "Move a handle to a position (m): sets the knot's direction and that side's length; a smooth joint "
                  "keeps both sides equal.",
                  Effect::document, "Moved {}");
  COASTER_FIELDS(visit("", self.handle), visit("to", self.to))
};
struct SetDirection {
  Knots knots;
  glm::vec3 to{1, 0, 0};
  COASTER_COMMAND(SetDirection, "direct", "Turn the tangents of knots to a direction.", Effect::document, "Turned {}");
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct SetHandleLengths {
  Knots knots;
  float in = 5, out = 5;
  COASTER_COMMAND(SetHandleLengths, "lengths",
                  "Set handle lengths of knots (m); different ones make a smooth joint aligned.", Effect::document,
                  "Set the handle lengths of {}");
  COASTER_FIELDS(visit("", self.knots), visit("in", self.in), visit("out", self.out))
};
struct SetRoll {
  Knots knots;
  double to = 0;
  COASTER_COMMAND(SetRoll, "roll", "Set the roll of knots (degrees from the horizon, positive to the rider's right).",
                  Effect::document, "Set the roll of {} to {to}\u00B0");
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct SetSpin {
  Knots knots;
  double to = 0;
  COASTER_COMMAND(SetSpin, "spin",
                  "Set the spin of knots: the rate at which the track rolls there (degrees per metre, positive to the "
                  "rider's right).",
                  Effect::document, "Set the spin of {} to {to} \u00B0/m");
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct AutomaticSpin {
  Knots knots;
  COASTER_COMMAND(AutomaticSpin, "auto_spin",
                  "Let the spin of knots follow from the roll of their neighbours, without overshoot.",
                  Effect::document, "Made the spin of {} automatic");
  COASTER_FIELDS(visit("", self.knots))
};
struct SetJoint {
  Knots knots;
  world::JointKind to = world::JointKind::smooth;
  COASTER_COMMAND(SetJoint, "joint", "Set the joint of knots: smooth, aligned or automatic.", Effect::document,
                  "Set the joint of {} to {to}");
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct SetTurns {
  Target segment;
  int to = 0;
  COASTER_COMMAND(SetTurns, "turns", "Set the whole turns of roll within a segment.", Effect::document,
                  "Set the turns of {} to {to}");
  COASTER_FIELDS(visit("", self.segment), visit("to", self.to))
};
struct SplitSegment {
  Target segment;
  double at = 0.5;
  COASTER_COMMAND(SplitSegment, "split",
                  "Insert a knot into a segment at a parameter, keeping the shape (de Casteljau).", Effect::document,
                  "Inserted a knot into {}");
  COASTER_FIELDS(visit("", self.segment), visit(":at", self.at))
};
struct SplitLongestSegment {
  COASTER_COMMAND(SplitLongestSegment, "add_curve",
                  "Split the longest segment at half its arc length; on an open track with no segment, append a knot.",
                  Effect::document, "Added a curve");
  COASTER_FIELDS()
};
struct AppendKnot {
  glm::vec3 at{0};
  COASTER_COMMAND(AppendKnot, "append", "Append a knot to an open track.", Effect::document, "Appended a knot");
  COASTER_FIELDS(visit("at", self.at))
};
struct RemoveKnotOrTrain {
  static constexpr std::string_view kTargets = "@knot|@cart";
  Target what;
  COASTER_COMMAND(RemoveKnotOrTrain, "remove", "Remove a knot or a train.", Effect::document, "Deleted {}");
  COASTER_FIELDS(visit("", self.what))
};
struct SetClosed {
  bool to = true;
  COASTER_COMMAND(SetClosed, "closed", "Close the track (on) or open it (off).", Effect::document,
                  "{?Closed|Opened} the track");
  COASTER_FIELDS(visit("", self.to))
};
struct AddTrain {
  Target segment;
  double at = 0;
  COASTER_COMMAND(AddTrain, "add_cart", "Add a train that starts on a segment, at a fraction of its length.",
                  Effect::document, "Added a train");
  COASTER_FIELDS(visit("", self.segment), visit("at", self.at))
};
struct SetTrackName {
  std::string to;
  COASTER_COMMAND(SetTrackName, "name", "Name the track.", Effect::document, "Named the track {}");
  COASTER_FIELDS(visit("", self.to))
};
struct SetStartSpeed {
  double to = 1;
  COASTER_COMMAND(SetStartSpeed, "start_speed", "Set the speed at which trains start (m/s).", Effect::document,
                  "Set the start speed to {} m/s");
  COASTER_FIELDS(visit("", self.to))
};
struct SetDatum {
  double to = 0;
  COASTER_COMMAND(SetDatum, "datum", "Set the height at which potential energy is zero (m).", Effect::document,
                  "Set the datum to {} m");
  COASTER_FIELDS(visit("", self.to))
};

// Makes all joints of a track G2 with the least movement (edit/perform/joint_repair.h).
struct MakeG2 {
  Target knot;
  COASTER_COMMAND(
      MakeG2, "make_g2",
      "Give a knot's two segments the same curvature (G2) with the least movement; other joints keep their class.",
      Effect::document, "Made {} G2");
  COASTER_FIELDS(visit("", self.knot))
};
struct MakeAllG2 {
  COASTER_COMMAND(MakeAllG2, "make_all_g2",
                  "Make every joint G2 with little movement; reports the joints that cannot be.", Effect::document,
                  "Made all joints G2");
  COASTER_FIELDS()
};

COASTER_COMMAND_LIST(Document, MoveKnot, MoveHandle, SetDirection, SetHandleLengths, SetRoll, SetSpin, AutomaticSpin,
                     SetJoint, SetTurns, SplitSegment, SplitLongestSegment, AppendKnot, RemoveKnotOrTrain, SetClosed,
                     AddTrain, SetTrackName, SetStartSpeed, SetDatum, MakeG2, MakeAllG2);

}  // namespace coaster::edit
