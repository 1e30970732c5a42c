// The state of one running program: document, settings, motion, derived, history and notices. Only apply()
// (edit/perform/apply.h) changes it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "edit/commands/command.h"
#include "edit/session/challenge.h"
#include "edit/session/findings.h"
#include "exchange/own/track_file.h"
#include "sim/ride/ride.h"
#include "sim/shape/derived_track.h"
#include "sim/study/evaluator_benchmark.h"
#include "sim/study/force_limits.h"
#include "world/document_difference.h"

namespace coaster::edit {

// The command and the sentence of an undo step.
struct StepText {
  std::string command, sentence;  // for a gesture: its last command
};

// One undo step.
struct HistoryStep {
  StepText text;
  // On the undo stack: to the document before the step; on the redo stack: to the one after it.
  world::DocumentDifference change;
};

inline constexpr std::size_t kMaxHistoryBytes = 256u << 20;
struct History {
  std::deque<HistoryStep> undo;  // oldest first; beyond `limit` the oldest are dropped
  std::vector<HistoryStep> redo;
  std::size_t bytes = 0, limit = kMaxHistoryBytes;  // bytes of all steps, and their limit
  std::size_t dropped = 0;                          // number of dropped steps
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

// Cost of the live ride's ticks; 0 without a clock and before the first tick.
struct RideCost {
  double ns_per_tick = 0;  // all trains together; exponential moving average (weight 0.1)
};

struct Notices {
  std::vector<Notice> list;  // the newest last, at most 32
  std::uint64_t serial = 0;  // number of the newest
  std::size_t tight = 0;     // tight bends of the track that a notice told of
  std::uint64_t before = 0;  // number of the newest before the last command that gave any
};

// The file of the document.
struct DocumentFile {
  std::filesystem::path path;                    // empty if there is none
  std::uint64_t saved_hash = 0;                  // hash of the document when last loaded, saved or created
  std::optional<std::uint64_t> content;          // hash of the file's bytes as this program last read or wrote them
  int version = 3;                               // of the format that was loaded or saved last
  std::optional<exchange::ImportReport> import;  // how closely the document, as it was loaded, fits the imported file
};

// The force limits that rides are checked against; not a compliance check.
struct ForceLimits {
  std::optional<sim::ForceLimitCurves> loaded;  // none: the default ones of the coaster's kind
  std::string name = "default";
  std::uint64_t serial = 0;  // increases with each loaded envelope
};

// Challenges and the ends of rides.
struct ChallengeState {
  ExpressionEvaluator referee;
  std::optional<ActiveChallenge> challenge;
  RideInProgress run;                // the ride in progress
  std::optional<RideResult> result;  // of the last ride that ended
  bool show_result = false;          // its score card is still open
  exchange::PlayerProgress earned;   // progress in challenges since the program's start
};

// Measurements on this machine; no hash depends on them.
struct MeasurementState {
  sim::Clock clock;
  std::string machine;           // description of the machine, for files of measurements
  sim::Measurement measurement;  // of the evaluators; advanced by advance_measurement()
  RideCost ride_cost;
};

// Segments evaluated since a frame counted them, by all derivations.
struct EvaluationWork {
  int rebuilds = 0;
  double seconds = 0;  // in the evaluators
  std::int64_t vertices = 0;
};

struct Session {
  world::Document document;  // the user's track: saved, undoable
  std::uint64_t edits = 0;   // increases with each command that may have changed it
  DocumentFile file;
  History history;
  world::Settings settings;
  ForceLimits limits;
  world::Motion motion;
  std::uint64_t tick = 0;     // ticks since the program's start
  sim::DerivedTrack derived;  // derived from document and settings
  EvaluationWork evaluated;
  world::HeapValue<FindingsCache> findings;  // found from all of these by SessionFindings
  ChallengeState game;
  MeasurementState measuring;
  Notices notices;
  std::string copied;  // copied last: sections as the text of a track, or force keys
  std::string shared;  // the last link, without the address before its fragment
};

void notify(Session& session, NoticeKind kind, std::string text);
// Shows an error: a refusal as a sentence, other errors unchanged, because they begin with a file name.
void notify(Session& session, const base::Status& error);
// True if the document has unsaved changes. An open gesture that moved anything counts as one: a hash at each of its
// moves would cost more than the moves.
bool dirty(const SessionFindings& find);

// Returns a link to the track with its present view: exchange::print_link() of document, camera and evaluator.
std::string link_of(const Session& session);

// True if the path, under any name, is the document's own file.
bool is_own_file(const Session& session, const std::filesystem::path& path);
// Returns the hash of a file's bytes; nothing if it cannot be read.
std::optional<std::uint64_t> content_of(const std::filesystem::path& path);
// True if the document's own file exists and is unreadable or differs from what this program last read or wrote.
bool changed_outside(const Session& session);

// Runs the next slice of the measurement (a few ms); no-op when idle.
void advance_measurement(Session& session);

// Returns the selected cart, else the first one by name; kNone without any. Forces, colours, advice and report use this
// train.
world::Entity chosen_cart(const Session& session);

// Returns the force limits in use.
const sim::ForceLimitCurves& force_limits(const Session& session);
// Returns "Train c1 stalled at 132.4 m, 2.1 m below the top at 141.0 m: ...", as the score card says it; empty if the
// ride has not failed.
std::string failure_text(const Session& session);

// True if the session's challenge refuses commands of that name.
bool is_locked(const Session& session, std::string_view command);
// Returns "Locked in this challenge: Equipment, Losses.": the commands by the labels of their buttons, each once.
std::string locked_text(const std::vector<std::string>& commands);

// Says so if there are too many trains for the block sections (sim::deadlock_text()).
void warn_of_deadlock(Session& session);

// Advances the ride by whole ticks. If it stops, a notice says why.
void advance(Session& session, int ticks);

// Returns a session with an empty document.
Session make_session(sim::Clock clock);

}  // namespace coaster::edit
