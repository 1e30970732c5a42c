// Thin wrappers over Dear ImGui's widgets. Each lays out a row (label left, control right; label above where both do
// not fit), shows a tooltip, and registers itself under "Panel/Label" so that scripts find it. None changes state: they
// return what the user wants.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/host/host.h"

struct ImGuiWindow;

namespace coaster::ui {

// The widgets of a frame, in drawing order.
class WidgetList {
 public:
  void clear();
  // A widget over [low, high) of the window being built; whether it can be seen follows from the window's clip
  // rectangle.
  void add(std::string path, std::string_view kind, glm::vec2 low, glm::vec2 high, bool enabled, std::string value);
  // After ImGui::Render(): finds the covered ones.
  void finish();
  const std::vector<Widget>& widgets() const { return widgets_; }

 private:
  std::vector<Widget> widgets_;
  std::vector<const ImGuiWindow*> windows_;
};

// The one text that is being typed.
struct Entry {
  unsigned id = 0;
  std::array<char, 1024> text{}, initial{};
};

// The one numeric drag that is under way: its moves are one step of undo. Begun with its first change.
struct Gesture {
  unsigned id = 0;
  bool open = false;
};

// How long the mouse has rested on the same widget.
struct Rest {
  std::string path, next;
  float seconds = 0;
};

struct Toasts;
struct LabCache;
class Dialogs;
class StartScreen;
class KeyMap;

// What a panel works with during one build.
struct Ui {
  const State& state;
  Output& out;
  WidgetList& list;
  Entry& entry;
  Gesture& gesture;
  Rest& rest;
  Toasts& toasts;
  LabCache& lab;
  std::string& file;  // the path in Track/File
  double& radius;     // the number in Shape/Radius, m
  Dialogs& dialogs;
  StartScreen& start;
  const KeyMap& keys;
  std::string_view renderer;  // GL_RENDERER
  float scale = 1;
  std::string panel;  // first part of the paths

  const edit::Session& session() const { return state.session; }
  const edit::Findings& find(edit::Want wanted) const { return state.find(wanted); }
  template <class C>
  void emit(C command) {
    out.commands.push_back(edit::Command(std::move(command)));
  }
};

glm::vec2 mouse_position();  // px

// Registers the last item of ImGui and shows its tooltip when the mouse rests on it.
void note_item(Ui& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
               std::string value = {});

// True while open; `open`: at first.
bool header(Ui& ui, std::string_view name, std::string_view tooltip, bool open = true);
void heading(Ui& ui, std::string_view text, std::string_view tooltip);
bool button(Ui& ui, std::string_view label, std::string_view tooltip, bool enabled = true, float width = 0);
bool radio(Ui& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled = true);
// Whether a radio button or checkbox with this label fits beside the last one, from the row's middle on; moves there
// when it does.
bool beside_last(Ui& ui, std::string_view label);
std::optional<bool> checkbox(Ui& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled = true);

struct Choice {
  std::string label, tooltip;
};
std::optional<int> combo(Ui& ui, std::string_view label, std::span<const Choice> choices, int current,
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
std::optional<E> combo_of(Ui& ui, std::string_view label, E current, std::string_view tooltip) {
  const auto chosen = combo(ui, label, choices_of<E>(), static_cast<int>(current), tooltip);
  if (!chosen) return std::nullopt;
  return static_cast<E>(*chosen);
}

struct Number {
  double value = 0;
  const char* unit = "";
  int decimals = 2;
  double step = 0.05;        // per pixel of a drag
  double low = 0, high = 0;  // of drags; what is typed goes out as it is, for the command to clamp (low == high: none)
  double largest = 3.4028234663852886e38;  // typed numbers beyond it become it: the command's clamp then says "limit"
};
// A field to drag, or to click and type in. Returns a new value: during a drag inside a gesture, or once when typed.
std::optional<double> number(Ui& ui, std::string_view label, const Number& number, std::string_view tooltip,
                             bool enabled = true);
// Fields in a row without labels of their own, "Group/name": x, y, z. Returns the changed one.
struct Changed {
  int index;
  double value;
};
std::optional<Changed> numbers(Ui& ui, std::string_view group, std::span<const std::string_view> names,
                               std::span<const Number> values, std::string_view tooltip);
// A whole number on a (logarithmic) bar; Ctrl+click or a double click types it.
std::optional<int> slider(Ui& ui, std::string_view label, int value, int low, int high, bool logarithmic,
                          std::string_view tooltip);
// The same for a real number, shown with and rounded to `decimals`.
std::optional<double> real_slider(Ui& ui, std::string_view label, double value, double low, double high, int decimals,
                                  std::string_view tooltip);
// A line of text; returns it when Enter is pressed or the field is left changed.
std::optional<std::string> text(Ui& ui, std::string_view label, const std::string& value, std::string_view tooltip);

// Label left, value with its unit right; in the colour of warnings where it `warns`.
void read_out(Ui& ui, std::string_view label, std::string_view value, std::string_view unit, std::string_view tooltip,
              bool warns = false);
// The same for a query's value, with `decimals`; "--" where it has none or (times) where a script runs. `factor`
// converts units.
struct Shown {
  int decimals = 2;
  const char* unit = nullptr;  // null: the query's
  double factor = 1;
  bool is_time = false;
  bool warns = false;
};
void read_query(Ui& ui, std::string_view label, std::string_view query, std::string_view argument,
                std::string_view tooltip, Shown shown = {});

// The value of a query, or nothing.
std::optional<query::Value> value_of(const Ui& ui, std::string_view query, std::string_view argument = {});
// "12345.60", without a "-" before zero.
std::string fixed(double value, int decimals);

}  // namespace coaster::ui
