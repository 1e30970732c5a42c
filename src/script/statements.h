// Parsed scripts: statements as plain data. grammar.h parses them, runner.h runs them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "base/crash_guard.h"
#include "base/files.h"
#include "base/text.h"
#include "curve/evaluators.h"
#include "edit/commands/command.h"
#include "platform/events.h"
#include "query/condition.h"
#include "script/host.h"

namespace coaster::script {

// Frame rates of movies, in pictures a second. A picture shows a whole tick of 1/120 s, so rates divide 120.
inline constexpr std::array kMovieRates{10, 12, 15, 20, 24, 30, 40, 60, 120};
inline constexpr int kUsualMovieRate = 30;
inline constexpr std::string_view kMovieRateWords = "10, 12, 15, 20, 24, 30, 40, 60 or 120";
constexpr bool is_movie_rate(std::int64_t fps) {
  return std::find(kMovieRates.begin(), kMovieRates.end(), fps) != kMovieRates.end();
}

struct Statement;
using Block = std::vector<Statement>;

// Runs an edit::Command; the paths of load and save are as written.
struct RunCommand {
  edit::Command command;
};
// Sets only what the line names.
struct SetEnvironment {
  std::optional<int> width, height, samples;
  std::optional<std::uint64_t> seed;
  std::optional<float> scale, density;
  std::optional<base::Token> home;
};
struct Advance {
  std::int64_t count = 1;
  bool frames = false;  // or ticks, which are not drawn
};
struct Repeat {
  std::int64_t count = 1;
};
struct Gesture {};
struct Include {};

using query::Condition;

struct Expect {
  Condition condition;
};
// "wait CONDITION max N ticks|frames".
struct Wait {
  Condition condition;
  std::int64_t most = 7200;
  bool frames = false;
};
// "lesson TEXT [at WIDGET] until CONDITION ... end": the player does what the text says. Without a player, or on
// request, the body runs.
struct Lesson {
  std::string text;
  std::optional<base::Token> widget;
  Condition until;
};
// exists, or same as another file byte by byte.
struct ExpectFile {
  base::Token path;
  std::optional<base::Token> same_as;
  bool negated = false;
};
// The statement must fail. `out_of_range`: the reason why it cannot run, a number in it.
struct ExpectError {
  Block statement;
  std::string out_of_range;
  std::optional<std::string> contains;
};

struct UiAction {
  enum class Verb { click, doubleclick, hover, check, type, drag_by, drag_to, open, close, menu, scroll };
  Verb verb = Verb::click;
  base::Token path;
  std::string text;   // of type; the value of drag to
  double number = 0;  // px of drag by, notches of scroll
  bool on = true;     // of check
};

// Frames of events, one frame after the other.
struct Input {
  std::vector<platform::Events> steps;
  bool last_step_can_wait = false;  // a release: may join the next frame
};

struct AimAction {
  enum class Verb : std::uint8_t { click, doubleclick, hover, drag };
  Verb verb = Verb::click;
  platform::Modifiers modifiers;
  AimPoint target;
  std::string target_text;
  int target_column = 1;
  std::optional<glm::vec3> by;
  std::optional<AimPoint> to;
};

// Frames the whole track or the selection.
struct FitCamera {
  bool selection = false;
};

struct Snap {
  std::string name;
};
struct Shot {
  base::Token path;
};
// "sheet FILE [columns N] [half] PICTURE ...".
struct Sheet {
  base::Token path;
  int columns = 3;
  bool half = false;
  std::vector<base::Token> pictures;
};
struct Dump {
  std::string name;
};
// Prints texts and values, separated by blanks.
struct Log {
  struct Part {
    std::string text;  // if query is empty
    std::string query, argument;
    int column = 1;
  };
  std::vector<Part> parts;
};
// Records all ticks until StopMovie.
struct StartMovie {
  base::Token folder;
  int fps = kUsualMovieRate;
  bool gif = false;
};
struct StopMovie {};
struct InjectFault {
  base::IoOperation operation = base::IoOperation::open;
  int nth = 1;
};

// Ends the script as skipped if the driver cannot evaluate in that stage.
struct RequireStage {
  curve::EvaluatedBy stage = curve::EvaluatedBy::processor;
};

// Delays the next import of the user by a number of frames, so that a script sees its progress.
struct SlowImport {
  int frames = 0;
};

using Action = std::variant<RunCommand, SetEnvironment, Advance, Repeat, Gesture, Lesson, Include, Expect, Wait,
                            ExpectFile, ExpectError, UiAction, Input, AimAction, FitCamera, Snap, Shot, Sheet, Dump,
                            Log, StartMovie, StopMovie, RequireStage, InjectFault, base::PlannedCrash, SlowImport>;

struct Statement {
  int source = 0;  // index into Script::sources
  int line = 1, column = 1;
  Action action;
  Block body;  // of a block, up to its "end", or of an include
};

struct Source {
  std::string name;  // as written in the including line
  std::filesystem::path folder;
  std::vector<std::string> lines;
  int from = -1, from_line = 0;  // index and line of the source that includes it; -1: none
};

struct Script {
  std::vector<Source> sources;  // the script, then its includes
  Block statements;
};

}  // namespace coaster::script
