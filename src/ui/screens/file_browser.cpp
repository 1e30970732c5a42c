#include "ui/screens/file_browser.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/formats.h"
#include "exchange/own/share_link.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

constexpr std::size_t kMostRows = 2000;  // drawn at once; typing finds the others
constexpr double kReadAgain = 1;         // s

// True for a path: names contain no slash.
bool is_path(const std::string& words) { return words.find('/') != std::string::npos || words == "~" || words == ".."; }

std::filesystem::path expanded(const std::string& words, const std::filesystem::path& folder) {
  const char* const home = std::getenv("HOME");
  if ((words == "~" || words.starts_with("~/")) && home != nullptr)
    return std::filesystem::path(home) / words.substr(std::min<std::size_t>(2, words.size()));
  return (folder / words).lexically_normal();
}

}  // namespace

void FileBrowser::start(Mode mode, std::filesystem::path folder, std::string name) {
  *this = FileBrowser();
  mode_ = mode;
  words_ = std::move(name);
  go(std::move(folder));
}

void FileBrowser::go(std::filesystem::path folder) {
  std::error_code error;
  folder = std::filesystem::absolute(folder, error).lexically_normal();
  if (!folder.has_filename() && folder != folder.root_path()) folder = folder.parent_path();
  while (folder != folder.root_path() && !std::filesystem::is_directory(folder, error)) folder = folder.parent_path();
  if (folder != folder_) marked_.clear();
  folder_ = folder;
  read_at_ = -1;
  if (mode_ == Mode::open) words_.clear();
}

void FileBrowser::up() {
  if (folder_ == folder_.root_path()) return;
  const std::string from = folder_.filename().string();
  go(folder_.parent_path());
  marked_ = from;
  scroll_ = by_key_ = true;
}

void FileBrowser::refresh(double seconds) {
  if (read_at_ >= 0 && seconds - read_at_ < kReadAgain && seconds >= read_at_) return;
  read_at_ = seconds;
  auto read = base::list_folder(folder_, all_);
  problem_ = read ? "" : read.status().message;
  entries_ = read ? std::move(*read) : std::vector<base::FolderEntry>();
}

bool FileBrowser::knows(const base::FolderEntry& entry) const {
  const exchange::TrackFormat* const format = exchange::format_of(entry.name);
  return format != nullptr && (mode_ == Mode::open ? format->parse != nullptr : format->print != nullptr);
}

FileBrowser::Entries FileBrowser::shown_entries() const {
  const std::string wanted = mode_ == Mode::open && !is_path(words_) ? base::lower(words_) : "";
  Entries shown;
  for (const base::FolderEntry& entry : entries_)
    if ((entry.folder || all_ || knows(entry)) && base::lower(entry.name).find(wanted) != std::string::npos)
      shown.push_back(&entry);
  return shown;
}

FileBrowser::Answer FileBrowser::choose_path(std::filesystem::path path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    go(std::move(path));
    return Answer::none;
  }
  if (mode_ == Mode::save && exchange::format_of(path) == nullptr) path += ".json";
  chosen_ = std::move(path);
  return Answer::chosen;
}

// Returns the answer of Enter and of the confirming button.
FileBrowser::Answer FileBrowser::confirm(const Entries& entries) {
  if (mode_ == Mode::open && exchange::is_link(words_)) {
    chosen_ = words_;
    return Answer::chosen;
  }
  const auto at =
      std::find_if(entries.begin(), entries.end(), [&](const base::FolderEntry* e) { return e->name == marked_; });
  if (mode_ == Mode::save) {
    if (by_key_ && at != entries.end() && (*at)->folder) return choose_path(folder_ / (*at)->name);
    return words_.empty() ? Answer::none : choose_path(expanded(words_, folder_));
  }
  if (is_path(words_)) return choose_path(expanded(words_, folder_));
  if (at != entries.end()) return choose_path(folder_ / (*at)->name);
  return entries.size() == 1 || (!words_.empty() && !entries.empty()) ? choose_path(folder_ / entries.front()->name)
                                                                      : Answer::none;
}

void FileBrowser::draw_path(Ui& ui) {
  std::vector<std::filesystem::path> parts;  // the innermost first
  for (std::filesystem::path at = folder_;; at = at.parent_path()) {
    parts.push_back(at);
    if (at == at.root_path() || at.empty()) break;
  }
  const auto name = [](const std::filesystem::path& p) {
    return p.has_filename() ? p.filename().string() : p.string();
  };
  const float gap = std::floor(3 * ui.scale), pads = 2 * ImGui::GetStyle().FramePadding.x,
              room = ImGui::GetContentRegionAvail().x;
  std::size_t count = 0;
  for (float used = 0; count < parts.size(); ++count) {
    used += text_size(name(parts[count])).x + pads + gap;
    if (used > room && count > 0) break;
  }
  std::filesystem::path to;
  for (std::size_t i = count; i-- > 0;) {
    ImGui::PushID(static_cast<int>(i));
    const std::string label = name(parts[i]);
    if (ImGui::Button(label.c_str())) to = parts[i];
    note_item(ui, "Path/" + label, "button", "Show this folder: " + parts[i].string(), true);
    ImGui::PopID();
    if (i > 0) ImGui::SameLine(0, gap);
  }
  if (!to.empty()) go(to);
}

// Draws a row. Returns true if it was double-clicked.
bool FileBrowser::draw_row(Ui& ui, const base::FolderEntry& entry) {
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight(),
              pad = std::floor(6 * ui.scale);
  const bool marked = entry.name == marked_;
  ImGui::PushStyleColor(ImGuiCol_Header, colour(palette().accent, 0.35f));
  const bool pressed =
      ImGui::Selectable(hidden(entry.name).c_str(), marked,
                        ImGuiSelectableFlags_AllowDoubleClick | ImGuiSelectableFlags_DontClosePopups, {width, line});
  ImGui::PopStyleColor();
  note(ui, (entry.folder ? "Folders/" : "Files/") + entry.name, "item", entry.name, true, marked ? "on" : "off", low,
       {low.x + width, low.y + line});
  if (pressed) mark({&entry}, 0), by_key_ = false;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::string time = base::local_time(entry.time), size = entry.folder ? "" : base::size_text(entry.bytes);
  const float time_width = text_size("2026-12-28 20:58").x, size_width = text_size("999 MB").x,
              icon = std::floor(line * 0.9f);
  const float size_right = low.x + width - time_width - 2 * pad, name_right = size_right - size_width - pad;
  if (entry.folder) {
    const ImVec2 at(low.x + pad, std::floor(low.y + line * 0.26f));
    list.AddRectFilled(at, {at.x + icon * 0.45f, at.y + line * 0.2f}, packed(palette().warning), 1);
    list.AddRectFilled({at.x, at.y + line * 0.1f}, {at.x + icon, at.y + line * 0.6f}, packed(palette().warning), 2);
  }
  const float left = low.x + 2 * pad + icon;
  draw_text(list, {left, low.y}, entry.folder || knows(entry) ? palette().text : palette().dim,
            shortened(entry.name, name_right - left));
  draw_text(list, {size_right - text_size(size).x, low.y}, palette().dim, size);
  draw_text(list, {low.x + width - time_width - pad, low.y}, palette().dim, time);
  if (marked && scroll_) ImGui::SetScrollHereY(), scroll_ = false;
  return pressed && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
}

FileBrowser::Answer FileBrowser::draw_list(Ui& ui, const Entries& entries, float height) {
  const base::FolderEntry* twice = nullptr;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, colour(palette().background));
  if (ImGui::BeginChild("##files", {0, sized(height)}, true)) {
    for (std::size_t i = 0; i < std::min(entries.size(), kMostRows); ++i)
      if (draw_row(ui, *entries[i])) twice = entries[i];
    const bool searched = mode_ == Mode::open && !words_.empty();
    const std::string words = !problem_.empty() ? problem_
                              : entries.size() > kMostRows
                                  ? fmt::format("{} more: type part of the name", entries.size() - kMostRows)
                              : entries.empty() ? (searched ? "No matches." : "No folders and no readable files here.")
                                                : "";
    if (!words.empty()) tinted(words, palette().dim);
  }
  ImGui::EndChild();
  ImGui::PopStyleColor();
  return twice != nullptr ? choose_path(folder_ / twice->name) : Answer::none;
}

FileBrowser::Answer FileBrowser::draw_buttons(Ui& ui, const Entries& entries, bool system) {
  Answer answer = Answer::none;
  if (const auto on = checkbox(ui, "Show all files", all_, "Also show hidden files and files of unknown formats."))
    all_ = *on, read_at_ = -1;
  const bool saving = mode_ == Mode::save;
  if (saving && button(ui, "New folder", "Create a folder here.")) answer = Answer::make_folder;
  if (system) {
    if (saving) ImGui::SameLine();
    if (button(ui, "System dialog", "Use the system's file dialog.")) answer = Answer::system;
  }
  const float width = std::floor(110 * ui.scale), gap = ImGui::GetStyle().ItemSpacing.x;
  const float right = ImGui::GetWindowContentRegionMax().x - 2 * width - gap;
  saving || system ? ImGui::SameLine(right) : ImGui::SetCursorPosX(right);
  if (button(ui, "Cancel", "Cancel. Key Escape.", true, width)) answer = Answer::cancel;
  ImGui::SameLine();
  const bool can = saving ? !words_.empty()
                          : !marked_.empty() || is_path(words_) || exchange::is_link(words_) ||
                                (!words_.empty() && !entries.empty());
  if (button(ui, saving ? "Save" : "Open", "Use the selected file or the name above. Key Enter.", can, width))
    answer = confirm(entries);
  return answer;
}

FileBrowser::Answer FileBrowser::build(Ui& ui, const platform::Events& events, bool text_had_keyboard, bool system) {
  refresh(ui.state.seconds);
  draw_path(ui);
  const Entries before = shown_entries();
  const float rows = 3 * ImGui::GetFrameHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  Answer answer =
      draw_list(ui, before, std::max(3 * ImGui::GetTextLineHeight(), ImGui::GetContentRegionAvail().y - rows));
  const bool saving = mode_ == Mode::save;
  const std::string_view label = saving ? "Name" : "Search or path";
  if (auto typed = text(ui, label, words_,
                        saving ? "Name of the file. Its extension selects the format, .json by default."
                               : "Part of a name, a path, or a shared link.",
                        ShownTextEnd::end)) {
    words_ = std::move(*typed);
    untouched_ = by_key_ = false;
    if (!saving) marked_.clear();
  }
  refresh(ui.state.seconds);
  const Entries entries = shown_entries();
  if (const Answer pressed = draw_buttons(ui, entries, system); pressed != Answer::none) answer = pressed;
  if (const Answer keyed = take_keys(events, text_had_keyboard, entries); answer == Answer::none) answer = keyed;
  return answer;
}

using platform::Key;

void FileBrowser::mark(const Entries& entries, std::ptrdiff_t index) {
  if (entries.empty()) return;
  const auto last = static_cast<std::ptrdiff_t>(entries.size()) - 1;
  const base::FolderEntry& entry = *entries[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(index, 0, last))];
  marked_ = entry.name;
  if (mode_ == Mode::save && !entry.folder) words_ = entry.name, untouched_ = true;
}

FileBrowser::Answer FileBrowser::take_key(Key key, const Entries& entries) {
  constexpr std::ptrdiff_t kPage = 10;
  const auto at =
      std::find_if(entries.begin(), entries.end(), [&](const base::FolderEntry* e) { return e->name == marked_; }) -
      entries.begin();
  const auto count = static_cast<std::ptrdiff_t>(entries.size());
  const auto to = [&](std::ptrdiff_t index) {
    mark(entries, index);
    by_key_ = scroll_ = true;
  };
  switch (key) {
    case Key::escape: return Answer::cancel;
    case Key::enter:
    case Key::keypad_enter: return confirm(entries);
    case Key::down: to(at == count ? 0 : at + 1); break;
    case Key::up: to(at == count ? count - 1 : at - 1); break;
    case Key::page_down: to(at == count ? 0 : at + kPage); break;
    case Key::page_up: to(at - kPage); break;
    case Key::home: to(0); break;
    case Key::end: to(count - 1); break;
    case Key::backspace:
      if (words_.empty() || (mode_ == Mode::save && untouched_)) up();
      else words_.resize(base::utf8_start(words_, words_.size() - 1).size());
      break;
    default: break;
  }
  return Answer::none;
}

void FileBrowser::take_text(const std::string& utf8) {
  if (mode_ == Mode::save && std::exchange(untouched_, false)) words_.clear();
  words_ += utf8;
  by_key_ = false;
  if (mode_ == Mode::open) marked_.clear();
}

// While a field has the keyboard, the browser handles only Enter: the field has taken its text by then.
FileBrowser::Answer FileBrowser::take_keys(const platform::Events& events, bool text_had_keyboard,
                                           const Entries& entries) {
  for (const platform::Event& event : events) {
    if (const auto* text = std::get_if<platform::TextInput>(&event); text != nullptr && !text_had_keyboard)
      take_text(text->utf8);
    const auto* press = std::get_if<platform::KeyPress>(&event);
    if (press == nullptr || !press->down || press->modifiers.ctrl || press->modifiers.alt) continue;
    const bool enter = press->key == Key::enter || press->key == Key::keypad_enter;
    if (text_had_keyboard && !enter) continue;
    if (enter && !text_had_keyboard && press->repeat) continue;
    if (const Answer answer = take_key(press->key, enter ? shown_entries() : entries); answer != Answer::none)
      return answer;
  }
  return Answer::none;
}

}  // namespace coaster::ui
