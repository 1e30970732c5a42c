// The commands of the history, of the document's file, and of searches for numbers that reach a goal. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "exchange/own/import_options.h"
#include "world/document.h"
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

COASTER_COMMAND_GROUP(Seek);

// `by` is height, x, z, place or roll of knots, or a parameter of sections. Of force sections it is length, a channel
// for all of its keys, or "vertical at 40" for one key. The limits apply to each of these numbers: m, or degrees for
// roll, or the unit of the parameter or key.
struct SeekGoal {
  Phrase goal, by;
  KnotsOrSections of;
  Knots except;
  double above = -world::kMaxCoordinate, below = world::kMaxCoordinate;
  bool together = false;
  COASTER_COMMAND(SeekGoal, "seek",
                  "Change numbers as little as possible until a query has a value: seek ride.lap_time == 40 by height "
                  "of @k3..@k9. By height, x, z, place or roll of knots, or by a parameter of sections. Knots of "
                  "except stay; above and below are limits; with together on, all change by the same amount. Of force "
                  "sections by length, by the keys of a channel, or by one key: by vertical at 40.",
                  Effect::document, "Changed {by} of {of} for {}");
  COASTER_FIELDS(visit("", self.goal), visit("by", self.by), visit("of", self.of), visit("except?", self.except),
                 visit("above?", self.above), visit("below?", self.below), visit("together?", self.together))
};

COASTER_COMMAND_LIST(Seek, SeekGoal);

}  // namespace coaster::edit
