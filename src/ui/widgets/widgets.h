// Thin wrappers over Dear ImGui's widgets. Each lays out a row (label left, control right; label above if both do not
// fit), shows a tooltip, and registers itself under "Panel/Label" for scripts. They return the user's input and change
// no state.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/names.h"
#include "base/units.h"
#include "platform/events.h"
#include "ui/widgets/widget_list.h"

namespace coaster::ui {

// The text being typed.
struct Entry {
  unsigned id = 0;
  std::array<char, 1024> text{}, initial{};
};

// The current drag of a number: one undo step, which begins with its first change.
struct Gesture {
  unsigned id = 0;
  bool open = false;
};

// How long the mouse has rested on the same widget.
struct Rest {
  std::string path, next;
  float seconds = 0;
  // At the end of a frame. A press or a key ends the tooltip until the mouse has left the widget.
  void step(const platform::Events& events, float dt);
};

// A number field that is to take the keyboard without the mouse.
struct FieldWish {
  std::string panel;  // the next field that is drawn in it; empty: none
  unsigned id = 0;    // the field that was found
  int frames = 0;     // that it has left to take the keyboard
};

// What widgets work with during one build.
struct WidgetFrame {
  WidgetList& list;
  Entry& entry;
  Gesture& gesture;
  Rest& rest;
  const std::function<void()>& begin_gesture;                // called before the first change of a drag
  const std::function<void(const std::string& text)>& warn;  // shows a notice about input that changes nothing
  float scale = 1;                                           // px a design px
  std::string panel;                                         // first part of the paths
  base::Units units = base::Units::m_s;                      // that values and words are shown in
  FieldWish* wish = nullptr;                                 // null: fields take the mouse alone
};

// Widgets get metric values and words, and show them in the user's units (base/units.h): the numbers and units of
// read-outs, fields and plots, and the lengths and speeds in headings, paragraphs and tooltips. What is typed or
// dragged comes back metric. Text that a caller draws goes through one of these: the number, the number with its unit,
// words.
std::string digits(const WidgetFrame& ui, double value, int decimals, std::string_view metric);
std::string measured(const WidgetFrame& ui, double value, int decimals, std::string_view metric);
std::string in_units(const WidgetFrame& ui, std::string_view words);

glm::vec2 mouse_position();                  // px
std::string hidden(std::string_view label);  // "##label": an id without a drawn label
ImVec2 text_size(std::string_view text);
// Text with its top left at `at`, and the same in the small font.
void draw_text(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text);
void draw_small(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text);
ImVec2 small_size(std::string_view text);
// The mark of what opens and folds: a triangle about `middle` that points down or up.
void draw_fold_mark(ImDrawList& list, ImVec2 middle, float scale, bool down);

// Registers a rectangle of the current window as a widget and shows its tooltip while the mouse rests on it; the second
// one registers ImGui's last item.
void note(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
          std::string value, ImVec2 low, ImVec2 high);
void note_item(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
               std::string value = {});
// Of a button just registered, ImGui's last item: marks it as cut if it is too narrow for its label.
void note_if_cut(WidgetFrame& ui, std::string_view label);
// Draws the label and sets the next item's place and width: beside the label, or below it when the label is long for
// the row or the control needs more than the `needed` px that are left there.
void begin_row(std::string_view label, float needed = 0);

// Begins a window that cannot be moved and stays behind others; ImGui::End() ends it.
bool begin_area(const char* id, ImVec2 at, ImVec2 size, ImGuiWindowFlags more = ImGuiWindowFlags_NoScrollbar);

// A window over the scene that cannot be moved, as high as its content; `panel` names its widgets.
struct Card {
  const char* id;
  std::string_view panel;
  ImVec2 at, pivot = {0, 0};  // px; which part of the window is there: {0.5f, 0} is the middle of its upper edge
  float width = 0;            // px
  ImVec2 padding = {12, 10};  // design px
  float alpha = 1;
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoFocusOnAppearing;
};
void build_card(WidgetFrame& ui, const Card& card, const std::function<void()>& content);

// Labels may be "Shown###Id" (widget_list.h).
// True while open; `open`: at first.
bool header(WidgetFrame& ui, std::string_view name, std::string_view tooltip, bool open = true, bool open_now = false);
void heading(WidgetFrame& ui, std::string_view label, std::string_view tooltip);
// Text of a colour 0xRRGGBB: one line, wrapped, or wrapped and registered.
void tinted_line(std::string_view words, std::uint32_t rgb);
void tinted(std::string_view words, std::uint32_t rgb);
void paragraph(WidgetFrame& ui, std::string_view label, std::string_view words, std::uint32_t rgb);
bool button(WidgetFrame& ui, std::string_view label, std::string_view tooltip, bool enabled = true, float width = 0);
bool radio(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled = true);
// Returns whether a radio button or checkbox with this label fits beside the last one, in the right half of the row,
// and if so moves there.
bool beside_last(WidgetFrame& ui, std::string_view label);
std::optional<bool> checkbox(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip,
                             bool enabled = true);

struct Choice {
  std::string label, tooltip;
};
std::optional<int> combo(WidgetFrame& ui, std::string_view label, std::span<const Choice> choices, int current,
                         std::string_view tooltip,
                         bool may_cut = false);  // may_cut: beside its label even where the widest choice is cut

// The labels and help of an enumeration's rows.
template <base::Named E>
std::vector<Choice> choices_of() {
  std::vector<Choice> choices;
  for (const auto& row : rows_of(E{})) {
    if constexpr (requires { row.formula; }) choices.push_back({std::string(row.label), std::string(row.formula)});
    else choices.push_back({std::string(row.label), std::string(row.help)});
  }
  return choices;
}
template <base::Named E>
std::optional<E> combo_of(WidgetFrame& ui, std::string_view label, E current, std::string_view tooltip,
                          bool may_cut = false) {
  const auto chosen = combo(ui, label, choices_of<E>(), static_cast<int>(current), tooltip, may_cut);
  if (!chosen) return std::nullopt;
  return static_cast<E>(*chosen);
}

struct Number {
  double value = 0;
  const char* unit = "";  // metric
  int decimals = 2;
  double step = 0.05;        // per pixel of a drag
  double low = 0, high = 0;  // of drags; what is typed goes out as it is, for the command to clamp (low == high: none)
  double largest = 3.4028234663852886e38;  // typed numbers beyond it become it: the command's clamp then says "limit"
  bool whole = false;                      // typed numbers must be whole
  const char* typed_in = unit;             // the unit of typed numbers; beside a narrow field it is not shown
};
// A number field: drag it, or click and type a number, arithmetic or another unit (base/arithmetic.h); anything else is
// refused with a notice and changes nothing. Returns a new value during a drag (within a gesture) or when typed.
std::optional<double> number(WidgetFrame& ui, std::string_view label, const Number& number, std::string_view tooltip,
                             bool enabled = true);
// A number to type at the cursor, as wide as there is room and a line high, without a label. It takes the keyboard when
// the frame's wish names the panel.
struct TypedNumber {
  std::optional<double> value;  // when it is typed
  bool open = false;            // it has the keyboard, or gets it with one of the next frames
};
TypedNumber cell_number(WidgetFrame& ui, std::string_view label, const Number& number, std::string_view tooltip);
// Number fields in one row, "Group/name", without labels. Returns the changed one.
struct Changed {
  int index;
  double value;
};
std::optional<Changed> numbers(WidgetFrame& ui, std::string_view group, std::span<const std::string_view> names,
                               std::span<const Number> values, std::string_view tooltip);
// An integer slider, linear or logarithmic. Ctrl+click or double-click to type.
std::optional<int> slider(WidgetFrame& ui, std::string_view label, int value, int low, int high, bool logarithmic,
                          std::string_view tooltip);
// The same for a real number, shown with and rounded to `decimals`.
std::optional<double> real_slider(WidgetFrame& ui, std::string_view label, double value, double low, double high,
                                  int decimals, std::string_view tooltip, bool logarithmic = false,
                                  const char* unit = "");
// A text field. Returns the text on Enter, or when it loses focus changed.
std::optional<std::string> text(WidgetFrame& ui, std::string_view label, const std::string& value,
                                std::string_view tooltip);

// Label left, value and unit right, in the warning colour if it `warns`. Text is shown as it is, a number in the user's
// units.
void read_out(WidgetFrame& ui, std::string_view label, double value, int decimals, std::string_view metric,
              std::string_view tooltip, bool warns = false);
void read_out(WidgetFrame& ui, std::string_view label, std::string_view value, std::string_view unit,
              std::string_view tooltip, bool warns = false);
// "12345.60", without a "-" before zero.
std::string fixed(double value, int decimals);

}  // namespace coaster::ui
