// The commands of sections, and of the palette: elements at the open end of the track. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "world/components.h"
#include "world/element.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Section);

struct MakeSection {
  Knots knots;
  COASTER_COMMAND(MakeSection, "section.make",
                  "Make the track between neighbouring knots one hand-shaped section; its shape stays.",
                  Effect::document, "Made {} a section");
  COASTER_FIELDS(visit("", self.knots))
};
struct SplitSection {
  Target knot;
  COASTER_COMMAND(SplitSection, "section.split", "Split a section in two at a knot inside it.", Effect::document,
                  "Split a section at {}");
  COASTER_FIELDS(visit("", self.knot))
};
struct JoinSections {
  Target section;
  COASTER_COMMAND(JoinSections, "section.join", "Join a section with the next one.", Effect::document,
                  "Joined {} with the next section");
  COASTER_FIELDS(visit("", self.section))
};
struct SetSectionTitle {
  Target section;
  std::string to;
  COASTER_COMMAND(SetSectionTitle, "section.title", "Set the title of a section; without one, its kind is shown.",
                  Effect::document, "Titled {} {to}");
  COASTER_FIELDS(visit("", self.section), visit("to", self.to))
};
// `from_start on` starts from the section as it was when the open gesture began.
struct ChangeSection {
  Target section;
  bool from_start = false;
  world::Element to;
  COASTER_COMMAND(ChangeSection, "section.change",
                  "Plan a section again as an element with these parameters; the track that follows moves with its "
                  "end. Parameters that are not named get their defaults.",
                  Effect::document, "Changed {}");
  COASTER_FIELDS(visit("", self.section), visit("from_start?|anew", self.from_start), visit("to", self.to))
};
struct EquipSection {
  Target section;
  world::Equipment to;
  COASTER_COMMAND(EquipSection, "section.equip",
                  "Put a station, lift, launch, brake or block on all segments of a section (m/s, m/s^2, m/s, s).",
                  Effect::document, "Made {} a {as}");
  COASTER_FIELDS(visit("", self.section); visit_equipment(self.to, visit))
};
struct UnequipSection {
  Target section;
  COASTER_COMMAND(UnequipSection, "section.unequip", "Make all of a section plain track again.", Effect::document,
                  "Removed the equipment of {}");
  COASTER_FIELDS(visit("", self.section))
};

struct DeleteSection {
  Target section;
  COASTER_COMMAND(DeleteSection, "section.delete",
                  "Delete a section of an open track; the track that follows moves to its start.", Effect::document,
                  "Deleted {}");
  COASTER_FIELDS(visit("", self.section))
};
struct MirrorSection {
  Target section;
  COASTER_COMMAND(MirrorSection, "section.mirror",
                  "Swap left and right of a section, with its roll; the track that follows moves with its end.",
                  Effect::document, "Mirrored {}");
  COASTER_FIELDS(visit("", self.section))
};
enum class Neighbour : std::uint8_t { before, after };
inline constexpr base::NameRow kNeighbours[] = {{"before", "Before", "Towards the start of the track."},
                                                {"after", "After", "Towards its end."}};
constexpr std::span<const base::NameRow> rows_of(Neighbour) { return kNeighbours; }
struct MoveSection {
  Target section;
  Neighbour to{};
  COASTER_COMMAND(
      MoveSection, "section.move",
      "Swap a section of an open track with the one before or after it; the track that follows moves along.",
      Effect::document, "Moved {} along the track");
  COASTER_FIELDS(visit("", self.section), visit("", self.to))
};
struct CopySection {
  Sections sections;
  COASTER_COMMAND(CopySection, "section.copy", "Copy sections, in the track's order, for section.paste.",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.sections))
};
struct PasteSections {
  std::string text;  // a track; empty: the sections copied last
  COASTER_COMMAND(PasteSections, "section.paste",
                  "Add the copied sections, or all sections of a track's text, at the open end of the track.",
                  Effect::document, "Pasted sections");
  COASTER_FIELDS(visit("text?", self.text))
};

struct SaveSections {
  std::string path;
  Sections sections;
  COASTER_COMMAND(SaveSections, "section.save",
                  "Save sections to a file, as a track: the extension selects the format. See section.open.",
                  Effect::session, {}, kWritesFile);
  COASTER_FIELDS(visit("", self.path), visit("", self.sections))
};
struct OpenSections {
  std::string path;
  COASTER_COMMAND(
      OpenSections, "section.open",
      "Add the sections of a track file at the open end of the track; planned ones are planned again there.",
      Effect::document, "Added sections of {}", {PathUse::opens, RecordedForm::track});
  COASTER_FIELDS(visit("", self.path))
};

COASTER_COMMAND_LIST(Section, MakeSection, SplitSection, JoinSections, SetSectionTitle, ChangeSection, EquipSection,
                     UnequipSection, DeleteSection, MirrorSection, MoveSection, CopySection, PasteSections,
                     SaveSections, OpenSections);

COASTER_COMMAND_GROUP(Element);

struct PlaceElement {
  world::Element what;
  COASTER_COMMAND(PlaceElement, "element",
                  "Add an element at the open end of the track, e.g. element loop right height 20; parameters that are "
                  "not named get their defaults.",
                  Effect::document, "Placed {}");
  COASTER_FIELDS(visit("", self.what))
};
struct ChooseElement {
  world::Element what;
  COASTER_COMMAND(ChooseElement, "element.choose",
                  "Select the palette's element and its parameters, and show its preview.", Effect::settings);
  COASTER_FIELDS(visit("", self.what))
};

struct CompleteCircuit {
  int proposal = 1;
  COASTER_COMMAND(CompleteCircuit, "complete",
                  "Close the track by a section from its open end to its first knot: one of up to three proposals.",
                  Effect::document, "Completed the circuit");
  COASTER_FIELDS(visit("", self.proposal))
};

COASTER_COMMAND_LIST(Element, PlaceElement, ChooseElement, CompleteCircuit);

}  // namespace coaster::edit
