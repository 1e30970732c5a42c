// The table of statements and the readers of their words; those of ui.*, aim.* and expect are in separate files.
#include "script/lines.h"

#include <algorithm>
#include <limits>
#include <type_traits>

#include <fmt/format.h>

#include "base/names.h"
#include "edit/commands/codec.h"
#include "edit/commands/set_setting.h"
#include "edit/perform/seek.h"
#include "query/condition.h"
#include "query/goal.h"
#include "script/grammar.h"

namespace coaster::script {
namespace {

constexpr std::int64_t kMostFrames = 10'000'000;

std::optional<float> number_within(Words& words, std::string_view what, double low, double high) {
  const auto number = words.number(what);
  if (!number) return std::nullopt;
  if (*number >= low && *number <= high) return static_cast<float>(*number);
  words.reject_number(what);
  return std::nullopt;
}

bool parse_env(Words& words, Action& action) {
  static const std::vector<std::string> kNames{"size", "seed", "scale", "msaa", "home", "density"};
  SetEnvironment env;
  if (words.at_end()) return words.fail(words.end_column(), "expected size, seed, scale, density, msaa or home");
  while (!words.at_end()) {
    const auto name = words.one_of("size, seed, scale, density, msaa or home", kNames);
    if (!name) return false;
    if (*name == 0) {
      const base::Token* const size = words.take("WIDTHxHEIGHT");
      if (!size) return false;
      int width = 0, height = 0;
      if (!base::parse_size(size->text, width, height)) return words.fail(base::size_error(size->column, size->text));
      env.width = width, env.height = height;
    } else if (*name == 1) {
      const auto seed = words.whole("a seed", 0, std::numeric_limits<std::int64_t>::max());
      if (!seed) return false;
      env.seed = static_cast<std::uint64_t>(*seed);
    } else if (*name == 2) {
      env.scale = number_within(words, "a scale from 0.75 to 3", 0.75, 3);
      if (!env.scale) return false;
    } else if (*name == 5) {
      env.density = number_within(words, "a density from 0.5 to 4", 0.5, 4);
      if (!env.density) return false;
    } else if (*name == 4) {
      if (!take(words, "a folder below $OUT", env.home.emplace())) return false;
    } else {
      const auto samples = words.whole("a number of samples", 0, 64);
      if (!samples) return false;
      env.samples = static_cast<int>(*samples);
    }
  }
  action = env;
  return true;
}

// Reads Frames or Ticks; 1 without a number.
template <class Count>
bool parse_count(Words& words, Action& action) {
  constexpr std::string_view kWhat = std::is_same_v<Count, Frames> ? "a number of frames" : "a number of ticks";
  const auto count = words.at_end() ? std::optional<std::int64_t>(1) : words.whole(kWhat, 0, kMostFrames);
  if (count) action = Count{*count};
  return count && words.end();
}

bool parse_wait(Words& words, Action& action) {
  Wait wait;
  if (const base::Token* const first = words.peek();
      first && (base::is_number(first->text) || first->text.find_first_of("0123456789") == 0))
    return words.fail(first->column, fmt::format("expected a query such as ride.lap, found {}; ticks N or frames N "
                                                 "advances time without a condition",
                                                 base::quoted_start(first->text)));
  if (!parse_condition(words, wait.condition, "max")) return false;
  if (words.accept("max")) {
    static const std::vector<std::string> kUnits{"ticks", "frames", "tick", "frame", "s", "seconds"};
    const auto most = words.whole("a number of ticks, frames or seconds", 0, kMostFrames);
    if (!most) return false;
    wait.most = *most;
    if (!words.at_end()) {
      const auto unit = words.one_of("ticks, frames or seconds", kUnits);
      if (!unit) return false;
      wait.frames = *unit == 1 || *unit == 3;
      if (*unit >= 4) wait.most *= world::kTicksPerSecond;
    }
  }
  action = wait;
  return words.end();
}

// Reads one word of an enumeration.
template <class E>
std::optional<E> named_word(Words& words, const char* expected) {
  const auto name = words.one_of(expected, base::names_of<E>());
  return name ? std::optional(static_cast<E>(*name)) : std::nullopt;
}

bool parse_needs(Words& words, Action& action) {
  const auto stage = named_word<curve::EvaluatedBy>(words, "what evaluates, such as geometry_shader");
  if (stage) action = Needs{*stage};
  return stage && words.end();
}

bool parse_crash(Words& words, Action& action) {
  const auto place = named_word<base::CrashPlace>(words, "where to crash, such as drawing");
  if (!place) return false;
  const auto way = words.at_end() ? base::CrashWay::access : named_word<base::CrashWay>(words, "how to crash");
  if (!way) return false;
  action = PlanCrash{{*place, *way}};
  return words.end();
}

bool parse_fault(Words& words, Action& action) {
  static const std::vector<std::string> kOperations = [] {
    std::vector<std::string> names;
    for (const std::string_view name : base::kIoOperationNames) names.push_back(fmt::format("io.{}", name));
    names.insert(names.end(), {"import", "crash"});
    return names;
  }();
  const auto operation = words.one_of("an operation such as io.fsync, import or crash", kOperations);
  if (!operation) return false;
  if (kOperations[static_cast<std::size_t>(*operation)] == "crash") return parse_crash(words, action);
  if (kOperations[static_cast<std::size_t>(*operation)] == "import") {
    if (!words.accept("slow")) return words.fail(next_column(words), "expected \"slow\"");
    const auto frames = words.whole("a number of frames", 1, 10'000);
    if (!frames) return false;
    action = SlowImport{static_cast<int>(*frames)};
    return words.end();
  }
  if (!words.accept("fail")) return words.fail(next_column(words), "expected \"fail\"");
  const auto nth =
      words.at_end() ? std::optional<std::int64_t>(1) : words.whole("the number of the call that fails", 1, 1'000'000);
  if (!nth) return false;
  action = Fault{static_cast<base::IoOperation>(*operation), static_cast<int>(*nth)};
  return words.end();
}

bool parse_camera(Words& words, Action& action) {
  static const std::vector<std::string> kNames{"all", "fit",    "selection", "orbit", "ride",    "chase",
                                               "fly", "target", "yaw",       "pitch", "distance"};
  const std::span<const base::Token> rest = words.rest();
  const auto name = words.one_of("target, yaw, pitch, distance, all, selection, orbit, ride, chase or fly", kNames);
  if (!name) return false;
  if (*name >= 7) {
    return parse_command("camera", rest, words, action);
  }
  if (*name >= 3)
    action = RunCommand{edit::Set<&world::Settings::camera_mode>{static_cast<world::CameraMode>(*name - 3)}};
  else action = FitCamera{*name == 2};
  return words.end();
}

constexpr LineRow kSessionLines[]{
    {"env", parse_env},     {"frames", parse_count<Frames>}, {"ticks", parse_count<Ticks>}, {"wait", parse_wait},
    {"needs", parse_needs}, {"fault", parse_fault},          {"camera", parse_camera}};

// Calls visit(row) for each row of all tables.
template <class Visit>
void for_each_line(Visit visit) {
  for (const std::span<const LineRow> part : {std::span<const LineRow>(kSessionLines), expect_lines(), output_lines(),
                                              input_lines(), ui_lines(), aim_lines()})
    for (const LineRow& row : part) visit(row);
}

}  // namespace

bool parse_command(std::string_view name, std::span<const base::Token> rest, Words& words, Action& action) {
  std::vector<base::Token> line{{std::string(name), 1, false}};
  line.insert(line.end(), rest.begin(), rest.end());
  base::TextError error;
  const auto command = edit::parse(line, error);
  if (!command) return words.fail(error);
  action = RunCommand{*command};
  return true;
}

std::vector<std::string> line_words() {
  std::vector<std::string> words;
  for_each_line([&](const LineRow& row) { words.emplace_back(row.word); });
  for (const edit::CommandHelp& row : edit::command_table())
    if (std::find(words.begin(), words.end(), row.info.name) == words.end()) words.emplace_back(row.info.name);
  return words;
}

namespace {

// Checks what a search aims for and changes, so that errors have their place and are found before the script runs.
bool check_seek(std::span<const base::Token> line, const edit::Command& command, base::TextError& error) {
  const auto by =
      std::find_if(line.begin(), line.end(), [](const base::Token& t) { return t.text == "by" && !t.quoted; });
  Words goal(line.subspan(1, static_cast<std::size_t>(by - line.begin()) - 1), error);
  if (!query::check_goal(goal)) return false;
  const auto wrong = edit::wrong_by(*command.as<edit::Seek>());
  if (wrong) error = {(by + 1)->column, *wrong};
  return !wrong;
}

}  // namespace

bool parse_line(std::span<const base::Token> line, base::TextError& error, Action& action) {
  const base::Token& first = line.front();
  const LineRow* found = nullptr;
  for_each_line([&](const LineRow& row) {
    if (row.word == first.text && !first.quoted) found = &row;
  });
  if (found) {
    Words words(line, error);
    words.take("a statement");
    return found->parse(words, action) && !words.failed();
  }
  if (!edit::is_command(first.text)) {
    const std::vector<std::string>& known = statement_words();
    const bool spans_lines = std::find(known.begin(), known.end(), first.text) != known.end();
    error = {first.column,
             spans_lines ? fmt::format("expected a statement of one line, found {}", base::quoted_start(first.text))
                         : fmt::format("no command {}{}", base::quoted_start(first.text), near_words(line))};
    return false;
  }
  auto command = edit::parse(line, error);
  if (!command || (command->is<edit::Seek>() && !check_seek(line, *command, error))) return false;
  action = RunCommand{*command};
  return true;
}

}  // namespace coaster::script
