// The commands of the history and of the document's file. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"

namespace coaster::edit {

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

}  // namespace coaster::edit
