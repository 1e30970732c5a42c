// Parses the statements that write something: snap, shot, sheet, dump, log, movie.
#include "script/lines.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "query/condition.h"

namespace coaster::script {
namespace {

bool parse_snap(Words& words, Action& action) {
  const base::Token* const name = words.take("a name");
  if (!name) return false;
  if (name->text.empty() || name->text.find("..") != std::string::npos || name->text.starts_with('/'))
    return words.fail(name->column, "expected a name below the script's folder golden");
  action = Snap{name->text};
  return words.end();
}

bool take_picture(Words& words, std::string_view what, base::Token& path) {
  return take(words, what, path) && (base::lower(path.text).ends_with(".png") || words.reject(what));
}

bool parse_shot(Words& words, Action& action) {
  Shot shot;
  if (!take_picture(words, "a file below $OUT ending in .png", shot.path)) return false;
  action = std::move(shot);
  return words.end();
}

bool parse_sheet(Words& words, Action& action) {
  Sheet sheet;
  if (!take_picture(words, "a file below $OUT ending in .png", sheet.path)) return false;
  if (words.accept("columns")) {
    const auto columns = words.whole("a number of columns", 1, 100);
    if (!columns) return false;
    sheet.columns = static_cast<int>(*columns);
  }
  sheet.half = words.accept("half");
  do {
    if (!take_picture(words, "a picture ending in .png", sheet.pictures.emplace_back())) return false;
  } while (!words.at_end());
  action = std::move(sheet);
  return true;
}

bool parse_dump(Words& words, Action& action) {
  const base::Token* const name = words.take("a name");
  if (!name) return false;
  std::string text = name->text;
  if (text.starts_with("$OUT/")) text = text.substr(5);
  if (text.empty() || text.find("..") != std::string::npos || text.starts_with('/'))
    return words.fail(name->column, "expected a name");
  action = Dump{text};
  return words.end();
}

bool parse_log(Words& words, Action& action) {
  Log log;
  if (words.at_end()) return words.fail(words.end_column(), "expected a query or a text");
  while (!words.at_end()) {
    if (words.peek()->quoted) {
      log.parts.push_back({words.take("a text")->text, {}, {}, 1});
      continue;
    }
    Condition value;
    const base::Token* const name = words.peek();
    // A query alone: parse_condition stops after its words.
    const query::Query* const query = query::find_query(name->text);
    const std::size_t count = query && !query->argument.empty() ? 2 : 1;
    base::TextError error;
    Words part(words.rest().first(std::min(count, words.rest().size())), error);
    if (!parse_condition(part, value)) return words.fail(error);
    for (std::size_t i = 0; i < count; ++i) words.take("a query");
    log.parts.push_back({{}, value.query, value.argument, value.column});
  }
  action = log;
  return true;
}

bool parse_movie_start(Words& words, Action& action) {
  StartMovie start;
  if (!take(words, "a folder below $OUT", start.folder)) return false;
  if (words.accept("fps")) {
    const auto fps = words.whole("pictures a second", 1, world::kTicksPerSecond);
    if (!fps) return false;
    if (!is_movie_rate(*fps)) return words.reject_number(fmt::format("{} pictures a second", kMovieRateWords));
    start.fps = static_cast<int>(*fps);
  }
  start.gif = words.accept("gif");
  action = start;
  return words.end();
}

bool parse_movie_stop(Words& words, Action& action) {
  action = StopMovie{};
  return words.end();
}

constexpr LineRow kOutputLines[]{{"snap", parse_snap},
                                 {"shot", parse_shot},
                                 {"sheet", parse_sheet},
                                 {"dump", parse_dump},
                                 {"movie.start", parse_movie_start},
                                 {"movie.stop", parse_movie_stop},
                                 {"log", parse_log}};

}  // namespace

std::span<const LineRow> output_lines() { return kOutputLines; }

}  // namespace coaster::script
