// Editable fields: numbers, sliders, text. A typed number is returned once, when it is complete, and is never inf or
// NaN.

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/text.h"
#include "base/units.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace coaster::ui {
namespace {

enum class Typing { no, open, complete };

// Shows an InputText whose text is in ui.entry during editing. With `begin` it takes the keyboard at once, as if
// clicked. Editing completes on Enter, or when it loses focus with the text changed; Tab moves to the panel's next
// number. Escape discards the text.
Typing typed(WidgetFrame& ui, const char* key, const std::string& initial, bool begin) {
  const ImGuiID id = ImGui::GetID(key);
  Entry& entry = ui.entry;
  const bool mine = entry.id == id;
  std::array<char, 1024> shown;
  if (!mine) shown[initial.copy(shown.data(), shown.size() - 1)] = 0;
  std::array<char, 1024>& buffer = mine ? entry.text : shown;
  ImGuiIO& io = ImGui::GetIO();
  const bool clicked = io.MouseClicked[0];
  // ImGui gives the keyboard to a field that is clicked; SetKeyboardFocusHere takes some frames.
  io.MouseClicked[0] = clicked || begin;
  const bool enter = ImGui::InputText(key, buffer.data(), buffer.size(),
                                      ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  io.MouseClicked[0] = clicked;
  const bool active = ImGui::IsItemActive();
  if (!mine) {
    if (!active) return Typing::no;
    entry.id = id;
    entry.text = entry.initial = shown;
    return Typing::open;
  }
  const bool elsewhere = active && !ImGui::IsItemHovered() && (clicked || io.MouseClicked[1] || io.MouseClicked[2]);
  const bool tab = active && ImGui::IsKeyPressed(ImGuiKey_Tab);
  if (active && !enter && !elsewhere && !tab) return Typing::open;
  if (elsewhere || tab) ImGui::ClearActiveID();
  if (tab && ui.wish) ui.wish->panel = ui.panel;
  entry.id = 0;
  const bool escaped = ImGui::IsKeyPressed(ImGuiKey_Escape);
  return !escaped && entry.text != entry.initial ? Typing::complete : Typing::no;
}

// True if a wish opens the field for editing: it has the keyboard, or gets it in the next frame.
bool is_wished(WidgetFrame& ui, ImGuiID id, bool enabled) {
  constexpr int kFrames = 3;
  if (!ui.wish || !enabled) return false;
  FieldFocusRequest& wish = *ui.wish;
  if (!wish.panel.empty() && wish.panel == ui.panel) {
    wish = {"", id, kFrames};
    ImGuiContext& g = *ImGui::GetCurrentContext();
    g.NavNextActivateId = id;  // takes effect with the next frame
    g.NavNextActivateFlags = ImGuiActivateFlags_PreferInput;
    ImGui::SetScrollHereY(0.5f);
  }
  if (wish.id != id) return false;
  if (ui.entry.id == id || --wish.frames < 0) wish.id = 0;
  return wish.id == id;
}

// Returns the typed number, clamped to +-`largest`. If it is not a number, warns with the reason and returns nothing.
std::optional<double> parse(WidgetFrame& ui, std::string_view label, const Number& n) {
  const char* const words = ui.entry.text.data();
  const base::Result<double> value = base::evaluate(words, n.typed_in);
  const bool whole = !n.whole || !value || *value == std::round(*value);
  if (value && whole) return std::clamp(*value, -n.largest, n.largest);
  const std::string typed = base::quoted_start(words), reason = whole ? value.status().message : base::to_text(*value);
  const bool says_more = reason != fmt::format("expected a number, found {}", typed);
  ui.warn(fmt::format("{}/{}: {} is not a {}number{}. Nothing changed.", ui.panel, shown(label), typed,
                      whole ? "" : "whole ", says_more ? ": " + reason : ""));
  return std::nullopt;
}

// A number field in the user's units.
struct ShownNumber {
  Number shown;
  base::ShownUnit unit;
};
ShownNumber in_users_units(const WidgetFrame& ui, const Number& metric) {
  const base::ShownUnit unit = base::shown_in(ui.units, metric.typed_in);
  Number n = metric;
  for (double* const value : {&n.value, &n.step, &n.low, &n.high, &n.largest}) *value *= unit.factor;
  n.decimals += unit.more_decimals;
  n.typed_in = unit.name.data();
  if (metric.unit[0] != 0) n.unit = n.typed_in;
  return {n, unit};
}

std::optional<double> in_metric(std::optional<double> shown, const base::ShownUnit& unit, const Number& metric) {
  if (!shown) return std::nullopt;
  return std::clamp(base::metric_value(*shown, unit), -metric.largest, metric.largest);
}

// Returns true if the mouse opens a field for typing: Ctrl+click or double-click; with `plain_click` also the release
// of a click.
bool wants_typing(ImGuiID id, ImVec2 low, ImVec2 high, bool plain_click) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool over = mouse_over(low, high);
  if (over && io.MouseClicked[0] && (io.KeyCtrl || io.MouseDoubleClicked[0])) return true;
  return plain_click && over && io.MouseReleased[0] && ImGui::GetActiveID() == id &&
         io.MouseDragMaxDistanceSqr[0] < io.MouseDragThreshold * io.MouseDragThreshold;
}

// Draws the text of a field, right-aligned over it, with unit and small name dimmed.
void draw_number(const WidgetFrame& ui, const Number& n, std::string_view name, std::uint32_t name_colour, ImVec2 low,
                 ImVec2 high, bool enabled) {
  const float pad = std::floor(6 * ui.scale), gap = std::floor(4 * ui.scale), alpha = enabled ? 1.0f : 0.45f;
  const float top = std::floor((low.y + high.y - ImGui::GetTextLineHeight()) * 0.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, high, true);
  float left = low.x + pad, right = high.x - pad;
  if (!name.empty()) {
    list.AddText({left, top}, packed(ink(name_colour), alpha), name.data(), name.data() + name.size());
    left += text_size(name).x + gap;
  }
  std::string digits = fixed(n.value, n.decimals);
  const std::string_view unit = n.unit;
  if (!unit.empty() && right - left > text_size(digits).x + gap + text_size(unit).x) {
    right -= text_size(unit).x;
    list.AddText({right, top}, packed(palette().dim, alpha), unit.data(), unit.data() + unit.size());
    right -= gap;
  }
  // A narrow field shows fewer decimals rather than a cut number.
  for (int decimals = n.decimals; decimals > 0 && text_size(digits).x > right - left;)
    digits = fixed(n.value, --decimals);
  list.AddText({std::floor(right - text_size(digits).x), top}, packed(palette().text, alpha), digits.data(),
               digits.data() + digits.size());
  list.PopClipRect();
}

void begin_gesture(WidgetFrame& ui, ImGuiID id) {
  if (ui.gesture.open) return;
  ui.gesture = {id, true};
  ui.begin_gesture();
}

std::optional<double> drag(WidgetFrame& ui, const Number& n, ImGuiID id) {
  double value = n.value;
  const bool bounded = n.low < n.high;
  const std::string format = fmt::format("%.{}f", n.decimals);
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));  // draw_number() shows it
  const bool changed = ImGui::DragScalar("##drag", ImGuiDataType_Double, &value, static_cast<float>(n.step),
                                         bounded ? &n.low : nullptr, bounded ? &n.high : nullptr, format.c_str(),
                                         ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp);
  ImGui::PopStyleColor();
  if (!changed || !std::isfinite(value)) return std::nullopt;
  begin_gesture(ui, id);
  return value;
}

// Shows one field at the cursor, `width` px wide.
std::optional<double> field(WidgetFrame& ui, std::string_view label, const Number& metric, std::string_view name,
                            std::uint32_t name_colour, float width, std::string_view tooltip, bool enabled) {
  enabled = enabled && ui.locked.empty();
  const auto [n, unit] = in_users_units(ui, metric);
  ImGui::PushID(label.data(), label.data() + label.size());
  ImGui::BeginDisabled(!enabled);
  const ImGuiID drag_id = ImGui::GetID("##drag");
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + width, low.y + ImGui::GetFrameHeight());
  const bool begin = enabled && ui.entry.id != ImGui::GetID("##type") && wants_typing(drag_id, low, high, true);
  std::optional<double> result;
  if (begin) ImGui::ClearActiveID();
  ImGui::SetNextItemWidth(sized(width));
  const bool wished = is_wished(ui, ImGui::GetID("##type"), enabled);
  if (begin || wished || ui.entry.id == ImGui::GetID("##type")) {
    const std::string initial = unit.factor == 1 ? base::to_text(n.value) : fmt::format("{:.9g}", n.value);
    if (typed(ui, "##type", initial, begin) == Typing::complete) result = parse(ui, label, n);
  } else {
    result = drag(ui, n, drag_id);
    draw_number(ui, n, name, name_colour, low, high, enabled);
  }
  ImGui::EndDisabled();
  ImGui::PopID();
  note(ui, label, "number", tooltip, enabled, fixed(n.value, n.decimals), low, high);
  return in_metric(result, unit, metric);
}

// Shows a slider from `n.low` to `n.high`.
std::optional<double> slide(WidgetFrame& ui, std::string_view label, const Number& metric, std::string_view tooltip,
                            bool logarithmic) {
  const auto [n, unit] = in_users_units(ui, metric);
  const double value = n.value, low = n.low, high = n.high;
  begin_row(label);
  const float width = ImGui::CalcItemWidth();
  ImGui::PushID(label.data(), label.data() + label.size());
  const ImVec2 from = ImGui::GetCursorScreenPos(), to(from.x + width, from.y + ImGui::GetFrameHeight());
  const bool begin = ui.entry.id != ImGui::GetID("##type") && wants_typing(0, from, to, false);
  const std::string digits = fixed(value, n.decimals), format = fmt::format("%.{}f", n.decimals);
  std::optional<double> result;
  if (begin) ImGui::ClearActiveID();
  ImGui::SetNextItemWidth(sized(width));
  if (begin || ui.entry.id == ImGui::GetID("##type")) {
    if (typed(ui, "##type", digits, begin) == Typing::complete) result = parse(ui, label, n);
  } else {
    double wanted = value;
    const ImGuiSliderFlags flags =
        ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoInput | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));  // drawn below, next to the grab
    if (ImGui::SliderScalar("##slide", ImGuiDataType_Double, &wanted, &low, &high, format.c_str(), flags) &&
        wanted != value)
      result = wanted;
    ImGui::PopStyleColor();
    const double part =
        logarithmic && low > 0 ? std::log(value / low) / std::log(high / low) : (value - low) / (high - low);
    const float pad = std::floor(8 * ui.scale), left = part > 0.5 ? from.x + pad : to.x - pad - text_size(digits).x;
    draw_text(*ImGui::GetWindowDrawList(), {left, (from.y + to.y - ImGui::GetTextLineHeight()) * 0.5f}, palette().text,
              digits);
  }
  ImGui::PopID();
  note(ui, label, "slider", tooltip, true, digits, from, to);
  return in_metric(result, unit, metric);
}

constexpr double kLargestSlid = 2e9;  // fits an int

}  // namespace

std::optional<double> number(WidgetFrame& ui, std::string_view label, const Number& n, std::string_view tooltip,
                             bool enabled) {
  begin_row(label);
  return field(ui, label, n, {}, 0, ImGui::CalcItemWidth(), tooltip, enabled);
}

TypedNumber cell_number(WidgetFrame& ui, std::string_view label, const Number& n, std::string_view tooltip) {
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(std::floor(2 * ui.scale), 0));
  TypedNumber typed{field(ui, label, n, {}, 0, ImGui::GetContentRegionAvail().x, tooltip, true)};
  ImGui::PopStyleVar();
  ImGui::PushID(label.data(), label.data() + label.size());
  const ImGuiID id = ImGui::GetID("##type");
  ImGui::PopID();
  typed.open = ui.entry.id == id || (ui.wish && ui.wish->id == id);
  return typed;
}

std::optional<ChangedNumber> numbers(WidgetFrame& ui, std::string_view group, std::span<const std::string_view> names,
                                     std::span<const Number> values, std::string_view tooltip) {
  const float gap = std::floor(4 * ui.scale), room = ImGui::GetContentRegionAvail().x;
  const float count = static_cast<float>(names.size()), width = std::floor((room - gap * (count - 1)) / count);
  std::optional<ChangedNumber> changed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    const std::uint32_t tint = names.size() == 3 ? palette().axis[i] : palette().dim;
    const auto value =
        field(ui, fmt::format("{}/{}", group, names[i]), values[i], names[i], tint, width, tooltip, true);
    if (value) changed = ChangedNumber{static_cast<int>(i), *value};
  }
  return changed;
}

std::optional<double> real_slider(WidgetFrame& ui, std::string_view label, double value, double low, double high,
                                  int decimals, std::string_view tooltip, const char* unit) {
  const Number n{.value = value, .unit = unit, .decimals = decimals, .low = low, .high = high, .largest = kLargestSlid};
  return slide(ui, label, n, tooltip, false);
}

std::optional<int> slider(WidgetFrame& ui, std::string_view label, int value, int low, int high, bool logarithmic,
                          std::string_view tooltip) {
  const auto to = slide(ui, label, whole_number(value, low, high, kLargestSlid), tooltip, logarithmic);
  const auto rounded = to ? std::optional(static_cast<int>(std::lround(*to))) : std::nullopt;
  return rounded != value ? rounded : std::nullopt;
}

std::optional<int> combo(WidgetFrame& ui, std::string_view label, std::span<const Choice> choices, int current,
                         std::string_view tooltip, ComboPlace place) {
  float widest = 0;
  for (const Choice& choice : choices) widest = std::max(widest, text_size(shown(choice.label)).x);
  if (place == ComboPlace::in_bar) begin_in_bar(label);
  else
    begin_row(label, place == ComboPlace::beside
                         ? 0
                         : widest + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetFrameHeight());
  const std::string preview(current >= 0 && current < static_cast<int>(choices.size())
                                ? shown(choices[static_cast<std::size_t>(current)].label)
                                : "");
  // Once the list is open, ImGui's last item is the list, so the box is read before.
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const ImVec2 high(low.x + ImGui::CalcItemWidth(), low.y + ImGui::GetFrameHeight());
  std::optional<int> chosen;
  const std::string fitting =
      shortened(preview, high.x - low.x - ImGui::GetFrameHeight() - 2 * ImGui::GetStyle().FramePadding.x);
  const bool open = ImGui::BeginCombo(hidden(label).c_str(), fitting.c_str());
  if (open) {
    ImGui::PushStyleColor(ImGuiCol_Header, colour(palette().accent, 0.35f));
    for (std::size_t i = 0; i < choices.size(); ++i) {
      const bool on = static_cast<int>(i) == current;
      if (ImGui::Selectable(choices[i].label.c_str(), on) && !on) chosen = static_cast<int>(i);
      if (on) ImGui::SetItemDefaultFocus();  // the arrows start here
      note_item(ui, fmt::format("{}/{}", label, choices[i].label), "item", choices[i].tooltip, true, on ? "on" : "off");
    }
    ImGui::PopStyleColor();
    ImGui::EndCombo();
  }
  note(ui, label, "combo", tooltip, true, preview, low, high);
  if (fitting != preview) ui.list.mark_cut();
  return chosen;
}

std::optional<std::int32_t> colour_field(WidgetFrame& ui, std::string_view label, std::int32_t rgb,
                                         std::string_view tooltip) {
  constexpr ImGuiColorEditFlags kLook = ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_NoOptions |
                                        ImGuiColorEditFlags_NoTooltip | ImGuiColorEditFlags_PickerHueWheel;
  const bool enabled = ui.locked.empty();
  float parts[3];
  for (int i = 0; i < 3; ++i) parts[i] = static_cast<float>(rgb >> (16 - 8 * i) & 255) / 255;
  begin_row(label);
  ImGui::BeginDisabled(!enabled);
  const bool changed = ImGui::ColorEdit3(hidden(label).c_str(), parts, kLook);
  ImGui::EndDisabled();
  note_item(ui, label, "colour", tooltip, enabled, fmt::format("#{:06x}", rgb));
  if (!changed) return std::nullopt;
  std::int32_t now = 0;
  for (const float part : parts)
    now = now << 8 | static_cast<std::int32_t>(std::lround(255 * std::clamp(part, 0.0f, 1.0f)));
  if (now == rgb) return std::nullopt;
  begin_gesture(ui, ImGui::GetActiveID());
  return now;
}

std::optional<std::string> text(WidgetFrame& ui, std::string_view label, const std::string& value,
                                std::string_view tooltip, ShownTextEnd shows) {
  begin_row(label);
  const ImVec2 at = ImGui::GetCursorScreenPos(), padding = ImGui::GetStyle().FramePadding;
  const float room = ImGui::CalcItemWidth() - 2 * padding.x;
  const bool cut = ui.entry.id != ImGui::GetID(hidden(label).c_str()) && text_size(value).x > room;
  if (cut) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
  const Typing typing = typed(ui, hidden(label).c_str(), value, false);
  if (cut) {
    ImGui::PopStyleColor();
    draw_text(*ImGui::GetWindowDrawList(), {at.x + padding.x, at.y + padding.y}, palette().text,
              shortened(value, room, shows == ShownTextEnd::end));
  }
  note_item(ui, label, "text", cut ? fmt::format("{}\n{}", tooltip, value) : std::string(tooltip), true,
            typing == Typing::open ? ui.entry.text.data() : value);
  if (typing != Typing::complete) return std::nullopt;
  return std::string(ui.entry.text.data());
}

}  // namespace coaster::ui
