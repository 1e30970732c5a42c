// The commands of force sections. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "world/force_program.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Force);

struct AddForceSection {
  world::ForceDomain over{};
  double length = 40, tolerance = 0.05;
  world::ForceQuantity of{};
  COASTER_COMMAND(
      AddForceSection, "force.add",
      "Add a section of forces or curvature at the open end of the track: length in m or s, tolerance in g.",
      Effect::document, "Added a force section");
  COASTER_FIELDS(visit("over?", self.over), visit("of?", self.of), visit("length?", self.length),
                 visit("tolerance?", self.tolerance))
};
// In these commands `from_start on` uses the keys that the section had when the open gesture began.
struct SetForceKey {
  Target section;
  bool from_start = false;
  world::ForceChannel channel{};
  double value = 0, at = 0;
  COASTER_COMMAND(SetForceKey, "force",
                  "Set what riders should feel at a place of a force section (g, or degrees per metre or second; of "
                  "curvature 1/m, or degrees), e.g. force @q3 vertical key 2.5 at 40.",
                  Effect::document, "Set a key of {} at {at}");
  COASTER_FIELDS(visit("", self.section), visit("from_start?", self.from_start), visit("", self.channel),
                 visit("key", self.value), visit("at", self.at))
};
struct InsertForceKey {
  Target section;
  world::ForceChannel channel{};
  double at = 0;
  COASTER_COMMAND(InsertForceKey, "force.insert",
                  "Insert a key on the curve of a channel; what riders should feel stays the same.", Effect::document,
                  "Inserted a key of {} at {at}");
  COASTER_FIELDS(visit("", self.section), visit("", self.channel), visit("at", self.at))
};
struct MoveForceKey {
  Target section;
  bool from_start = false;
  world::ForceChannel channel{};
  double at = 0, to = 0, value = 0;
  COASTER_COMMAND(MoveForceKey, "force.move", "Move a key of a force section to another place and value.",
                  Effect::document, "Moved a key of {}");
  COASTER_FIELDS(visit("", self.section), visit("from_start?", self.from_start), visit("", self.channel),
                 visit("at", self.at), visit("to", self.to), visit("key", self.value))
};
struct RemoveForceKey {
  Target section;
  bool from_start = false;
  world::ForceChannel channel{};
  double at = 0;
  COASTER_COMMAND(RemoveForceKey, "force.remove", "Remove a key of a force section.", Effect::document,
                  "Removed a key of {}");
  COASTER_FIELDS(visit("", self.section), visit("from_start?", self.from_start), visit("", self.channel),
                 visit("at", self.at))
};
struct ShapeForceKey {
  Target section;
  bool from_start = false;
  world::ForceChannel channel{};
  double at = 0, slope = 0, before = 0, after = 0;
  COASTER_COMMAND(ShapeForceKey, "force.handle",
                  "Set the slope of a channel's curve at a key, and how far its handles reach (m or s; 0: a third of "
                  "the distance to the next key).",
                  Effect::document, "Shaped a key of {}");
  COASTER_FIELDS(visit("", self.section), visit("from_start?", self.from_start), visit("", self.channel),
                 visit("at", self.at), visit("slope", self.slope), visit("before?", self.before),
                 visit("after?", self.after))
};
struct CopyForceKeys {
  Target section;
  world::ForceChannel channel{};
  double from = 0, to = world::kLongestForce_m;
  COASTER_COMMAND(CopyForceKeys, "force.copy",
                  "Copy the keys of a channel for force.paste: all, or those from a place to another.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.section), visit("", self.channel), visit("from?", self.from), visit("to?", self.to))
};
struct PasteForceKeys {
  Target section;
  world::ForceChannel channel{};
  double at = 0;
  std::string text;  // keys as printed by force.copy; empty: the keys copied last
  COASTER_COMMAND(PasteForceKeys, "force.paste",
                  "Put copied keys into a channel, the first at a place; they replace the keys among them.",
                  Effect::document, "Pasted keys of {}");
  COASTER_FIELDS(visit("", self.section), visit("", self.channel), visit("at", self.at), visit("text?", self.text))
};
struct SetForceLength {
  Target section;
  bool from_start = false;
  double to = 0;
  COASTER_COMMAND(SetForceLength, "force.length", "Set the length of a force section, m or s.", Effect::document,
                  "Set the length of {} to {to}");
  COASTER_FIELDS(visit("", self.section), visit("from_start?", self.from_start), visit("to", self.to))
};
struct SetForceTolerance {
  Target section;
  double to = 0;
  COASTER_COMMAND(
      SetForceTolerance, "force.tolerance",
      "Set the largest difference between what riders feel on a force section and its keys, g: 0.02 to 0.5.",
      Effect::document, "Set the tolerance of {} to {to} g");
  COASTER_FIELDS(visit("", self.section), visit("to", self.to))
};
struct SetForceDomain {
  Target section;
  world::ForceDomain to{};
  COASTER_COMMAND(SetForceDomain, "force.over",
                  "Use metres or seconds for the keys of a force section; they keep their positions.", Effect::document,
                  "Counted the keys of {} over {to}");
  COASTER_FIELDS(visit("", self.section), visit("to", self.to))
};
struct SetForceQuantity {
  Target section;
  world::ForceQuantity to{};
  COASTER_COMMAND(SetForceQuantity, "force.of",
                  "Use forces or curvature for the keys of a force section; they take what the track has there.",
                  Effect::document, "Changed the keys of {} to {to}");
  COASTER_FIELDS(visit("", self.section), visit("to", self.to))
};

struct HoldForceSectionEnds {
  Target section;
  bool on{};
  COASTER_COMMAND(
      HoldForceSectionEnds, "force.hold",
      "Keep both ends of a force section in place when its keys change. Riders then feel the keys as closely "
      "as that allows; force.unmet is the difference.",
      Effect::document, "Set whether both ends of {} stay");
  COASTER_FIELDS(visit("", self.section), visit("", self.on))
};

struct MakeForceSection {
  Sections sections;
  double tolerance = 0.05;
  COASTER_COMMAND(
      MakeForceSection, "force.read",
      "Make a section, or neighbouring ones together, a force section of their shape, within 1 cm: their g and roll at "
      "the present speed become keys. What follows stays.",
      Effect::document, "Made {} a force section");
  COASTER_FIELDS(visit("", self.sections), visit("tolerance?", self.tolerance))
};
struct FreeForceSection {
  Target section;
  COASTER_COMMAND(FreeForceSection, "force.free",
                  "Make a force section hand-shaped: its knots stay, its keys are removed.", Effect::document,
                  "Made {} hand-shaped");
  COASTER_FIELDS(visit("", self.section))
};

COASTER_COMMAND_LIST(Force, AddForceSection, SetForceKey, InsertForceKey, MoveForceKey, RemoveForceKey, ShapeForceKey,
                     CopyForceKeys, PasteForceKeys, SetForceLength, SetForceTolerance, SetForceDomain, SetForceQuantity,
                     HoldForceSectionEnds, MakeForceSection, FreeForceSection);

}  // namespace coaster::edit
