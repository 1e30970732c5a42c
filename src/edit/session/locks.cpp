#include "edit/session/locks.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/text.h"

namespace coaster::edit {
namespace {

// The labels of buttons that differ from their command's name.
constexpr std::pair<std::string_view, std::string_view> kLabels[] = {
    {"auto_bank", "Auto-bank"},    {"complete", "Complete circuit"}, {"equalise", "Equalise handles"},
    {"equip", "Equipment"},        {"losses.set", "Losses"},         {"seek", "Goal"},
    {"section.equip", "Equipment"}};

std::string label_of(std::string_view command) {
  const auto* const row = std::ranges::find(kLabels, command, &std::pair<std::string_view, std::string_view>::first);
  if (row != std::end(kLabels)) return std::string(row->second);
  std::string words(command);
  for (char& c : words)
    if (c == '_' || c == '.') c = ' ';
  words = base::sentence(std::move(words));
  words.pop_back();
  return words;
}

}  // namespace

bool is_locked(const Session& session, std::string_view command) {
  if (!session.game.challenge) return false;
  const std::vector<std::string>& locks = session.game.challenge->file.locks;
  return std::ranges::find(locks, command) != locks.end();
}

std::string locked_text(const std::vector<std::string>& commands) {
  std::vector<std::string> labels;
  for (const std::string& command : commands)
    if (std::string label = label_of(command); std::ranges::find(labels, label) == labels.end())
      labels.push_back(std::move(label));
  return fmt::format("Locked in this challenge: {}.", fmt::join(labels, ", "));
}

}  // namespace coaster::edit
