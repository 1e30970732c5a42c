// The keys of actions, from their table and the settings.
#include "ui/context/key_map.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::ui {
namespace {

using platform::Chord;

std::optional<std::size_t> index_of(std::span<const std::string_view> names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

struct Wanted {
  std::size_t row;
  std::vector<Chord> chords;
};

// What of the choices can be read; the first choice of a key has it.
std::vector<Wanted> readable(std::span<const std::string_view> names, std::span<const exchange::KeyChoice> choices,
                             std::vector<std::string>& problems) {
  std::vector<Wanted> all;
  const std::vector<std::string> actions(names.begin(), names.end());
  for (const exchange::KeyChoice& choice : choices) {
    const auto row = index_of(names, choice.action);
    if (!row) {
      problems.push_back(
          fmt::format("no action {}{}", base::quoted(choice.action), base::suggestion(choice.action, actions)));
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
        problems.push_back(fmt::format("{} is wanted by {} and {}", text, names[owner->row], choice.action));
      else wanted.chords.push_back(*chord);
      usable = usable && chord && owner == all.end();
    }
    if (usable) all.push_back(std::move(wanted));
  }
  return all;
}

}  // namespace

KeyMap KeyMap::make(std::span<const KeyRow> rows, std::span<const exchange::KeyChoice> choices,
                    std::vector<std::string>& problems) {
  KeyMap map;
  for (const KeyRow& row : rows) {
    map.names_.push_back(row.name);
    std::vector<Chord>& chords = map.rows_.emplace_back();
    for (const Chord& chord : {row.first, row.second})
      if (chord.key != platform::Key::unknown) chords.push_back(chord);
  }
  const std::vector<Wanted> all = readable(map.names_, choices, problems);
  for (const Wanted& wanted : all) map.rows_[wanted.row] = wanted.chords;
  for (const Wanted& wanted : all)
    for (std::size_t row = 0; row < map.rows_.size(); ++row)
      for (const Chord& chord : wanted.chords) {
        if (row == wanted.row) continue;
        if (std::erase(map.rows_[row], chord) > 0)
          problems.push_back(fmt::format("{} is {} now, no longer {}", platform::to_text(chord), map.names_[wanted.row],
                                         map.names_[row]));
      }
  return map;
}

std::optional<std::size_t> KeyMap::row_of(std::string_view action) const { return index_of(names_, action); }

std::string KeyMap::shown(std::size_t row) const {
  return rows_[row].empty() ? std::string() : platform::to_text(rows_[row].front());
}

std::string KeyMap::shown(std::string_view action) const {
  const auto row = row_of(action);
  return row ? shown(*row) : std::string();
}

std::string with_keys(const KeyMap& keys, std::string_view help, std::string_view action) {
  const auto row = keys.row_of(action);
  std::string text(help);
  if (!row || keys.chords(*row).empty()) return text;
  text += keys.chords(*row).size() == 1 ? " Key " : " Keys ";
  for (const Chord& chord : keys.chords(*row))
    text += (&chord == &keys.chords(*row).front() ? "" : ", ") + platform::to_text(chord);
  return text + ".";
}

}  // namespace coaster::ui
