// Runs a parsed script against a Host, up to its last statement or the first that fails.
#pragma once

#include <filesystem>
#include <string>

#include "script/frame_driver.h"
#include "script/host.h"
#include "script/statements.h"

namespace coaster::script {

struct RunOptions {
  std::filesystem::path out;  // the folder that $OUT means
  bool update_goldens = false;
  Environment environment;  // in effect before the first env line
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

// Runs the script. On failure returns the exit code's reason with place, line, caret, frame and the paths of picture
// and state (describe_error()).
base::Status run_script(const Script& script, Host& host, const RunOptions& options);

// One run. The statements are implemented in runner.cpp (blocks, commands, time, input), runner_expect.cpp,
// runner_lesson.cpp, runner_aim.cpp, ui_driver.cpp and runner_output.cpp.
class Runner {
 public:
  Runner(const Script& script, Host& host, const RunOptions& options)
      : script_(script), frames_(host), options_(options), environment_(options.environment) {}

  base::Status run();

 private:
  Failure run(const Block& block);
  Failure run(const Statement& statement);

  Failure perform(const RunCommand& command);
  Failure perform(const SetEnvironment& change);
  Failure perform(const Frames& frames);
  Failure perform(const Ticks& ticks);
  Failure perform(const Repeat& repeat);
  Failure perform(const Gesture& gesture);
  Failure perform(const Include& include);
  Failure perform(const Lesson& lesson);  // runner_lesson.cpp
  Failure perform(const Input& input);
  Failure perform(const MoveCamera& move);
  Failure perform(const FitCamera& fit);
  Failure perform(const Fault& fault);
  Failure perform(const SlowImport& slow);

  Failure perform(const Expect& expect);
  Failure perform(const Wait& wait);
  Failure perform(const ExpectWidget& expect);
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

  // Evaluates the condition; `found` receives the value as text.
  base::Result<bool> check(const Condition& condition, std::string& found);
  const Source& source() const { return script_.sources[static_cast<std::size_t>(source_)]; }
  std::filesystem::path input(std::string_view written) const;
  // Returns the file to write for a path below $OUT, with or without "$OUT/".
  base::Result<std::filesystem::path> below_out(std::string_view written) const;
  // Writes picture, widgets and values to $OUT; returns a note for the message.
  std::string write_evidence();

  const Script& script_;
  FrameDriver frames_;
  const RunOptions& options_;
  base::Files files_;  // writes below $OUT alone, without the faults that scripts inject into the host's
  Environment environment_;
  int lessons_ = 0;                           // started so far
  bool left_ = false;                         // the player has left the lessons
  std::vector<std::filesystem::path> homes_;  // named by env
  int source_ = 0;                            // source of the running statement
  const Statement* failed_at_ = nullptr;      // the innermost statement that failed
};

}  // namespace coaster::script
