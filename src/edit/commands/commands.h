// The one vocabulary: everything that a person, a script or a recording can make the program do to document, motion and
// settings. Plain structs with a name, a line of help and a list of fields; from these come printing, parsing, help and
// completion. Those that shape several knots are in commands_shape.h, those on how things are shown in
// commands_settings.h, of the game in commands_challenge.h, of the palette in commands_elements.h, of the laboratory in
// commands_lab.h, of the ride's operation in commands_operation.h. Commands carry names and numbers, never screen
// coordinates.
#pragma once

#include <any>
#include <string>
#include <string_view>
#include <utility>

#include <glm/glm.hpp>

#include "edit/commands/command_fields.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_lab.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "world/document.h"

namespace coaster::edit {

// --- document
// ---------------------------------------------------------------------------------------------------------
struct MoveKnot {
  Target knot;
  glm::vec3 to{0};
  COASTER_COMMAND("move", "Move a knot to a position (m).", Effect::document);
  COASTER_FIELDS(visit("", self.knot), visit("to", self.to))
};
struct MoveHandle {
  HandleTarget handle;
  glm::vec3 to{0};
  COASTER_COMMAND("handle",
                  "Move a handle to a position (m): sets the knot's direction and that side's length; a smooth joint "
                  "keeps both sides equal.",
                  Effect::document);
  COASTER_FIELDS(visit("", self.handle), visit("to", self.to))
};
struct SetDirection {
  Knots knots;
  glm::vec3 to{1, 0, 0};
  COASTER_COMMAND("direct", "Turn the tangents of knots to a direction.", Effect::document);
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct SetLengths {
  Knots knots;
  float in = 5, out = 5;
  COASTER_COMMAND("lengths", "Set handle lengths of knots (m); different ones make a smooth joint aligned.",
                  Effect::document);
  COASTER_FIELDS(visit("", self.knots), visit("in", self.in), visit("out", self.out))
};
struct SetRoll {
  Knots knots;
  double to = 0;
  COASTER_COMMAND("roll", "Set the roll of knots (degrees from the horizon, positive to the rider's right).",
                  Effect::document);
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct SetJoint {
  Knots knots;
  world::JointKind to = world::JointKind::smooth;
  COASTER_COMMAND("joint", "Set the joint of knots: smooth, aligned or automatic.", Effect::document);
  COASTER_FIELDS(visit("", self.knots), visit("to", self.to))
};
struct SetTurns {
  Target segment;
  int to = 0;
  COASTER_COMMAND("turns", "Set the whole turns of roll within a segment.", Effect::document);
  COASTER_FIELDS(visit("", self.segment), visit("to", self.to))
};
struct SplitSegment {
  Target segment;
  double at = 0.5;
  COASTER_COMMAND("split", "Insert a knot into a segment at a parameter, keeping the shape (de Casteljau).",
                  Effect::document);
  COASTER_FIELDS(visit("", self.segment), visit("at", self.at))
};
struct AddCurve {
  COASTER_COMMAND("add_curve",
                  "Split the longest segment at half its arc length; on an open track with no segment, append a knot.",
                  Effect::document);
  COASTER_FIELDS()
};
struct AppendKnot {
  glm::vec3 at{0};
  COASTER_COMMAND("append", "Append a knot to an open track.", Effect::document);
  COASTER_FIELDS(visit("at", self.at))
};
struct RemoveKnot {
  Target knot;
  COASTER_COMMAND("remove", "Remove a knot or a cart.", Effect::document);
  COASTER_FIELDS(visit("", self.knot))
};
struct SetClosed {
  bool to = true;
  COASTER_COMMAND("closed", "Close the track (on) or open it (off).", Effect::document);
  COASTER_FIELDS(visit("", self.to))
};
struct AddCart {
  Target segment;
  double at = 0;
  COASTER_COMMAND("add_cart", "Add a cart that starts on a segment, at a fraction of its length.", Effect::document);
  COASTER_FIELDS(visit("", self.segment), visit("at", self.at))
};
struct SetName {
  std::string to;
  COASTER_COMMAND("name", "Name the track.", Effect::document);
  COASTER_FIELDS(visit("", self.to))
};
struct SetStartSpeed {
  double to = 1;
  COASTER_COMMAND("start_speed", "Set the speed at which carts start (m/s).", Effect::document);
  COASTER_FIELDS(visit("", self.to))
};
struct SetDatum {
  double to = 0;
  COASTER_COMMAND("datum", "Set the height at which potential energy is zero (m).", Effect::document);
  COASTER_FIELDS(visit("", self.to))
};

// Makes all joints of a track G2 with the least movement (edit/perform/joint_repair.h).
struct MakeG2 {
  Target knot;
  COASTER_COMMAND("make_g2",
                  "Give a knot's two segments one curvature (G2) by moving the least; other joints keep their class.",
                  Effect::document);
  COASTER_FIELDS(visit("", self.knot))
};
struct MakeAllG2 {
  COASTER_COMMAND("make_all_g2", "Make every joint G2 by moving little; says which could not be.", Effect::document);
  COASTER_FIELDS()
};

// --- motion
// -----------------------------------------------------------------------------------------------------------
struct RideStart {
  COASTER_COMMAND("ride.start", "Let the carts run, from where they are.", Effect::motion);
  COASTER_FIELDS()
};
struct RidePause {
  COASTER_COMMAND("ride.pause", "Hold the carts where they are.", Effect::motion);
  COASTER_FIELDS()
};
struct RideStop {
  COASTER_COMMAND("ride.stop", "Put the carts back to their start.", Effect::motion);
  COASTER_FIELDS()
};
struct RideStep {
  int ticks = 1;
  COASTER_COMMAND("ride.step", "Advance a paused ride by some ticks of 1/120 s.", Effect::motion);
  COASTER_FIELDS(visit("", self.ticks))
};
struct RideSeek {
  double to = 0;
  COASTER_COMMAND(
      "ride.seek",
      "Put the selected cart, else the first, at a distance from the track's start (m), keeping its energy.",
      Effect::motion);
  COASTER_FIELDS(visit("", self.to))
};

// --- history and session
// ----------------------------------------------------------------------------------------------
struct Undo {
  COASTER_COMMAND("undo", "Undo the last step.", Effect::history);
  COASTER_FIELDS()
};
struct Redo {
  COASTER_COMMAND("redo", "Redo the step undone last.", Effect::history);
  COASTER_FIELDS()
};
// Commands between begin and end are one undo step; cancel restores the document from begin exactly.
struct BeginGesture {
  COASTER_COMMAND("gesture.begin", "Commands up to gesture.end are one step of undo.", Effect::history);
  COASTER_FIELDS()
};
struct EndGesture {
  COASTER_COMMAND("gesture.end", "End a gesture.", Effect::history);
  COASTER_FIELDS()
};
struct CancelGesture {
  COASTER_COMMAND("gesture.cancel", "End a gesture and put everything back as it was before.", Effect::history);
  COASTER_FIELDS()
};
struct Load {
  std::string path;
  COASTER_COMMAND("load", "Open a track file; its ending tells the format.", Effect::session);
  COASTER_FIELDS(visit("", self.path))
};
struct Save {
  std::string path;
  COASTER_COMMAND("save", "Save the track to a file, or export it: the ending tells the format.", Effect::session);
  COASTER_FIELDS(visit("", self.path))
};
struct RecoverTrack {
  std::string path, original;
  COASTER_COMMAND("recover", "Open an autosaved track as the unsaved state of another file, which may be \"\": none.",
                  Effect::session);
  COASTER_FIELDS(visit("", self.path), visit("as", self.original))
};
struct NewTrack {
  COASTER_COMMAND("new", "Start an empty track.", Effect::session);
  COASTER_FIELDS()
};

// One command of any kind. A std::variant of so many kinds would take half a minute to compile.
class Command {
 public:
  Command() : Command(MoveKnot{}) {}
  template <class C>
  requires requires { C::kInfo; }
  Command(C command) : value_(std::move(command)), info_(&C::kInfo) {}

  const CommandInfo& info() const { return *info_; }  // one object for each kind
  template <class C>
  bool is() const {
    return as<C>() != nullptr;
  }
  // Returns null if it is of another kind.
  template <class C>
  const C* as() const {
    return std::any_cast<C>(&value_);
  }
  template <class C>
  C* as() {
    return std::any_cast<C>(&value_);
  }

 private:
  std::any value_;
  const CommandInfo* info_;
};

inline const CommandInfo& info(const Command& command) { return command.info(); }

// Returns the file that a command writes, or null. Such commands change nothing, and scripts may write only below $OUT.
const std::string* output_path(const Command& command);
// Sets the file of a command that writes one; does nothing for others.
void set_output_path(Command& command, std::string path);

}  // namespace coaster::edit
