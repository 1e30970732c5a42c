// The state of one running program: document, settings, motion, derived, history and notices. Only apply()
// (edit/perform/apply.h) changes it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "base/status.h"
#include "edit/commands/command.h"
#include "edit/session/findings.h"
#include "exchange/challenge_file.h"
#include "exchange/own/challenge_progress_file.h"
#include "exchange/own/track_file.h"
#include "sim/ride/ride.h"
#include "sim/shape/derived_track.h"
#include "sim/shape/shape_distance.h"
#include "sim/study/evaluator_benchmark.h"
#include "sim/study/force_limits.h"
#include "sim/study/ratings.h"
#include "world/document_difference.h"

namespace coaster::edit {

struct Session;

// --- A challenge in progress, the end of a ride, and the verdict on both. Rules are evaluated above this room: the
// referee is passed in as functions (query/challenge_rules.h)

// The result of judging a challenge.
struct ChallengeVerdict {
  int medal = 0;                // 0 not passed, 1 bronze, 2 silver, 3 gold
  std::string reason;           // why it failed: "Lateral: you have 1.40 g at 87.0 m; you need ..."; empty if it passed
  std::optional<double> place;  // m along the track, where it failed
  std::vector<exchange::BestValue> values;  // values that its rules compare
};

struct ActiveChallenge {
  exchange::ChallengeFile file;
  std::string path;          // the challenge's file
  int hints = 0;             // number of hints shown
  int medal = 0;             // the best since it was started
  std::uint64_t judged = 0;  // number of judgements
  ChallengeVerdict last;
  sim::ShapeTrace shape;  // of the start track
};

// How far a session is from a goal such as "ride.lap_time == 40 +-0.1".
struct GoalState {
  double found = 0, wanted = 0, tolerance = 0;  // in the query's unit; tolerance > 0
  bool met = false;
  std::string name, unit;  // "Lap time", "s"
};

// Evaluates expressions for the session. If all are null, challenges are loaded unchecked and never judged, and seek is
// unavailable.
struct ExpressionEvaluator {
  // Checks that every expression can be parsed; else Code::bad_file with "PATH: error: goals[1].expect: ...".
  base::Status (*check)(const exchange::ChallengeFile& challenge, const std::string& path) = nullptr;
  // Judges the session's challenge, which must exist, on the present session; only findings change. `result`: how the
  // ride ended, null for JudgedWhen::build.
  ChallengeVerdict (*judge)(Session& session, const struct RideResult* result) = nullptr;
  // Measures a goal. Code::usage if it cannot be parsed, Code::refused if its query has no value.
  base::Result<GoalState> (*measure)(Session& session, const std::string& goal) = nullptr;
};

enum class RideEnd : std::uint8_t { lap, open_end, time, failed };
inline constexpr base::NameRow kRideEnds[] = {{"lap", "Lap completed"},
                                              {"open end", "End of the track reached"},
                                              {"time", "Time limit reached"},
                                              {"failed", "Ride failed"}};
constexpr std::span<const base::NameRow> rows_of(RideEnd) { return kRideEnds; }

// The end of a ride, for the score card.
struct RideResult {
  RideEnd end = RideEnd::lap;
  std::string reason;           // reason of a failure: "stalled at 132.4 m, 2.1 m below the top at 141.0 m, ..."
  std::optional<double> place;  // m along the track, where it failed
  bool below_top = false;       // it stopped on the way up: a lift there would take it over the top
  bool whole = true;            // the train ran from its start on this track, and `ratings` are of this ride
  sim::Ratings ratings;
  double seconds = 0;                       // from the start to the end of the ride
  std::optional<ChallengeVerdict> verdict;  // of the challenge, if there was one
  std::uint64_t serial = 0;                 // number of the result
};

// A ride in progress.
struct RideInProgress {
  bool under_way = false;      // running, and its end not yet reported
  bool whole = false;          // from the start, and not moved by hand since
  std::uint64_t document = 0;  // hash at the start
  std::uint64_t ticks = 0;
};

// --- The session

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

// --- Undo and redo stacks and gestures. These functions handle only documents: apply() updates the rest of the session

// Pushes the step from `before` to `after` on the undo stack and clears the redo stack; drops the oldest steps beyond
// the history's limit, but never this one.
void record(History& history, StepText text, world::Document before, const world::Document& after);
// Turn `document` into the one before the newest step or after the next one; return false if there is none.
bool undo(History& history, world::Document& document);
bool redo(History& history, world::Document& document);

void begin_gesture(History& history, const world::Document& document);
// Makes one step of everything that changed since begin_gesture(); none if nothing changed.
void end_gesture(History& history, const world::Document& document);
// Restores the document from begin_gesture().
void cancel_gesture(History& history, world::Document& document);

// Returns the memory of a step, bytes.
std::size_t bytes_of(const HistoryStep& step);

}  // namespace coaster::edit
