// The rows of time, blocks, the camera, checks and output, and their readers; statement_rows_input.cpp has those of
// input.
#include "script/statement_rows.h"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>

#include "base/exit_codes.h"
#include "edit/commands/codec.h"
#include "edit/commands/set_setting.h"
#include "edit/perform/seek.h"
#include "query/condition.h"
#include "query/query.h"
#include "script/grammar.h"

namespace coaster::script {
namespace {

constexpr std::int64_t kMostFrames = 10'000'000;

// A word and its row. A word of several forms has one for each, the first of which reads it.
struct NamedRow {
  std::string word;
  const StatementRow* row;
  std::size_t which;  // its place in the row's words
};
const std::vector<NamedRow>& named_rows() {
  static const std::vector<NamedRow> kRows = [] {
    std::vector<NamedRow> rows;
    for (const RowGroup& group : row_groups())
      for (const StatementRow& row : group.rows) {
        const std::vector<std::string> words = words_of(row);
        for (std::size_t i = 0; i < words.size(); ++i) rows.push_back({words[i], &row, i});
      }
    return rows;
  }();
  return kRows;
}
const NamedRow* find_named(std::string_view word) {
  const auto& rows = named_rows();
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const NamedRow& row) { return row.word == word; });
  return found != rows.end() ? &*found : nullptr;
}

// True for words that are no statement of one line.
bool spans_lines(std::string_view word) {
  const NamedRow* const found = find_named(word);
  return word == "end" || (found && !found->row->read) || opens_block(word);
}

bool read_environment(WordReader& words, SetEnvironment& env) {
  static const std::vector<std::string> kNames{"size", "seed", "scale", "density", "msaa", "home"};
  if (words.at_end()) return words.fail(words.end_column(), "expected " + base::alternatives(kNames));
  const auto part = [&](std::size_t name) {
    switch (name) {
      case 0: {
        const base::Token* const size = words.take("WIDTHxHEIGHT");
        return size && (base::parse_size(size->text, env.width.emplace(), env.height.emplace()) ||
                        words.fail(base::size_error(size->column, size->text)));
      }
      case 1: return whole(words, "a seed", 0, std::numeric_limits<std::int64_t>::max(), env.seed.emplace());
      case 2: return number_within(words, "a scale from 0.75 to 3", 0.75, 3, env.scale.emplace());
      case 3: return number_within(words, "a density from 0.5 to 4", 0.5, 4, env.density.emplace());
      case 4: return whole(words, "a number of samples", 0, 64, env.samples.emplace());
      default: return take(words, "a folder below $OUT", env.home.emplace());
    }
  };
  while (!words.at_end()) {
    const auto name = choice(words, kNames);
    if (!name || !part(*name)) return false;
  }
  return true;
}

bool read_repeat(WordReader& words, Repeat& repeat) { return whole(words, "a count", 0, 1'000'000, repeat.count); }

bool read_gesture(WordReader&, Gesture&) { return true; }

bool read_lesson(WordReader& words, Lesson& lesson) {
  if (!take(words, "a text", lesson.text)) return false;
  if (words.accept("at") && !take(words, "a widget's path", lesson.widget.emplace())) return false;
  if (!words.accept("until")) return words.fail(next_column(words), "expected at or until");
  return parse_condition(words, lesson.until);
}

bool read_frames(WordReader& words, Advance& advance) {
  advance.frames = true;
  return words.at_end() || whole(words, "a number of frames", 0, kMostFrames, advance.count);
}

bool read_ticks(WordReader& words, Advance& advance) {
  return words.at_end() || whole(words, "a number of ticks", 0, kMostFrames, advance.count);
}

bool read_wait(WordReader& words, Wait& wait) {
  static const std::vector<std::string> kUnits{"ticks", "frames", "tick", "frame", "s", "seconds"};
  if (const base::Token* const first = words.peek();
      first && (base::is_number(first->text) || first->text.find_first_of("0123456789") == 0))
    return words.fail(first->column, fmt::format("expected a query such as ride.lap, found {}; ticks N or frames N "
                                                 "advances time without a condition",
                                                 base::quoted_start(first->text)));
  if (!parse_condition(words, wait.condition, "max")) return false;
  if (!words.accept("max")) return true;
  if (!whole(words, "a number of ticks, frames or seconds", 0, kMostFrames, wait.most)) return false;
  if (words.at_end()) return true;
  const auto unit = words.one_of("ticks, frames or seconds", kUnits);
  if (!unit) return false;
  wait.frames = *unit == 1 || *unit == 3;
  if (*unit >= 4) wait.most *= world::kTicksPerSecond;
  return true;
}

// Reads the name of a camera or what to frame; other words are those of the command.
bool read_camera(WordReader& words, std::size_t, Action& action) {
  static const std::vector<std::string> kNames{"all", "fit",    "selection", "orbit", "ride",    "chase",
                                               "fly", "target", "yaw",       "pitch", "distance"};
  const std::span<const base::Token> rest = words.rest();
  const auto name = words.one_of("target, yaw, pitch, distance, all, selection, orbit, ride, chase or fly", kNames);
  if (!name) return false;
  if (*name >= 7) return read_command("camera", rest, words, action);
  if (*name < 3) action = FitCamera{*name == 2};
  else action = RunCommand{edit::Set<&world::Settings::camera_mode>{static_cast<world::CameraMode>(*name - 3)}};
  return words.end();
}

constexpr StatementRow kSessionRows[]{
    {"coaster-script 1", "The first line of every script."},
    {"env [size WxH] [seed N] [scale X] [density X] [msaa N]",
     "Sets picture size (640x360), seed, scale of the panels (0.75..3), pixels per point (0.5..4), samples per pixel "
     "(0).",
     reads<read_environment>},
    {"env home \"$OUT/FOLDER\"",
     "Keeps settings and autosaves in that folder. The first line starts with an empty folder; a later one acts like a "
     "restart after a crash."},
    {"include \"FILE\"", "Runs another script's statements."},
    {"repeat N ... end", "Runs the lines up to end N times.", reads<read_repeat>},
    {"gesture ... end", "Makes the commands up to end one undo step.", reads<read_gesture>},
    {"lesson \"TEXT\" [at \"WIDGET\"] until CONDITION ... end",
     "Shows the text and waits until the player has done it; without a player, runs the lines up to end.",
     reads<read_lesson>},
    {"frames [N]", "Draws N frames of 2 ticks (1/60 s) each.", reads<read_frames>},
    {"ticks [N]", "Advances by N ticks of 1/120 s without drawing.", reads<read_ticks>},
    {"wait QUERY [ARGUMENT] OP VALUE [+-TOLERANCE] [max N ticks|frames|seconds]",
     "Advances until the condition holds, for at most 7200 ticks by default; exit code 6 on timeout.",
     reads<read_wait>},
    {"camera [target X Y Z] [yaw A] [pitch B] [distance D]", "Sets the camera; values that are not given stay.",
     read_camera},
    {"camera all|selection", "Frames the whole track or the selection."},
    {"camera orbit|ride|chase|fly", "The same as camera_mode."},
};

bool read_expected_file(WordReader& words, ExpectFile& expect) {
  if (!take(words, "a file", expect.path)) return false;
  if (words.accept("not")) expect.negated = !expect.negated;
  if (words.at_end() || words.accept("exists")) return true;
  if (!words.accept("same") && !words.accept("=="))
    return words.fail(words.peek()->column, "expected same or exists, found " + base::quoted_start(words.peek()->text));
  words.accept("as");
  return take(words, "the file to compare with", expect.same_as.emplace());
}

// Reads a statement and the optional end: ~ "text that the error contains".
bool read_expected_error(WordReader& words, Action& action) {
  ExpectError expect;
  std::span<const base::Token> rest = words.rest();
  if (rest.size() >= 2 && rest[rest.size() - 2].text == "~" && !rest[rest.size() - 2].quoted) {
    expect.contains = rest.back().text;
    rest = rest.first(rest.size() - 2);
  }
  if (rest.empty() && expect.contains) {  // expect error ~ "text": text of the newest notice
    Condition notice;
    notice.query = notice.text = "toast";
    notice.op = query::ComparisonOperator::contains;
    notice.values = {words.rest().back()};
    notice.column = words.rest().front().column;
    action = Expect{notice};
    return true;
  }
  if (rest.empty()) return words.fail(words.end_column(), "expected a statement that must fail");
  if (spans_lines(rest.front().text))
    return words.fail(rest.front().column,
                      "expected a statement of one line, found " + base::quoted_start(rest.front().text));
  Statement inner;
  inner.column = rest.front().column;
  base::TextError error;
  if (!parse_line(rest, error, inner.action)) {
    error.suggests = true;  // the usage that helps is that of the statement
    if (!error.out_of_range) return words.fail(error);
    expect.out_of_range = error.message;
  }
  expect.statement.push_back(std::move(inner));
  action = std::move(expect);
  return true;
}

bool read_expect(WordReader& words, std::size_t, Action& action) {
  const bool negated = words.accept("not");
  if (words.accept("file")) {
    ExpectFile file{.negated = negated};
    const bool read = read_expected_file(words, file);
    action = std::move(file);
    return read && words.end();
  }
  if (!negated && words.accept("error")) return read_expected_error(words, action);
  Expect expect;
  if (!parse_condition(words, expect.condition)) return false;
  expect.condition.negated = expect.condition.negated != negated;
  action = std::move(expect);
  return words.end();
}

// Reads the name of files below a folder, with or without that folder before it.
bool read_name(WordReader& words, std::string_view folder, std::string_view expected, std::string& name) {
  const base::Token* const word = words.take("a name");
  if (!word) return false;
  name = word->text;
  if (name.starts_with(folder)) name.erase(0, folder.size());
  return (!name.empty() && name.find("..") == std::string::npos && !name.starts_with('/')) ||
         words.fail(word->column, fmt::format("expected {}", expected));
}

bool read_snap(WordReader& words, Snap& snap) {
  return read_name(words, "", "a name below the script's folder golden", snap.name);
}

bool read_dump(WordReader& words, Dump& dump) { return read_name(words, "$OUT/", "a name", dump.name); }

bool take_picture(WordReader& words, std::string_view what, base::Token& path) {
  return take(words, what, path) && (base::lower(path.text).ends_with(".png") || words.reject(what));
}

bool read_shot(WordReader& words, Shot& shot) {
  return take_picture(words, "a file below $OUT ending in .png", shot.path);
}

bool read_sheet(WordReader& words, Sheet& sheet) {
  if (!take_picture(words, "a file below $OUT ending in .png", sheet.path)) return false;
  if (words.accept("columns") && !whole(words, "a number of columns", 1, 100, sheet.columns)) return false;
  sheet.half = words.accept("half");
  do {
    if (!take_picture(words, "a picture ending in .png", sheet.pictures.emplace_back())) return false;
  } while (!words.at_end());
  return true;
}

bool read_movie_start(WordReader& words, StartMovie& start) {
  if (!take(words, "a folder below $OUT", start.folder)) return false;
  if (words.accept("fps")) {
    if (!whole(words, "pictures a second", 1, world::kTicksPerSecond, start.fps)) return false;
    if (!is_movie_rate(start.fps)) return words.reject_number(fmt::format("{} pictures a second", kMovieRateWords));
  }
  start.gif = words.accept("gif");
  return true;
}

bool read_movie_stop(WordReader&, StopMovie&) { return true; }

bool read_log(WordReader& words, Log& log) {
  if (words.at_end()) return words.fail(words.end_column(), "expected a query or a text");
  while (!words.at_end()) {
    if (words.peek()->quoted) {
      log.parts.push_back({words.take("a text")->text, {}, {}, 1});
      continue;
    }
    // A query alone: parse_condition stops after its words.
    const query::Query* const query = query::find_query(words.peek()->text);
    const std::size_t count = query && !query->argument.empty() ? 2 : 1;
    Condition value;
    base::TextError error;
    WordReader part(words.rest().first(std::min(count, words.rest().size())), error);
    if (!parse_condition(part, value)) return words.fail(error);
    for (std::size_t i = 0; i < count; ++i) words.take("a query");
    log.parts.push_back({{}, value.query, value.argument, value.column});
  }
  return true;
}

// Reads one word of an enumeration.
template <class E>
bool read_named(WordReader& words, std::string_view expected, E& to) {
  const auto name = words.one_of(expected, base::names_of<E>());
  if (name) to = static_cast<E>(*name);
  return name.has_value();
}

bool read_needs(WordReader& words, RequireStage& needs) {
  return read_named(words, "what evaluates, such as geometry_shader", needs.stage);
}

bool read_crash(WordReader& words, base::PlannedCrash& crash) {
  return read_named(words, "where to crash, such as drawing", crash.place) &&
         (words.at_end() || read_named(words, "how to crash", crash.way));
}

bool read_slow_import(WordReader& words, SlowImport& slow) {
  if (!words.accept("slow")) return words.fail(next_column(words), "expected \"slow\"");
  return whole(words, "a number of frames", 1, 10'000, slow.frames);
}

bool read_fault(WordReader& words, std::size_t, Action& action) {
  static const std::vector<std::string> kOperations = [] {
    std::vector<std::string> names;
    for (const std::string_view name : base::kIoOperationNames) names.push_back(fmt::format("io.{}", name));
    names.insert(names.end(), {"import", "crash"});
    return names;
  }();
  const auto operation = words.one_of("an operation such as io.fsync, import or crash", kOperations);
  if (!operation) return false;
  if (kOperations[*operation] == "crash") return reads<read_crash>(words, 0, action);
  if (kOperations[*operation] == "import") return reads<read_slow_import>(words, 0, action);
  if (!words.accept("fail")) return words.fail(next_column(words), "expected \"fail\"");
  InjectFault fault{static_cast<base::IoOperation>(*operation)};
  if (!words.at_end() && !whole(words, "the number of the call that fails", 1, 1'000'000, fault.nth)) return false;
  action = fault;
  return words.end();
}

constexpr StatementRow kOutputRows[]{
    {"expect QUERY [ARGUMENT] OP VALUE [+-TOLERANCE]",
     "Checks a value. OP: == != < <= > >= and ~ (contains). A value that is none meets only == none.", read_expect},
    {"expect [not] visible|enabled \"PATH\"", "Checks a widget's state."},
    {"expect file \"FILE\" exists | same \"FILE\"", "Checks that a file exists, or equals another byte by byte."},
    {"expect error STATEMENT [~ \"TEXT\"]",
     "Checks that the statement, written correctly, fails with TEXT in its message."},
    {"snap \"NAME\"", "Compares the picture with golden/NAME.png beside the script.", reads<read_snap>},
    {"shot \"$OUT/FILE.png\"", "Writes the picture.", reads<read_shot>},
    {"sheet \"$OUT/FILE.png\" [columns N] [half] \"PICTURE.png\" ...",
     "Combines pictures into one, 3 in a row by default, with half at half size.", reads<read_sheet>},
    {"movie.start \"$OUT/FOLDER\" [fps N] [gif]",
     "Records all ticks from here on, N pictures a second (30): numbered PNG files, and movie.mp4 (movie.gif) "
     "if ffmpeg is installed.",
     reads<read_movie_start>},
    {"movie.stop", "Stops recording and waits for the movie file.", reads<read_movie_stop>},
    {"dump \"NAME\"", "Writes picture, widgets, values and document to $OUT/NAME.*.", reads<read_dump>},
    {"log QUERY|\"TEXT\" ...", "Prints values and texts to stdout.", reads<read_log>},
    {"needs vertex_shader|geometry_shader|tessellation_shader",
     "Ends the script as skipped, with exit code 77, where the driver cannot evaluate there.", reads<read_needs>},
    {"fault io.open|read|write|fsync|rename|close fail [N]", "Makes the Nth such operation from now on fail.",
     read_fault},
    {"fault crash input|job|panels|command|ticks|findings|drawing|keeping [access|check|exception|stack|memory]",
     "Crashes the program the next time that it comes to that place."},
    {"fault import slow N",
     "Makes the next import, search or change of a circuit by hand take N frames longer, time to see its progress bar "
     "or cancel."},
};

// Returns the form of a word that has most of the line's words.
std::string_view usage_for(std::string_view word, std::span<const base::Token> line) {
  std::string_view usage;
  std::ptrdiff_t most = -1;
  for (const NamedRow& form : named_rows()) {
    if (form.word != word) continue;
    const auto shared = std::count_if(line.begin() + 1, line.end(), [&](const base::Token& token) {
      return !token.quoted && form.row->usage.find(token.text) != std::string_view::npos;
    });
    if (shared > most) most = shared, usage = form.row->usage;
  }
  return usage;
}

// Adds what helps to the error of a line: that a block has no brackets, or the usage, as edit::parse does.
void add_help(std::string_view word, std::span<const base::Token> line, base::TextError& error) {
  const base::Token& last = line.back();
  if (opens_block(word) && !last.quoted && (last.text.ends_with('{') || last.text.ends_with(':'))) {
    error.message += ": a block has no { or :, only an \"end\"";
    return;
  }
  const auto says = [&](std::string_view words) { return error.message.find(words) != std::string::npos; };
  if (error.out_of_range || error.suggests || says(" did you mean ") || says("; usage: ")) return;
  error.message += fmt::format("; usage: {}", usage_for(word, line));
}

// Checks what a search aims for and changes, so that errors have their place and are found before the script runs.
bool check_seek(std::span<const base::Token> line, const edit::Command& command, base::TextError& error) {
  const auto by =
      std::find_if(line.begin(), line.end(), [](const base::Token& t) { return t.text == "by" && !t.quoted; });
  WordReader goal(line.subspan(1, static_cast<std::size_t>(by - line.begin()) - 1), error);
  if (!query::check_goal(goal)) return false;
  const auto wrong = edit::wrong_by(*command.as<edit::SeekGoal>());
  if (wrong) error = {(by + 1)->column, *wrong};
  return !wrong;
}

}  // namespace

std::span<const RowGroup> row_groups() {
  static const std::array kGroups{RowGroup{"Session", kSessionRows}, RowGroup{"Input", input_rows()},
                                  RowGroup{"Checks and output", kOutputRows}};
  return kGroups;
}

std::vector<std::string> words_of(const StatementRow& row) {
  std::string_view left = row.usage.substr(0, row.usage.find(' '));
  std::vector<std::string> words;
  for (;;) {
    std::string word(left.substr(0, left.find('|')));
    if (!words.empty() && word.find('.') == std::string::npos)
      word.insert(0, words[0].substr(0, words[0].find('.') + 1));
    words.push_back(std::move(word));
    if (left.find('|') == std::string_view::npos) return words;
    left.remove_prefix(left.find('|') + 1);
  }
}

std::string_view usage(std::string_view word) {
  const NamedRow* const found = find_named(word);
  return found ? found->row->usage : std::string_view();
}

bool opens_block(std::string_view word) { return usage(word).ends_with("... end"); }

const std::vector<std::string>& statement_words() {
  static const std::vector<std::string> kWords = [] {
    std::vector<std::string> words;
    for (const NamedRow& row : named_rows())
      if (words.empty() || words.back() != row.word) words.push_back(row.word);
    for (const edit::CommandHelp& row : edit::command_table())
      if (!find_named(row.info.name)) words.emplace_back(row.info.name);
    words.emplace_back("end");
    return words;
  }();
  return kWords;
}

std::string help() {
  std::string out = "Coaster scripts, version 1: one statement per line; # starts a comment.\n\n";
  for (const RowGroup& group : row_groups()) {
    out += fmt::format("{}\n", group.title);
    for (const StatementRow& row : group.rows) out += fmt::format("  {}\n      {}\n", row.usage, row.help);
    out += "\n";
  }
  out += "Commands\n";
  for (const edit::CommandHelp& row : edit::command_table())
    out += fmt::format("  {}\n      {}\n", row.usage, row.info.help);
  out += "\nQueries\n";
  for (const query::Query& query : query::queries()) {
    const std::string unit = query.unit.empty() ? "" : fmt::format(" ({})", query.unit);
    out += fmt::format("  {}{}{}{}{}\n      {}\n", query.name, query.argument.empty() ? "" : " ",
                       usage_of(query.argument), unit, query.values.may_be_none ? " or none" : "", query.text);
  }
  return out + "\n" + base::exit_codes_sentence() + "\n";
}

bool read_command(std::string_view name, std::span<const base::Token> rest, WordReader& words, Action& action) {
  std::vector<base::Token> line{{std::string(name), 1, false}};
  line.insert(line.end(), rest.begin(), rest.end());
  base::TextError error;
  const auto command = edit::parse(line, error);
  if (!command) return words.fail(error);
  action = RunCommand{*command};
  return true;
}

bool parse_line(std::span<const base::Token> line, base::TextError& error, Action& action) {
  const base::Token& first = line.front();
  if (const NamedRow* const found = find_named(first.text); found && found->row->read) {
    WordReader words(line, error);
    words.take("a statement");
    if (found->row->read(words, found->which, action) && !words.failed()) return true;
    add_help(found->word, line, error);
    return false;
  }
  if (!edit::is_command(first.text)) {
    error = {first.column, fmt::format("no command {}{}", base::quoted_start(first.text), near_words(line))};
    return false;
  }
  auto command = edit::parse(line, error);
  if (!command || (command->is<edit::SeekGoal>() && !check_seek(line, *command, error))) return false;
  action = RunCommand{*command};
  return true;
}

bool number_within(WordReader& words, std::string_view what, double low, double high, float& to) {
  double value = 0;
  if (!number(words, what, value)) return false;
  to = static_cast<float>(value);
  return (value >= low && value <= high) || words.reject_number(what);
}

std::optional<std::size_t> choice(WordReader& words, std::span<const std::string> names) {
  return words.one_of(base::alternatives(names), names);
}

bool end_of_text(WordReader& words) {
  if (words.failed() || words.at_end()) return words.end();
  return words.fail(words.peek()->column,
                    "unexpected " + base::quoted_start(words.peek()->text) + ": a text with blanks needs quotes");
}

}  // namespace coaster::script
