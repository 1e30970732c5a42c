// What a message says about an unknown first word: the word that was probably meant, of this language or another one.
#include <algorithm>

#include <fmt/format.h>

#include "script/grammar.h"
#include "script/statement_rows.h"

namespace coaster::script {
namespace {

// Playwright's and imgui_test_engine's words among them, in lower case and without what is before the last dot or arrow
// (page.goto, ctx->ItemClick).
constexpr ForeignWords kForeignWords[]{
    {"assert im_check im_check_eq verify", "expect"},
    {"capture screenshot", "shot"},
    {"click itemclick", "ui.click"},
    {"dblclick itemdoubleclick", "ui.doubleclick"},
    {"hover mousemove", "ui.hover"},
    {"itemcheck itemuncheck uncheck", "ui.check"},
    {"fill iteminput iteminputvalue", "ui.type"},
    {"dragto", "ui.drag"},
    {"itemopen", "ui.open"},
    {"itemclose", "ui.close"},
    {"menuclick", "ui.menu"},
    {"keypress press", "key"},
    {"keychars", "text"},
    {"setinputfiles", "drop"},
    {"setviewportsize", "resize"},
    {"echo print", "log"},
    {"goto import open", "load"},
    {"export write", "save"},
    {"for loop", "repeat"},
    {"}", "end"},
    {"source", "include"},
    {"sleep waitfortimeout yield", "frames"},
    {"//", "; comments begin with #"},
    {"if while", "; scripts have no conditions: wait waits for one, expect checks one"},
    {"const let var", "; scripts have no variables"},
    {"getbylabel getbyrole getbytext locator setref", "; widgets are named by label: ui.click \"Track/Insert point\""},
    {"waitfor waitforselector", "; wait visible \"Track/Insert point\" waits for a widget"},
    {"hold", "; raw.key W down presses a key until raw.key W up"},
    {"set", "; a setting is set by its name and value, such as resolution 64"}};

// True if `word` is one of the words that blanks separate.
bool has_word(std::string_view words, std::string_view word) {
  return fmt::format(" {} ", words).find(fmt::format(" {} ", word)) != std::string::npos;
}

}  // namespace

std::span<const ForeignWords> foreign_words() { return kForeignWords; }

std::string near_words(std::span<const base::Token> line) {
  const std::vector<std::string>& known = statement_words();
  if (line.size() > 1)
    if (const std::string dotted = fmt::format("{}.{}", line[0].text, line[1].text);
        std::find(known.begin(), known.end(), dotted) != known.end())
      return base::suggestion(dotted, known);
  const std::string& first = line[line.size() > 1 && line[0].text == "await" ? 1 : 0].text;
  const std::string word = first.substr(0, first.find('('));
  const std::string last = word.substr(word.find_last_of(".>") + 1);
  for (const ForeignWords& row : kForeignWords)
    if (has_word(row.words, base::lower(last)))
      return row.here.starts_with(';') ? std::string(row.here) : fmt::format("; did you mean \"{}\"?", row.here);
  if (std::string near = base::suggestion(word, known); !near.empty()) return near;
  const auto found = std::find_if(known.begin(), known.end(), [&](const std::string& k) {
    return k == word || k.ends_with(fmt::format(".{}", last));
  });
  return found != known.end() ? fmt::format("; did you mean \"{}\"?", *found) : "; coaster --help-script lists all";
}

}  // namespace coaster::script
