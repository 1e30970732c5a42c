// Runs a parsed script against a Host, up to its last statement or the first that fails: all at once, or step by step,
// so that a player can do its lessons between the steps.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/files.h"
#include "script/grammar.h"
#include "script/host.h"
#include "script/statements.h"
#include "script/ui_driver.h"

namespace coaster::script {

struct RunOptions {
  base::FileRoot out;  // limited to the folder that $OUT means
  bool update_goldens = false;
  Environment environment;       // in effect before the first env line
  ScriptError* error = nullptr;  // receives the error of a script that fails
};

// Runs the script. On failure returns its code with place, line, caret, frame and the paths of picture and state
// (describe_error()).
Status run_script(const Script& script, Host& host, const RunOptions& options);

// One run: begin(), then step() until it returns a status. The statements are implemented in runner.cpp (blocks,
// commands, time, input, checks, lessons) and runner_output.cpp (files).
class Runner {
 public:
  Runner(const Script& script, Host& host, const RunOptions& options)
      : script_(script), frames_(host), options_(options), files_(options.out), environment_(options.environment) {}

  Status begin();
  // Runs the next statement, or checks whether the waiting lesson is done. Returns nothing while more is to come, then
  // the result of the script.
  std::optional<Status> step();
  // True if the last step left a lesson to the player.
  bool waits() const { return waits_; }

 private:
  // The position of the run in a block, and in the blocks around it.
  struct BlockPosition {
    const Block* block = nullptr;
    std::size_t next = 0;
    std::int64_t again = 0;  // remaining repetitions of the block after this one
    bool gesture = false;    // the block is a gesture
  };
  // The current lesson; a place behind `depth` shows its lines.
  struct ActiveLesson {
    const Statement* lesson = nullptr;
    std::size_t depth = 0;
    int waited = 0;  // frames, without a player
  };
  void enter(const Block& block, std::int64_t again = 0, bool gesture = false) {
    places_.push_back({&block, 0, again, gesture});
  }
  Status advance();
  Status run(const Statement& statement);
  Status attend();  // checks the current lesson
  Status error_of(const Status& result);
  // Returns the status. If it is an error, the script's error points at this column instead of its statement's.
  Status at(int column, Status status) {
    if (!status) column_ = column;
    return status;
  }

  Status perform(const RunCommand& command);
  Status perform(const SetEnvironment& change);
  Status perform(const Advance& advance);
  Status perform(const Repeat& repeat);
  Status perform(const Gesture& gesture);
  Status perform(const Include& include);
  Status perform(const Lesson& lesson);
  Status perform(const Input& input);
  Status perform(const FitCamera& fit);
  Status perform(const RequireStage& needs);
  Status perform(const InjectFault& fault);
  Status perform(const base::PlannedCrash& crash);
  Status perform(const SlowImport& slow);

  Status perform(const Expect& expect);
  Status perform(const Wait& wait);
  Status perform(const ExpectFile& expect);
  Status perform(const ExpectError& expect);

  Status perform(const UiAction& ui);
  Status perform(const AimAction& aim);

  Status perform(const Snap& snap);
  Status perform(const Shot& shot);
  Status perform(const Sheet& sheet);
  Status perform(const Dump& dump);
  Status perform(const Log& log);
  Status perform(const StartMovie& start);
  Status perform(const StopMovie& stop);

  base::Result<query::Value> value_of(std::string_view query, const std::string& argument);
  // Evaluates the condition; `found` receives the value as text.
  base::Result<bool> check(const Condition& condition, std::string& found);
  // Returns why the value of a condition of the ride cannot change by waiting; empty if it can.
  std::string stands_still(const Condition& condition) const;
  const Source& source() const { return script_.sources[static_cast<std::size_t>(running_->source)]; }
  std::filesystem::path input(std::string_view written) const;
  // Reports the notices after that number: without panels nobody sees the warnings of a file.
  void report_since(std::uint64_t serial);
  // Returns the file to write for a path below $OUT, with or without "$OUT/".
  base::Result<std::filesystem::path> below_out(std::string_view written) const;
  // Returns the passes of repeats and the includes that led to the running statement.
  std::vector<Origin> origins() const;
  // Writes picture, widgets, and values with the error to $OUT; returns a note for the message.
  std::string write_evidence(const ScriptError& error);

  const Script& script_;
  FrameDriver frames_;
  const RunOptions& options_;
  base::Files files_;  // writes only below $OUT, without the faults that scripts inject into the host's
  Environment environment_;
  std::vector<BlockPosition> places_;      // the innermost last
  std::set<std::filesystem::path> snaps_;  // golden pictures compared so far
  std::optional<ActiveLesson> given_;
  bool waits_ = false;
  int lessons_ = 0;                           // lessons started so far
  std::vector<std::filesystem::path> homes_;  // folders named by env
  const Statement* running_ = nullptr;        // the statement whose errors come now
  int column_ = 0;                            // of the error, set by at(); 0: the column of the statement
};

}  // namespace coaster::script
