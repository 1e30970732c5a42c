// What one running program holds: document, settings, motion, derived, history and notices. Changed by apply()
// (edit/perform/apply.h) alone.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/files.h"
#include "edit/commands/command.h"
#include "edit/session/challenge.h"
#include "edit/session/findings.h"
#include "exchange/own/track_file.h"
#include "sim/ride/ride.h"
#include "sim/shape/derived.h"
#include "sim/study/envelope.h"
#include "sim/study/measure.h"
#include "world/difference.h"

namespace coaster::edit {

// What an undo step did.
struct StepText {
  std::string command, sentence;  // of a gesture: its last command
};

// One undo step.
struct HistoryStep {
  StepText text;
  world::Difference change;  // to the document before the step on the undo stack, to the one after it on the redo stack
};

inline constexpr std::size_t kMaxHistoryBytes = 256u << 20;
struct History {
  std::deque<HistoryStep> undo;  // oldest first; beyond `limit` the oldest are dropped
  std::vector<HistoryStep> redo;
  std::size_t bytes = 0, limit = kMaxHistoryBytes;  // of all steps
  std::size_t dropped = 0;                          // steps
  bool in_gesture = false;
  world::Document gesture_start;
  StepText gesture_text;
};

enum class NoticeKind : std::uint8_t { info, warning, error };
struct Notice {
  NoticeKind kind = NoticeKind::info;
  std::string text;
  std::uint64_t serial = 0;  // counts up; the panel fades old ones
};

// What the ticks of the live ride take; 0 without a clock and before the first tick.
struct RideCost {
  double ns_per_tick = 0;  // all trains together; exponential moving average (weight 0.1)
};

// A file that a thread has read in advance, for its next load.
struct ReadAhead {
  std::string path;
  exchange::LoadedTrack track;
};

// What a search (command seek) found: with these values the goal is met.
struct Sought {
  std::vector<double> values;  // of the numbers that the command names, in their order
  std::string note;            // "ride.lap_time is 40 s, from 43.2 s. ..."
};
// What a thread has found in advance, for the next search with that text.
struct SoughtAhead {
  std::string command;
  std::uint64_t edits = 0;  // Session::edits of the track that it searched
  Sought found;
};

struct Notices {
  std::vector<Notice> list;  // the newest last, at most 32
  std::uint64_t serial = 0;  // of the newest
  std::uint64_t before = 0;  // of the newest before the last command that gave any
};

// The document's file.
struct DocumentFile {
  std::filesystem::path path;             // empty when it has none
  std::uint64_t saved_hash = 0;           // of the document when last loaded, saved or made
  std::optional<std::uint64_t> content;   // hash of the file's bytes as this program last read or wrote them
  int version = exchange::kTrackVersion;  // of the format, as it was loaded
  std::optional<ReadAhead> read_ahead;
  std::optional<exchange::ImportReport> import;  // how well the document, as it was loaded, meets the file it was
                                                 // fitted to
};

// What forces are held against; not a compliance check.
struct ForceLimits {
  sim::Envelope envelope = sim::default_envelope();
  std::string name = "default";
  std::uint64_t serial = 0;  // increases with each envelope that is loaded
};

// Challenges and the ends of rides.
struct Game {
  Referee referee;
  std::optional<ActiveChallenge> challenge;
  RideRun run;                       // the ride in progress
  std::optional<RideResult> result;  // of the last ride that ended
  bool show_result = false;          // its score card is still open
  exchange::Progress earned;         // progress in challenges since the program's start
};

// What is measured on this machine; nobody's hash depends on it.
struct Measuring {
  sim::Clock clock;
  std::string machine;           // a line about it, for files of measurements
  sim::Measurement measurement;  // of the evaluators; advanced by advance_measurement()
  RideCost ride_cost;
};

struct Session {
  world::Document document;  // the user's, saved, undoable
  std::uint64_t edits = 0;   // grows with each command that may have changed it
  DocumentFile file;
  History history;
  world::Settings settings;
  ForceLimits limits;
  world::Motion motion;
  std::uint64_t tick = 0;  // ticks since the program's start
  sim::Derived derived;    // follows from document and settings
  Findings findings;       // follow from all of these
  Game game;
  Measuring measuring;
  Notices notices;
  std::optional<SoughtAhead> sought;
  std::string copied;  // what was copied last: sections as the text of a track, or keys of forces
  std::string shared;  // the link that was made last, without the address before its fragment
};

void notify(Session& session, NoticeKind kind, std::string text);
// Shows an error: a refusal as a sentence, others as they are, because a file's name comes first.
void notify(Session& session, const base::Status& error);
// True if the document has unsaved changes. An open gesture that moved anything counts as one: a hash at each of its
// moves would cost more than the moves.
bool dirty(const Finder& find);

// Returns the link of the track as it is seen: exchange::print_link() of document, camera and evaluator.
std::string link_of(const Session& session);

// True if the path leads to the document's own file, under any name.
bool is_own_file(const Session& session, const std::filesystem::path& path);
// Returns the hash of a file's bytes; nothing if it cannot be read.
std::optional<std::uint64_t> content_of(const std::filesystem::path& path);
// True if the document's own file is there with other contents than this program last read or wrote, or unreadable.
bool changed_outside(const Session& session);

// Runs the next slice of the measurement (a few ms); no-op when idle.
void advance_measurement(Session& session);

// Returns the selected cart, else the first one by name; kNone without any. Forces, colours, advice and report are for
// this train.
world::Entity chosen_cart(const Session& session);
// The report of the chosen cart's ride on the present track, to read, and as comma-separated values by time; nothing
// without a ride.
std::optional<std::string> ride_report(const Finder& find);
std::optional<std::string> ride_csv(const Finder& find);

// Returns "Train c1 rolled back at 123.4 m (-0.3 m/s)."; empty if the ride has not failed.
std::string failure_text(const Session& session);

// Advances the ride by whole ticks. If it stops, a notice says why.
void advance(Session& session, int ticks);

// Returns a session with an empty document.
Session make_session(sim::Clock clock);

}  // namespace coaster::edit
