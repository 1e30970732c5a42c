// The keyboard of the file browser.
#include <algorithm>
#include <utility>
#include <variant>

#include "base/text.h"
#include "ui/screens/file_browser.h"

namespace coaster::ui {
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
