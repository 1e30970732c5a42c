// The commands of knots, joints, carts, the document's own numbers, and the coaster's kind and paint. See command.h.
#pragma once

#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include "edit/commands/command_fields.h"
#include "world/coaster_kind.h"
#include "world/components.h"
#include "world/paint.h"

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

COASTER_COMMAND_GROUP(Coaster);

struct SetKind {
  world::CoasterKind to{};
  COASTER_COMMAND(SetKind, "kind",
                  "Set the kind of coaster: its track, trains, supports and clearance. Heartline and losses follow if "
                  "they are the usual ones of the former kind.",
                  Effect::document, "Made the coaster {}");
  COASTER_FIELDS(visit("", self.to))
};
struct PaintTrack {
  world::Palette to{};
  COASTER_COMMAND(PaintTrack, "paint",
                  "Paint track and trains in the colours of a palette; own: the kind's usual ones.", Effect::document,
                  "Painted the coaster {}");
  COASTER_FIELDS(visit("", self.to))
};
struct PaintTrackPart {
  world::PaintPart part{};
  world::Colour to;
  COASTER_COMMAND(PaintTrackPart, "paint.colour",
                  "Paint one part of track and trains in a colour, \"#d9452f\"; own: the kind's usual one.",
                  Effect::document, "Painted the {} {to}");
  COASTER_FIELDS(visit("", self.part), visit("to", self.to))
};
struct PaintSections {
  Sections sections;
  world::Palette to{};
  COASTER_COMMAND(PaintSections, "section.paint",
                  "Paint the track of sections in the colours of a palette; own: as the rest of the track.",
                  Effect::document, "Painted {} {to}");
  COASTER_FIELDS(visit("", self.sections), visit("to", self.to))
};
struct PaintSectionsPart {
  Sections sections;
  world::PaintPart part{};
  world::Colour to;
  COASTER_COMMAND(PaintSectionsPart, "section.paint.colour",
                  "Paint one part of the track of sections in a colour, \"#d9452f\"; own: as the rest of the track.",
                  Effect::document, "Painted the {of} of {} {to}");
  COASTER_FIELDS(visit("", self.sections), visit("of", self.part), visit("to", self.to))
};

COASTER_COMMAND_LIST(Coaster, SetKind, PaintTrack, PaintTrackPart, PaintSections, PaintSectionsPart);

}  // namespace coaster::edit
