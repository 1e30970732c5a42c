// The commands of the coaster's kind and paint. See command.h.
#pragma once

#include "edit/commands/command_fields.h"
#include "world/coaster_kind.h"
#include "world/paint.h"

namespace coaster::edit {
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
