// What a message says about an unknown first word: the word that was probably meant, of this language or another one.
#include "script/lines.h"

#include <algorithm>

#include <fmt/format.h>

#include "script/grammar.h"

namespace coaster::script {
namespace {

// Words of other languages, Playwright and imgui_test_engine among them, in lower case and without what is before the
// last dot or arrow (page.goto, ctx->ItemClick); and what a script says in their place: a word or, after a semicolon,
// how to do it.
struct Elsewhere {
  std::string_view word, here;
};
constexpr std::string_view kNoConditions = "; scripts have no conditions: wait waits for one, expect checks one",
                           kNoVariables = "; scripts have no variables",
                           kLabels = "; widgets are named by label: ui.click \"Track/Insert point\"",
                           kWaits = "; wait visible \"Track/Insert point\" waits for a widget";
constexpr Elsewhere kElsewhere[]{{"//", "; comments begin with #"},
                                 {"assert", "expect"},
                                 {"capture", "shot"},
                                 {"click", "ui.click"},
                                 {"const", kNoVariables},
                                 {"dblclick", "ui.doubleclick"},
                                 {"dragto", "ui.drag"},
                                 {"echo", "log"},
                                 {"export", "save"},
                                 {"fill", "ui.type"},
                                 {"for", "repeat"},
                                 {"getbylabel", kLabels},
                                 {"getbyrole", kLabels},
                                 {"getbytext", kLabels},
                                 {"goto", "load"},
                                 {"hold", "; raw.key W down presses a key until raw.key W up"},
                                 {"hover", "ui.hover"},
                                 {"if", kNoConditions},
                                 {"im_check", "expect"},
                                 {"im_check_eq", "expect"},
                                 {"import", "load"},
                                 {"itemcheck", "ui.check"},
                                 {"itemclick", "ui.click"},
                                 {"itemclose", "ui.close"},
                                 {"itemdoubleclick", "ui.doubleclick"},
                                 {"iteminput", "ui.type"},
                                 {"iteminputvalue", "ui.type"},
                                 {"itemopen", "ui.open"},
                                 {"itemuncheck", "ui.check"},
                                 {"keychars", "text"},
                                 {"keypress", "key"},
                                 {"let", kNoVariables},
                                 {"locator", kLabels},
                                 {"loop", "repeat"},
                                 {"menuclick", "ui.menu"},
                                 {"mousemove", "ui.hover"},
                                 {"open", "load"},
                                 {"press", "key"},
                                 {"print", "log"},
                                 {"screenshot", "shot"},
                                 {"set", "; a setting is set by its name and value, such as resolution 64"},
                                 {"setinputfiles", "drop"},
                                 {"setref", kLabels},
                                 {"setviewportsize", "resize"},
                                 {"sleep", "frames"},
                                 {"source", "include"},
                                 {"uncheck", "ui.check"},
                                 {"var", kNoVariables},
                                 {"verify", "expect"},
                                 {"waitfor", kWaits},
                                 {"waitforselector", kWaits},
                                 {"waitfortimeout", "frames"},
                                 {"while", kNoConditions},
                                 {"write", "save"},
                                 {"yield", "frames"},
                                 {"}", "end"}};

}  // namespace

std::string near_words(std::span<const base::Token> line) {
  const std::vector<std::string>& known = statement_words();
  if (line.size() > 1)
    if (const std::string dotted = fmt::format("{}.{}", line[0].text, line[1].text);
        std::find(known.begin(), known.end(), dotted) != known.end())
      return base::suggestion(dotted, known);
  const std::string& first = line[line.size() > 1 && line[0].text == "await" ? 1 : 0].text;
  const std::string word = first.substr(0, first.find('('));
  const std::string last = word.substr(word.find_last_of(".>") + 1);
  for (const Elsewhere& row : kElsewhere)
    if (row.word == base::lower(last))
      return row.here.starts_with(';') ? std::string(row.here) : fmt::format("; did you mean \"{}\"?", row.here);
  if (std::string near = base::suggestion(word, known); !near.empty()) return near;
  const auto found = std::find_if(known.begin(), known.end(), [&](const std::string& k) {
    return k == word || k.ends_with(fmt::format(".{}", last));
  });
  return found != known.end() ? fmt::format("; did you mean \"{}\"?", *found) : "; coaster --help-script lists all";
}

}  // namespace coaster::script
