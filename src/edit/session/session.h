// What one running program holds: document, settings, motion, derived, history and notices; and apply(), the only way
// to change it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "edit/commands/commands.h"
#include "edit/session/challenge.h"
#include "exchange/own/track_file.h"
#include "sim/plan/elements.h"
#include "sim/ride/ghost.h"
#include "sim/ride/ride.h"
#include "sim/shape/derived.h"
#include "sim/solids/conflicts.h"
#include "sim/study/element_room.h"
#include "sim/study/envelope.h"
#include "sim/study/measure.h"

namespace coaster::edit {

// One step of undo: the document before and after it by value would be twice the memory, so each step keeps one side.
struct HistoryStep {
  std::string label;         // the command's text, or that of a gesture's last command
  world::Document document;  // before the step on the undo stack, after it on the redo stack
};

struct History {
  std::deque<HistoryStep> undo;  // oldest first; the oldest are dropped beyond kMaxHistoryBytes (estimated)
  std::vector<HistoryStep> redo;
  std::size_t undo_bytes = 0;  // estimate of what the undo stack holds
  bool in_gesture = false;
  world::Document gesture_start;
  std::string gesture_label;
};
inline constexpr std::size_t kMaxHistoryBytes = 256u << 20;

enum class NoticeKind : std::uint8_t { info, warning, error };
struct Notice {
  NoticeKind kind = NoticeKind::info;
  std::string text;
  std::uint64_t serial = 0;  // counts up; the panel fades old ones
};

// What the ticks of the live ride take on this machine; nobody's hash depends on it. 0 without a clock and before the
// first tick.
struct RideCost {
  double ns_per_tick = 0;  // all carts together, a mean that forgets: the newest call counts for a tenth
};

// A file that a thread has read in advance; the next load of it takes this.
struct ReadAhead {
  std::string path;
  exchange::LoadedTrack track;
};

struct Session {
  world::Document document;
  world::Settings settings;
  world::Motion motion;
  sim::Derived derived;
  History history;
  std::vector<Notice> notices;  // the newest last, at most 32
  std::uint64_t notice_serial = 0;
  std::filesystem::path path;  // of the document; empty when it has none
  std::optional<ReadAhead> read_ahead;
  std::optional<exchange::ImportReport>
      import;                    // how well the document, as it was loaded, meets the file it was fitted to
  std::uint64_t saved_hash = 0;  // document hash when last loaded, saved or made
  mutable std::optional<std::uint64_t> document_hash;  // a memo for dirty(), which every frame asks; apply() forgets it
  std::uint64_t tick = 0;                              // ticks since the program's start
  mutable sim::GhostMemo
      ghosts;  // whole rides of the carts, simulated when something asks: a memo of what document and derived say
  mutable sim::RatingsMemo ratings;                  // of the ride that was asked about last
  mutable sim::RedSpans red;                         // the same
  mutable sim::Conflicts conflicts;                  // of the track with itself, looked for when something asks
  mutable sim::ElementMemo elements;                 // what the palette's element would be, planned when something asks
  mutable sim::ElementRoom element_room;             // where that would be in the way of track
  sim::Clock clock;                                  // to measure evaluation with
  std::string machine;                               // a line about it, for files of measurements
  sim::Measurement measurement;                      // of the evaluators; advanced by advance_measurement()
  sim::Envelope envelope = sim::default_envelope();  // what forces are held against; not a compliance check
  std::string envelope_name = "default";
  std::uint64_t envelope_serial = 0;  // grows with each envelope that is read
  RideCost ride_cost;
  Referee referee;
  std::optional<ActiveChallenge> challenge;
  RideRun run;                       // the ride on its way, for its end
  std::optional<RideResult> result;  // of the last ride that ended
  exchange::Progress earned;         // in challenges, since the program's start
  bool show_result = false;          // its score card is not closed yet
};

void notify(Session& session, NoticeKind kind, std::string text);
bool dirty(const Session& session);  // the document differs from its file

// Checks first, changes nothing on error. On success document, settings, motion, derived and history are consistent
// again (derive and reconcile have run). Numbers beyond the limits are clamped with a warning notice that contains the
// word "limit"; what cannot be done (unknown names, over the vertex budget, too short handles) is refused with
// Code::refused, file errors pass through, and either way an error notice is shown. A document command outside a
// gesture is one step of undo; a command that leaves the document equal adds none. undo inside a gesture cancels it.
base::Status apply(Session& session, base::Files& files, const Command& command);

// Does a part of a measurement that is under way, some ms; nothing else does: a frame without one costs nothing.
void advance_measurement(Session& session);

// The selected cart, else the first one by name; kNone without any: whose forces, colours, advice and report are told.
world::Entity chosen_cart(const Session& session);
// The ghost of its ride; null without a ride.
const sim::Ghost* chosen_ride(const Session& session);

// Its ratings and its stretches beyond the envelope; none of either without a ride.
const sim::Ratings& chosen_ratings(const Session& session);
const std::vector<sim::RedSpan>& chosen_red_spans(const Session& session);

// Where the track is in its own way, and where `element`, placed at its open end, would be in the way of it or of
// itself.
const std::vector<sim::Conflict>& conflicts(const Session& session);
const std::vector<sim::Narrow>& narrow_parts(const Session& session, const world::Element& element);

// The report of a ghost on the present track, to read, and as comma-separated values by time.
std::string ride_report(const Session& session, const sim::Ghost& ghost);
std::string ride_csv(const Session& session, const sim::Ghost& ghost);

// "c1 rolled back at 123.4 m, -0.3 m/s"; empty while all is well.
std::string failure_text(const Session& session);

// Advances the ride by whole ticks. When it stops by itself, a notice says why.
void advance(Session& session, int ticks);

// A session on an empty document.
Session make_session(sim::Clock clock);

}  // namespace coaster::edit
