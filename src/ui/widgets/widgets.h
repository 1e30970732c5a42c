// Thin wrappers over Dear ImGui's widgets. Each lays out a row (label left, control right; label above if both do not
// fit), shows a tooltip, and registers itself under "Panel/Label" for scripts; labels may be "Shown###Id"
// (WidgetList). They return the user's input and change no state.
#pragma once

#include <imgui.h>

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/enum_names.h"
#include "base/units.h"
#include "platform/events.h"
#include "query/widget.h"

struct ImGuiWindow;

namespace coaster::ui {

// Returns the visible part of a label: a label "Shown###Id" shows its first part and has the second as id; others are
// their own id.
std::string_view shown(std::string_view label);
std::string_view id_of(std::string_view label);

using query::Widget;

// The widgets of a frame, in drawing order.
class WidgetList {
 public:
  void clear();
  // Adds a widget over [low, high) of the window being built; `path` is made of labels. The window's clip rectangle
  // decides whether it is visible.
  void add(std::string_view path, std::string_view kind, glm::vec2 low, glm::vec2 high, bool enabled,
           std::string value);
  // Of the widget added last: its label does not fit.
  void mark_cut() { widgets_.back().cut = true; }
  // After ImGui::Render(): finds the covered ones.
  void finish();
  const std::vector<Widget>& widgets() const { return widgets_; }

 private:
  std::vector<Widget> widgets_;
  std::vector<const ImGuiWindow*> windows_;
};

// The text being typed.
struct Entry {
  unsigned id = 0;
  std::array<char, 1024> text{}, initial{};
};

// The current drag of a number: one undo step, which begins with its first change.
struct NumberDrag {
  unsigned id = 0;
  bool open = false;
};

// Time for which the mouse has rested on the same widget.
struct HoverTime {
  std::string path, next;
  float seconds = 0;
  // At the end of a frame. A press or a key ends the tooltip until the mouse has left the widget.
  void step(const platform::Events& events, float dt);
};

// A request that a number field takes the keyboard without the mouse.
struct FieldFocusRequest {
  std::string panel;  // of its first field that is drawn next; empty: none
  unsigned id = 0;    // id of that field
  int frames = 0;     // frames left to take the keyboard
};

// The context of widgets during one build.
struct WidgetFrame {
  WidgetList& list;
  Entry& entry;
  NumberDrag& gesture;
  HoverTime& rest;
  const std::function<void()>& begin_gesture;                // called before the first change of a drag
  const std::function<void(const std::string& text)>& warn;  // shows a notice about rejected input
  float scale = 1;                                           // px per design px
  std::string panel;                                         // first part of the paths
  base::UnitSystem units = base::UnitSystem::m_s;            // units of displayed values and words
  FieldFocusRequest* wish = nullptr;                         // null: fields take only the mouse
  std::string locked = {};                                   // why widgets are disabled now; empty: they are not
};

// Widgets get metric values and words, and show them in the user's units (base/units.h): the numbers and units of
// read-outs, fields and plots, and the lengths and speeds in headings, paragraphs and tooltips. Typed and dragged
// values are returned as metric. Text that a caller draws itself must pass through one of these: the number, the number
// with its unit, words.
std::string digits(const WidgetFrame& ui, double value, int decimals, std::string_view metric);
std::string measured(const WidgetFrame& ui, double value, int decimals, std::string_view metric);
std::string in_units(const WidgetFrame& ui, std::string_view words);

// Returns a length or size, px, that Dear ImGui accepts whatever the window's size: 1 to 32,768, for NaN 1. All lengths
// that are computed pass through it: Dear ImGui ends the program over a button of 0 px and takes 0 and less for other
// things.
float sized(float length);
ImVec2 sized(ImVec2 size);

glm::vec2 mouse_position();                  // px
bool mouse_over(ImVec2 low, ImVec2 high);    // of the current window, also while one of its items is held down
std::string hidden(std::string_view label);  // "##label": an id without a visible label
ImVec2 text_size(std::string_view text);
// Returns the text if it fits into `room` px of the current font, else its start with "\u2026" behind it, or its end
// with "\u2026" before it. Empty if not even one character fits.
std::string shortened(std::string_view text, float room, bool keep_end = false);
// Draw text with its top left at `at`, in the normal and in the small font.
void draw_text(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text);
void draw_small(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text);
ImVec2 small_size(std::string_view text);
// Draws a label at the left of a rectangle and its value at the right, and registers them.
void labelled_value(WidgetFrame& ui, std::string_view label, std::string_view value, std::string_view tooltip,
                    ImVec2 low, ImVec2 high);
// Draws the mark of a part that folds: a triangle about `middle` that points down or up.
void draw_fold_mark(ImDrawList& list, ImVec2 middle, float scale, bool down);

// Registers a rectangle of the current window as a widget and shows its tooltip while the mouse rests on it. The second
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
// The same in a bar: right after the label, with the rest of the room.
void begin_in_bar(std::string_view label);

// A window over the scene that cannot be moved, as high as its content; `panel` names its widgets.
struct Card {
  const char* id;
  std::string_view panel;
  ImVec2 at, pivot = {0, 0};  // px; the part of the window at that position: {0.5f, 0} is the middle of its upper edge
  float width = 0;            // px
  ImVec2 padding = {12, 10};  // design px
  float alpha = 1;
  ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoFocusOnAppearing;
};
// Returns its height, px.
float build_card(WidgetFrame& ui, const Card& card, const std::function<void()>& content);

// Shows a button that folds what it is the header of: ui.panel, or a part of it. The mark has the name behind it, if
// any. `lit`: it is highlighted while that is open, like a tab. Returns true if pressed.
bool fold(WidgetFrame& ui, std::string_view name, bool open, std::string_view tooltip, ImVec2 size, bool lit = false);
struct TabBar {
  float height, pad;  // px; `pad` on both sides of a label
  std::uint32_t rgb;  // of the line at the selected tab
  ImFont* font = ImGui::GetFont();
  bool line_above = false;
  float least_line = 2;  // px; its least height
};
// Shows a tab in a bar at the top of the window, and lets the next item follow beside it. Its label is the last part of
// the path. Returns true if pressed.
bool tab(WidgetFrame& ui, std::string_view path, std::string_view tooltip, bool selected, const TabBar& bar);
void heading(WidgetFrame& ui, std::string_view label, std::string_view tooltip);
// Draw text of a colour 0xRRGGBB: one line, wrapped, or wrapped and registered.
void tinted_line(std::string_view words, std::uint32_t rgb);
void tinted(std::string_view words, std::uint32_t rgb);
void paragraph(WidgetFrame& ui, std::string_view label, std::string_view words, std::uint32_t rgb);
bool button(WidgetFrame& ui, std::string_view label, std::string_view tooltip, bool enabled = true, float width = 0);
// One as wide as the room.
bool wide_button(WidgetFrame& ui, std::string_view label, std::string_view tooltip, bool enabled = true);
bool radio(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled = true);
// If a radio button or checkbox with this label fits next to the last one, in the right half of the row, moves there
// and returns true.
bool beside_last(WidgetFrame& ui, std::string_view label);
std::optional<bool> checkbox(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip,
                             bool enabled = true);

struct Choice {
  std::string label, tooltip;
};
// Where a list is: beside its label, or below it if its widest choice does not fit there; beside it in any case, which
// may cut a choice; or as begin_in_bar() says.
enum class ComboPlace { fitting, beside, in_bar };
std::optional<int> combo(WidgetFrame& ui, std::string_view label, std::span<const Choice> choices, int current,
                         std::string_view tooltip, ComboPlace place = ComboPlace::fitting);

// Returns the labels and help of rows, such as an enumeration's.
template <class Rows>
std::vector<Choice> choices_in(const Rows& rows) {
  std::vector<Choice> choices;
  for (const auto& row : rows) {
    if constexpr (requires { row.formula; }) choices.push_back({std::string(row.label), std::string(row.formula)});
    else choices.push_back({std::string(row.label), std::string(row.help)});
  }
  return choices;
}
template <base::Named E>
std::vector<Choice> choices_of() {
  return choices_in(rows_of(E{}));
}
template <base::Named E>
std::optional<E> combo_of(WidgetFrame& ui, std::string_view label, E current, std::string_view tooltip,
                          ComboPlace place = ComboPlace::fitting) {
  const auto chosen = combo(ui, label, choices_of<E>(), static_cast<int>(current), tooltip, place);
  return chosen ? std::optional(static_cast<E>(*chosen)) : std::nullopt;
}
// The same for a value that may be none of these: then `other` is chosen.
template <base::Named E>
std::optional<E> combo_of(WidgetFrame& ui, std::string_view label, std::optional<E> current, const Choice& other,
                          std::string_view tooltip) {
  std::vector<Choice> choices = choices_of<E>();
  if (!current) choices.push_back(other);
  const std::size_t now = current ? static_cast<std::size_t>(*current) : choices.size() - 1;
  const auto chosen = combo(ui, label, choices, static_cast<int>(now), tooltip);
  return chosen ? std::optional(static_cast<E>(*chosen)) : std::nullopt;
}

struct Number {
  double value = 0;
  const char* unit = "";  // metric
  int decimals = 2;
  double step = 0.05;  // change per pixel of a drag
  double low = 0,
         high = 0;  // limits of drags; typed numbers are not limited: the command clamps them (low == high: none)
  double largest = 3.4028234663852886e38;  // larger typed numbers become this; the command's clamp then says "limit"
  bool whole = false;                      // typed numbers must be whole
  const char* typed_in = unit;             // unit of typed numbers; not shown in a narrow field
};
// Returns a whole number with the limits of its drags.
constexpr Number whole_number(double value, double low, double high, double largest = 1e9, double step = 0.05) {
  return {.value = value, .decimals = 0, .step = step, .low = low, .high = high, .largest = largest, .whole = true};
}
// Shows a number field: drag it, or click and type a number, arithmetic or another unit (base/units.h); anything
// else is rejected with a notice. Returns the new value during a drag (within a gesture) or when typed.
std::optional<double> number(WidgetFrame& ui, std::string_view label, const Number& number, std::string_view tooltip,
                             bool enabled = true);
struct TypedNumber {
  std::optional<double> value;  // the typed number, when it is complete
  bool open = false;            // the field has the keyboard, or gets it in one of the next frames
};
// Shows a number field at the cursor, as wide as the available space and a line high, without a label. It takes the
// keyboard when the frame's wish names the panel.
TypedNumber cell_number(WidgetFrame& ui, std::string_view label, const Number& number, std::string_view tooltip);
struct ChangedNumber {
  int index;
  double value;
};
// Shows number fields in one row, "Group/name", without labels. Returns the changed one.
std::optional<ChangedNumber> numbers(WidgetFrame& ui, std::string_view group, std::span<const std::string_view> names,
                                     std::span<const Number> values, std::string_view tooltip);
// Shows an integer slider, linear or logarithmic. Ctrl+click or double-click to type.
std::optional<int> slider(WidgetFrame& ui, std::string_view label, int value, int low, int high, bool logarithmic,
                          std::string_view tooltip);
// Shows a slider for a real number, displayed with and rounded to `decimals`.
std::optional<double> real_slider(WidgetFrame& ui, std::string_view label, double value, double low, double high,
                                  int decimals, std::string_view tooltip, const char* unit = "");
// Shows a colour (0xRRGGBB) as hexadecimal digits, to type or drag, and a swatch that opens a picker. Returns the new
// colour with every change, within a gesture.
std::optional<std::int32_t> colour_field(WidgetFrame& ui, std::string_view label, std::int32_t rgb,
                                         std::string_view tooltip);
// What a text field shows of a text that is too long while it is not edited: of a path its end. The tooltip has it all.
enum class ShownTextEnd { start, end };
// Shows a text field. Returns the text on Enter, or when it loses focus with the text changed.
std::optional<std::string> text(WidgetFrame& ui, std::string_view label, const std::string& value,
                                std::string_view tooltip, ShownTextEnd shows = ShownTextEnd::start);

// Shows a label on the left, value and unit on the right, in the warning colour if it `warns`, or red. Text is shown
// unchanged, a number in the user's units, kNoNumber as "--".
inline constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
void read_out(WidgetFrame& ui, std::string_view label, double value, int decimals, std::string_view metric,
              std::string_view tooltip, bool warns = false);
void read_out(WidgetFrame& ui, std::string_view label, std::string_view value, std::string_view unit,
              std::string_view tooltip, bool warns = false, bool red = false);
// Returns "12345.60", without a "-" before zero; "--" for NaN.
std::string fixed(double value, int decimals);

struct ButtonRows {
  WidgetFrame& ui;
  int columns;              // buttons in a row, or fewer where the widest label does not fit
  std::string_view widest;  // label
  int placed = 0;
  float width = 0;  // px, of a button; set with the first one

  // Adds a button; returns whether it is pressed.
  bool operator()(std::string_view label, std::string_view tooltip, bool enabled = true);
};

}  // namespace coaster::ui
