// The commands of the palette: elements at the open end of the track. See command.h.
#pragma once

#include "edit/commands/command_fields.h"
#include "world/element.h"

namespace coaster::edit {
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
