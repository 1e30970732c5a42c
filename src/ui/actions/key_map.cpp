// The keys of actions, from their table and the settings.
#include "ui/actions/key_map.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/text.h"
#include "ui/actions/actions.h"

namespace coaster::ui {
namespace {

using platform::Chord;

std::optional<std::size_t> row_of(std::string_view name) {
  const auto found = std::find_if(actions().begin(), actions().end(), [&](const Action& a) { return a.name == name; });
  if (found == actions().end()) return std::nullopt;
  return static_cast<std::size_t>(found - actions().begin());
}

std::string nearest_action(std::string_view name) {
  std::vector<std::string> names;
  for (const Action& action : actions()) names.emplace_back(action.name);
  return base::suggestion(name, names);
}

struct Wanted {
  std::size_t row;
  std::vector<Chord> chords;
};

// What of the choices can be read; the first choice of a key has it.
std::vector<Wanted> readable(std::span<const exchange::KeyChoice> choices, std::vector<std::string>& problems) {
  std::vector<Wanted> all;
  for (const exchange::KeyChoice& choice : choices) {
    const auto row = row_of(choice.action);
    if (!row) {
      problems.push_back(fmt::format("no action {}{}", base::quoted(choice.action), nearest_action(choice.action)));
      continue;
    }
    Wanted wanted{*row, {}};
    bool usable = true;
    for (const std::string& text : choice.keys) {
      const auto chord = platform::parse_chord(text);
      const auto owner =
          chord ? std::find_if(all.begin(), all.end(),
                               [&](const Wanted& w) {
                                 return std::find(w.chords.begin(), w.chords.end(), *chord) != w.chords.end();
                               })
                : all.end();
      if (!chord) problems.push_back(fmt::format("{}: no key {}", choice.action, base::quoted(text)));
      else if (owner != all.end())
        problems.push_back(fmt::format("{} is wanted by {} and {}", text, actions()[owner->row].name, choice.action));
      else wanted.chords.push_back(*chord);
      usable = usable && chord && owner == all.end();
    }
    if (usable) all.push_back(std::move(wanted));
  }
  return all;
}

}  // namespace

KeyMap KeyMap::make(std::span<const exchange::KeyChoice> choices, std::vector<std::string>& problems) {
  KeyMap map;
  for (const Action& action : actions()) {
    std::vector<Chord>& row = map.rows_.emplace_back();
    for (const Chord& chord : {action.chord, action.other})
      if (chord.key != platform::Key::unknown) row.push_back(chord);
  }
  const std::vector<Wanted> all = readable(choices, problems);
  for (const Wanted& wanted : all) map.rows_[wanted.row] = wanted.chords;
  for (const Wanted& wanted : all)
    for (std::size_t row = 0; row < map.rows_.size(); ++row)
      for (const Chord& chord : wanted.chords) {
        if (row == wanted.row) continue;
        if (std::erase(map.rows_[row], chord) > 0)
          problems.push_back(fmt::format("{} is {} now, no longer {}", platform::to_text(chord),
                                         actions()[wanted.row].name, actions()[row].name));
      }
  return map;
}

std::string KeyMap::shown(std::size_t row) const {
  return rows_[row].empty() ? std::string() : platform::to_text(rows_[row].front());
}

std::string KeyMap::shown(std::string_view action) const {
  const auto row = row_of(action);
  return row ? shown(*row) : std::string();
}

std::string with_keys(const KeyMap& keys, std::string_view help, std::string_view action) {
  const auto row = row_of(action);
  std::string text(help);
  if (!row || keys.chords(*row).empty()) return text;
  text += keys.chords(*row).size() == 1 ? " Key " : " Keys ";
  for (const Chord& chord : keys.chords(*row))
    text += (&chord == &keys.chords(*row).front() ? "" : ", ") + platform::to_text(chord);
  return text + ".";
}

}  // namespace coaster::ui
