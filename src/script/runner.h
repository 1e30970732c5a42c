// Runs a parsed script against a Host, up to its last statement or the first that fails: all at once, or step by step,
// so that a player can do its lessons between the steps.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/root.h"
#include "script/frame_driver.h"
#include "script/grammar.h"
#include "script/host.h"
#include "script/statements.h"

namespace coaster::script {

struct RunOptions {
  base::Root out;  // limited to the folder that $OUT means
  bool update_goldens = false;
  Environment environment;       // in effect before the first env line
  ScriptError* error = nullptr;  // receives the error of a script that fails
};

// A failed statement's error; column 0: the column of the statement.
struct Failure {
  base::Code code = base::Code::ok;
  std::string message;
  int column = 0;

  bool ok() const { return code == base::Code::ok; }
  explicit operator bool() const { return ok(); }
};
inline Failure failure(const base::Status& status, int column = 0) { return {status.code, status.message, column}; }
inline Failure failed(std::string message, int column = 0) {
  return {base::Code::expectation, std::move(message), column};
}
inline Failure wrong(std::string message, int column = 0) { return {base::Code::usage, std::move(message), column}; }

// Runs the script. On failure returns its code with place, line, caret, frame and the paths of picture and state
// (describe_error()).
base::Status run_script(const Script& script, Host& host, const RunOptions& options);

// One run: begin(), then step() until it returns a status. The statements are implemented in runner.cpp (blocks,
// commands, time, input), runner_expect.cpp, runner_lesson.cpp, runner_aim.cpp, ui_driver.cpp and runner_output.cpp.
class Runner {
 public:
  Runner(const Script& script, Host& host, const RunOptions& options)
      : script_(script), frames_(host), options_(options), files_(options.out), environment_(options.environment) {}

  base::Status begin();
  // Runs the next statement, or checks whether the waiting lesson is done. Returns nothing while more is to come, then
  // the result of the script.
  std::optional<base::Status> step();
  // True if the last step left a lesson to the player.
  bool waits() const { return waits_; }

 private:
  // The position of the run in a block, and in the blocks around it.
  struct Place {
    const Block* block = nullptr;
    std::size_t next = 0;
    std::int64_t again = 0;  // remaining repetitions of the block after this one
    bool gesture = false;    // the block is a gesture
  };
  // The current lesson; a place behind `depth` shows its lines.
  struct Given {
    const Lesson* lesson = nullptr;
    const Statement* statement = nullptr;
    std::size_t depth = 0;
    int waited = 0;  // frames, without a player
  };
  void enter(const Block& block, std::int64_t again = 0, bool gesture = false) {
    places_.push_back({&block, 0, again, gesture});
  }
  Failure advance();
  Failure run(const Statement& statement);
  Failure attend();  // checks the current lesson (runner_lesson.cpp)
  base::Status error_of(const Failure& result);

  Failure perform(const RunCommand& command);
  Failure perform(const SetEnvironment& change);
  Failure perform(const Frames& frames);
  Failure perform(const Ticks& ticks);
  Failure perform(const Repeat& repeat);
  Failure perform(const Gesture& gesture);
  Failure perform(const Include& include);
  Failure perform(const Lesson& lesson);  // runner_lesson.cpp
  Failure perform(const Input& input);
  Failure perform(const FitCamera& fit);
  Failure perform(const Needs& needs);
  Failure perform(const Fault& fault);
  Failure perform(const PlanCrash& crash);
  Failure perform(const SlowImport& slow);

  Failure perform(const Expect& expect);
  Failure perform(const Wait& wait);
  Failure perform(const ExpectFile& expect);
  Failure perform(const ExpectError& expect);

  Failure perform(const UiAction& ui);
  Failure perform(const AimAction& aim);

  Failure perform(const Snap& snap);
  Failure perform(const Shot& shot);
  Failure perform(const Sheet& sheet);
  Failure perform(const Dump& dump);
  Failure perform(const Log& log);
  Failure perform(const StartMovie& start);
  Failure perform(const StopMovie& stop);

  base::Result<query::Value> value_of(std::string_view query, const std::string& argument);
  // Evaluates the condition; `found` receives the value as text.
  base::Result<bool> check(const Condition& condition, std::string& found);
  // Returns why the value of a condition of the ride cannot change by waiting; empty if it can.
  std::string stands_still(const Condition& condition) const;
  const Source& source() const { return script_.sources[static_cast<std::size_t>(source_)]; }
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
  std::vector<Place> places_;              // the innermost last
  std::set<std::filesystem::path> snaps_;  // golden pictures compared so far
  std::optional<Given> given_;
  bool waits_ = false;
  int lessons_ = 0;                           // lessons started so far
  std::vector<std::filesystem::path> homes_;  // folders named by env
  int source_ = 0;                            // source of the running statement
  const Statement* failed_at_ = nullptr;      // the innermost statement that failed
};

}  // namespace coaster::script
