#include "ui/context/ui.h"

#include <imgui.h>

#include <algorithm>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"
#include "edit/commands/commands_session.h"
#include "edit/session/session.h"
#include "ui/widgets/theme.h"
#include "world/aid_settings.h"

namespace coaster::ui {
namespace {

using platform::KeyChord;

struct ChosenKeys {
  std::size_t row;
  std::vector<KeyChord> chords;
};

// Returns the valid choices; if several choose the same key, the first one gets it.
std::vector<ChosenKeys> readable(std::span<const std::string_view> names, std::span<const exchange::KeyBinding> choices,
                                 std::vector<std::string>& problems) {
  std::vector<ChosenKeys> all;
  const std::vector<std::string> actions(names.begin(), names.end());
  for (const exchange::KeyBinding& choice : choices) {
    const auto row = std::find(names.begin(), names.end(), choice.action);
    if (row == names.end()) {
      problems.push_back(base::sentence(fmt::format("there is no action {}{}", base::quoted_start(choice.action),
                                                    base::suggestion(choice.action, actions))));
      continue;
    }
    ChosenKeys wanted{static_cast<std::size_t>(row - names.begin()), {}};
    bool usable = true;
    for (const std::string& text : choice.keys) {
      const auto chord = platform::parse_chord(text);
      const auto owner = std::find_if(all.begin(), all.end(), [&](const ChosenKeys& w) {
        return chord && std::find(w.chords.begin(), w.chords.end(), *chord) != w.chords.end();
      });
      if (!chord)
        problems.push_back(
            fmt::format("{} keeps its default keys because {} is not a key.", choice.action, base::quoted_start(text)));
      else if (owner != all.end())
        problems.push_back(fmt::format("{0} is assigned to both {1} and {2}. {2} keeps its default keys.", text,
                                       names[owner->row], choice.action));
      else wanted.chords.push_back(*chord);
      usable = usable && chord && owner == all.end();
    }
    if (usable) all.push_back(std::move(wanted));
  }
  return all;
}

}  // namespace

KeyMap KeyMap::make(std::span<const KeyRow> rows, std::span<const exchange::KeyBinding> choices,
                    std::vector<std::string>& problems) {
  KeyMap map;
  for (const KeyRow& row : rows) {
    map.names_.push_back(row.name);
    std::vector<KeyChord>& chords = map.rows_.emplace_back();
    for (const KeyChord& chord : {row.first, row.second})
      if (chord.key != platform::Key::unknown) chords.push_back(chord);
  }
  const std::vector<ChosenKeys> all = readable(map.names_, choices, problems);
  for (const ChosenKeys& wanted : all) map.rows_[wanted.row] = wanted.chords;
  for (const ChosenKeys& wanted : all)
    for (std::size_t row = 0; row < map.rows_.size(); ++row)
      for (const KeyChord& chord : wanted.chords) {
        if (row == wanted.row) continue;
        if (std::erase(map.rows_[row], chord) > 0)
          problems.push_back(fmt::format("{} now belongs to {}, not to {}.", platform::to_text(chord),
                                         map.names_[wanted.row], map.names_[row]));
      }
  return map;
}

std::span<const KeyChord> KeyMap::chords(std::string_view action) const {
  const auto row = std::find(names_.begin(), names_.end(), action);
  if (row == names_.end()) return {};
  return rows_[static_cast<std::size_t>(row - names_.begin())];
}

std::string KeyMap::shown(std::string_view action) const {
  return chords(action).empty() ? std::string() : platform::to_text(chords(action).front());
}

std::string chords_text(std::span<const KeyChord> chords, std::string_view between) {
  std::string text;
  for (const KeyChord& chord : chords) {
    if (!text.empty()) text += between;
    text += platform::to_text(chord);
  }
  return text;
}

std::string with_keys(const KeyMap& keys, std::string_view help, std::string_view action) {
  const auto chords = keys.chords(action);
  if (chords.empty()) return std::string(help);
  return fmt::format("{} Key{} {}.", help, chords.size() == 1 ? "" : "s", chords_text(chords, ", "));
}

void Ui::begin_step() { emit(edit::BeginGesture{}); }
void Ui::end_step() { emit(edit::EndGesture{}); }

edit::Command Ui::new_track() const {
  const world::Land land = session().settings.aids->new_land;
  if (land == world::Land::plain) return edit::NewTrack{};
  return edit::NewPark{land, random_seed(*this)};
}

std::uint32_t random_seed(const Ui& ui) {
  constexpr std::uint64_t kMost = 9999;  // short enough to be told to others
  base::Hasher hasher;
  hasher.add(ui.state.seconds);
  hasher.add(ui.session().document.park.seed);
  return static_cast<std::uint32_t>(1 + hasher.digest() % kMost);
}

void build_area(Ui& ui, const view::Viewport& area, const WindowArea& look, const std::function<void()>& content) {
  if (area.width < 1 || area.height < 1) return;
  if (look.padding) ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, *look.padding);
  if (look.raised) ImGui::PushStyleColor(ImGuiCol_WindowBg, colour(palette().raised));
  ui.panel = look.panel;
  ImGui::SetNextWindowPos({area.x, area.y});
  ImGui::SetNextWindowSize(sized({area.width, area.height}));
  constexpr ImGuiWindowFlags kFixed =
      ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
  if (ImGui::Begin(look.id, nullptr, look.more | kFixed)) content();
  ui.panel.clear();
  ImGui::End();
  if (look.raised) ImGui::PopStyleColor();
  if (look.padding) ImGui::PopStyleVar();
}

LockedWidgets::LockedWidgets(Ui& ui, std::string_view command) : ui_(ui), before_(ui.locked) {
  const bool locked = edit::is_locked(ui.session(), command);
  if (locked) ui.locked = edit::locked_text({std::string(command)});
  ImGui::BeginDisabled(locked);
}
LockedWidgets::~LockedWidgets() {
  ImGui::EndDisabled();
  ui_.locked = before_;
}

}  // namespace coaster::ui
