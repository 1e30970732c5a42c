// The commands of the history and of the document's file. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "exchange/own/import_options.h"
#include "world/park.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Session);

struct Undo {
  COASTER_COMMAND(Undo, "undo", "Undo the last step.", Effect::history);
  COASTER_FIELDS()
};
struct Redo {
  COASTER_COMMAND(Redo, "redo", "Redo the step undone last.", Effect::history);
  COASTER_FIELDS()
};
// Commands between begin and end are one undo step; cancel restores the document from begin exactly.
struct BeginGesture {
  COASTER_COMMAND(BeginGesture, "gesture.begin", "Commands up to gesture.end are one undo step.", Effect::history);
  COASTER_FIELDS()
};
struct EndGesture {
  COASTER_COMMAND(EndGesture, "gesture.end", "End a gesture.", Effect::history);
  COASTER_FIELDS()
};
struct CancelGesture {
  COASTER_COMMAND(CancelGesture, "gesture.cancel", "End a gesture and restore the document from before it.",
                  Effect::history);
  COASTER_FIELDS()
};
struct LoadTrack {
  std::string path;
  exchange::ImportOptions import = {};
  COASTER_COMMAND(
      LoadTrack, "load",
      "Open a track file; its extension selects the format. Or open a shared link. The words say how a list "
      "of points becomes a track; origin moves it, or NoLimits 2 rows, to the origin.",
      Effect::session, {}, kOpensTrack);
  COASTER_FIELDS(visit("", self.path), visit("", self.import))
};
// Refused with Code::io if another program changed the document's own file since it was opened, unless `overwrite`.
struct Save {
  std::string path;
  Flag overwrite{}, park{};
  COASTER_COMMAND(Save, "save",
                  "Save the track to a file, or export it: the extension selects the format. With overwrite, also "
                  "replace changes by another program. With park, glTF and OBJ hold land, water and plants, too.",
                  Effect::session, {}, kWritesFile);
  COASTER_FIELDS(visit("", self.path), visit("overwrite?", self.overwrite), visit("park?", self.park))
};
struct CopyLink {
  COASTER_COMMAND(
      CopyLink, "share",
      "Copy a link that holds the track, the camera and the evaluator. load opens it, and so does a browser.",
      Effect::settings);
  COASTER_FIELDS()
};
struct RecoverTrack {
  std::string path, original;
  COASTER_COMMAND(RecoverTrack, "recover",
                  "Open an autosaved track as the unsaved state of another file, which may be \"\": none.",
                  Effect::session, {}, kOpensTrack);
  COASTER_FIELDS(visit("", self.path), visit("as", self.original))
};
struct NewTrack {
  COASTER_COMMAND(NewTrack, "new", "Start an empty track.", Effect::session, {}, {.replaces = true});
  COASTER_FIELDS()
};

struct NewPark {
  world::Land land{};
  std::int64_t seed = 7;
  COASTER_COMMAND(NewPark, "new.park", "Start an empty track in a park: a land and its seed.", Effect::session, {},
                  {.replaces = true});
  COASTER_FIELDS(visit("", self.land), visit("seed?", self.seed))
};

COASTER_COMMAND_LIST(Session, Undo, Redo, BeginGesture, EndGesture, CancelGesture, LoadTrack, Save, CopyLink,
                     RecoverTrack, NewTrack, NewPark);

}  // namespace coaster::edit
