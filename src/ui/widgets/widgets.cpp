// Rows, buttons, switches, choices and read-outs. Editable fields are in fields.cpp.
#include "ui/widgets/widgets.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "base/text.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

// Returns the window that ImGui would find under a pixel; null over the viewport.
const ImGuiWindow* window_at(ImVec2 pixel) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  for (int i = g.Windows.Size - 1; i >= 0; --i) {
    const ImGuiWindow* window = g.Windows[i];
    if (!window->Active || window->Hidden || (window->Flags & ImGuiWindowFlags_NoMouseInputs) != 0) continue;
    if (window->OuterRectClipped.Contains(pixel)) return window;
  }
  return nullptr;
}

// Returns true if an open popup of another window captures the mouse. The menu bar keeps it, except under a modal
// popup.
bool behind_popup(const ImGuiWindow* window) {
  const ImGuiContext& g = *ImGui::GetCurrentContext();
  bool any = false;
  for (const ImGuiPopupData& popup : g.OpenPopupStack) {
    if (popup.Window == nullptr || !popup.Window->Active) continue;
    if (popup.Window == window->RootWindow) return false;
    any = any || (popup.Window->Flags & ImGuiWindowFlags_Modal) != 0 || (window->Flags & ImGuiWindowFlags_MenuBar) == 0;
  }
  return any;
}

constexpr std::string_view kId = "###";

// Returns `path` with the visible part of each label, or with its id.
std::string joined(std::string_view path, bool ids) {
  std::string result;
  while (true) {
    const std::size_t slash = path.find('/');
    const std::string_view label = path.substr(0, slash);
    const std::size_t mark = label.find(kId);
    result += ids && mark != std::string_view::npos ? label.substr(mark + kId.size()) : shown(label);
    if (slash == std::string_view::npos) return result;
    result += '/';
    path.remove_prefix(slash + 1);
  }
}

constexpr float kTooltipRest = 0.45f;  // s of rest before a tooltip shows

void show_tooltip(std::string_view text, float scale) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(10 * scale, 8 * scale));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + 320 * scale);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

// A radio button or a checkbox, lower than a button. `draw` returns whether it was pressed.
template <class Draw>
bool toggle_item(WidgetFrame& ui, std::string_view label, std::string_view kind, bool on, std::string_view tooltip,
                 bool enabled, Draw draw) {
  ImGui::BeginDisabled(!enabled);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(ImGui::GetStyle().FramePadding.x, std::floor(2 * ui.scale)));
  const bool pressed = draw(std::string(label).c_str());
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  note_item(ui, label, kind, tooltip, enabled, on ? "on" : "off");
  return pressed && enabled;
}

}  // namespace

std::string_view shown(std::string_view label) { return label.substr(0, label.find(kId)); }

std::string_view id_of(std::string_view label) {
  const std::size_t mark = label.find(kId);
  return mark == std::string_view::npos ? label : label.substr(mark + kId.size());
}

void WidgetList::clear() {
  widgets_.clear();
  windows_.clear();
}

void WidgetList::add(std::string_view path, std::string_view kind, glm::vec2 low, glm::vec2 high, bool enabled,
                     std::string value) {
  const ImGuiWindow* window = ImGui::GetCurrentWindowRead();
  const glm::vec2 middle = (low + high) * 0.5f;
  Widget widget;
  const bool has_id = path.find(kId) != std::string_view::npos;
  widget.path = has_id ? joined(path, false) : std::string(path);
  if (has_id) widget.alias = joined(path, true);
  widget.kind = kind;
  widget.x = low.x;
  widget.y = low.y;
  widget.width = high.x - low.x;
  widget.height = high.y - low.y;
  widget.visible = !window->SkipItems && window->ClipRect.Contains(ImVec2(middle.x, middle.y));
  widget.enabled = enabled;
  widget.value = std::move(value);
  widgets_.push_back(std::move(widget));
  windows_.push_back(window);
}

void WidgetList::finish() {
  for (std::size_t i = 0; i < widgets_.size(); ++i) {
    Widget& w = widgets_[i];
    const ImGuiWindow* top = window_at({w.x + w.width * 0.5f, w.y + w.height * 0.5f});
    const ImGuiWindow* own = windows_[i];
    const bool mouse = (own->Flags & ImGuiWindowFlags_NoMouseInputs) == 0;  // else it covers only the view
    const bool other = mouse ? top == nullptr || top->RootWindow != own->RootWindow : top != nullptr;
    w.covered = behind_popup(own) || (w.visible && other);
  }
}

void HoverTime::step(const platform::Events& events, float dt) {
  const bool used = std::any_of(events.begin(), events.end(), [](const platform::Event& event) {
    const auto* const key = std::get_if<platform::KeyPress>(&event);
    const auto* const button = std::get_if<platform::MouseButton>(&event);
    return (key != nullptr && key->down) || (button != nullptr && button->down);
  });
  constexpr float kNever = -1e9f;
  seconds = next != path ? 0 : used ? kNever : seconds + dt;
  path = std::exchange(next, {});
}

float sized(float length) { return length >= 1 ? std::min(length, 32'768.0f) : 1.0f; }
ImVec2 sized(ImVec2 size) { return {sized(size.x), sized(size.y)}; }

glm::vec2 mouse_position() { return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y}; }
bool mouse_over(ImVec2 low, ImVec2 high) {
  return ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) &&
         ImRect(low, high).Contains(ImGui::GetIO().MousePos);
}

void note(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
          std::string value, ImVec2 low, ImVec2 high) {
  const std::string path = label.empty() ? ui.panel : fmt::format("{}/{}", ui.panel, label);
  high = {std::max(low.x, high.x), std::max(low.y, high.y)};
  if (!ui.locked.empty()) tooltip = ui.locked, enabled = false;
  if (mouse_over(low, high) && !tooltip.empty()) {
    ui.rest.next = path;
    if (ui.rest.path == path && ui.rest.seconds > kTooltipRest && !ImGui::IsAnyMouseDown())
      show_tooltip(in_units(ui, tooltip), ui.scale);
  }
  ui.list.add(path, kind, {low.x, low.y}, {high.x, high.y}, enabled, std::move(value));
}

void note_item(WidgetFrame& ui, std::string_view label, std::string_view kind, std::string_view tooltip, bool enabled,
               std::string value) {
  note(ui, label, kind, tooltip, enabled, std::move(value), ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
}

void note_if_cut(WidgetFrame& ui, std::string_view label) {
  const float left = ImGui::GetStyle().FramePadding.x;  // a label that is too wide begins there
  if (left + text_size(shown(label)).x > ImGui::GetItemRectSize().x) ui.list.mark_cut();
}

std::string digits(const WidgetFrame& ui, double value, int decimals, std::string_view metric) {
  return base::figure_text(value, decimals, metric, ui.units);
}

std::string measured(const WidgetFrame& ui, double value, int decimals, std::string_view metric) {
  return fmt::format("{} {}", digits(ui, value, decimals, metric), base::shown_in(ui.units, metric).name);
}

std::string in_units(const WidgetFrame& ui, std::string_view words) { return base::in_units(words, ui.units); }

std::string hidden(std::string_view label) { return "##" + std::string(label); }

ImVec2 text_size(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()); }

std::string shortened(std::string_view text, float room, bool keep_end) {
  if (text_size(text).x <= room) return std::string(text);
  constexpr std::string_view kCut = "\u2026";
  const auto part = [&](std::size_t bytes) {
    return keep_end ? text.substr(base::utf8_start(text, text.size() - bytes).size()) : base::utf8_start(text, bytes);
  };
  // Halves the range, because measuring a text takes as long as it is.
  std::size_t fits = 0, too_long = text.size() + 1;
  while (too_long - fits > 1) {
    const std::size_t middle = (fits + too_long) / 2;
    (text_size(part(middle)).x <= room - text_size(kCut).x ? fits : too_long) = middle;
  }
  const std::string_view kept = part(fits);
  if (kept.empty()) return {};
  return keep_end ? fmt::format("{}{}", kCut, kept) : fmt::format("{}{}", kept, kCut);
}

void draw_text(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text) {
  if (!text.empty()) list.AddText(at, packed(rgb), text.data(), text.data() + text.size());
}

void draw_small(ImDrawList& list, ImVec2 at, std::uint32_t rgb, std::string_view text) {
  if (!text.empty())
    list.AddText(small_font(), small_pixels(), at, packed(rgb), text.data(), text.data() + text.size());
}

ImVec2 small_size(std::string_view text) {
  return small_font()->CalcTextSizeA(small_pixels(), 1e9f, 0, text.data(), text.data() + text.size());
}

void labelled_value(WidgetFrame& ui, std::string_view label, std::string_view value, std::string_view tooltip,
                    ImVec2 low, ImVec2 high) {
  const float top = std::floor(low.y + (high.y - low.y - ImGui::GetTextLineHeight()) * 0.5f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, {low.x, top}, palette().dim, shown(label));
  draw_text(list, {high.x - text_size(value).x, top}, palette().text, value);
  note(ui, label, "label", tooltip, true, std::string(value), low, high);
}

void draw_fold_mark(ImDrawList& list, ImVec2 middle, float scale, bool down) {
  const ImVec2 c(std::floor(middle.x), std::floor(middle.y));
  const float r = std::floor(4 * scale), deep = down ? r : -r;
  const ImVec2 left(c.x - r, c.y - deep * 0.5f), right(c.x + r, left.y), tip(c.x, c.y + deep * 0.7f);
  list.AddTriangleFilled(left, down ? right : tip, down ? tip : right, packed(palette().text));
}

float build_card(WidgetFrame& ui, const Card& card, const std::function<void()>& content) {
  ImGui::SetNextWindowPos(card.at, ImGuiCond_Always, card.pivot);
  ImGui::SetNextWindowSize({sized(card.width), 0});
  ImGui::SetNextWindowBgAlpha(card.alpha);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(card.padding.x * ui.scale, card.padding.y * ui.scale));
  if (ImGui::Begin(card.id, nullptr, card.flags | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings)) {
    ui.panel = card.panel;
    content();
    ui.panel.clear();
  }
  const float height = ImGui::GetWindowHeight();
  ImGui::End();
  ImGui::PopStyleVar();
  return height;
}

void begin_row(std::string_view label, float needed) {
  label = shown(label);
  constexpr float kLabelPart = 0.47f;  // fraction of the row for a label next to a control
  const float start = ImGui::GetCursorPosX(), room = ImGui::GetContentRegionAvail().x;
  const float label_room = std::floor(room * kLabelPart);
  const bool beside =
      text_size(label).x + ImGui::GetStyle().ItemInnerSpacing.x <= label_room && needed <= room - label_room;
  if (beside) ImGui::AlignTextToFramePadding();
  tinted_line(label, palette().dim);
  if (beside) ImGui::SameLine(start + label_room);
  ImGui::SetNextItemWidth(sized(beside ? room - label_room : room));
}

void begin_in_bar(std::string_view label) {
  ImGui::AlignTextToFramePadding();
  tinted_line(shown(label), palette().dim);
  ImGui::SameLine();
  ImGui::SetNextItemWidth(sized(ImGui::GetContentRegionAvail().x));
}

bool fold(WidgetFrame& ui, std::string_view name, bool open, std::string_view tooltip, ImVec2 size, bool lit) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), high(low.x + size.x, low.y + size.y);
  const bool pressed = ImGui::InvisibleButton(hidden(name).c_str(), sized(size)), shines = lit && open;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (shines || ImGui::IsItemHovered())
    list.AddRectFilled(low, high, packed(palette().field, shines || !lit ? 1.0f : 0.7f));
  draw_fold_mark(list, {low.x + size.y * 0.5f, low.y + size.y * 0.5f}, ui.scale, open);
  draw_text(list, {low.x + size.y, std::floor(low.y + (size.y - ImGui::GetTextLineHeight()) * 0.5f)}, palette().text,
            name);
  note(ui, "", "header", tooltip, true, open ? "open" : "closed", low, high);
  return pressed;
}

bool tab(WidgetFrame& ui, std::string_view path, std::string_view tooltip, bool selected, const TabBar& bar) {
  const std::string_view label = path.substr(path.rfind('/') + 1);
  ImGui::PushFont(bar.font);
  const ImVec2 words = text_size(label), low(ImGui::GetCursorScreenPos().x, ImGui::GetWindowPos().y);
  const ImVec2 high(std::floor(low.x + words.x + 2 * bar.pad), low.y + bar.height);
  ImGui::SetCursorScreenPos(low);  // items of a menu bar are lower
  const bool pressed = ImGui::InvisibleButton(hidden(label).c_str(), sized({high.x - low.x, bar.height}));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (selected || ImGui::IsItemHovered())
    list.AddRectFilled(low, high, packed(palette().field, selected ? 1.0f : 0.7f));
  const float line = std::max(bar.least_line, std::floor(2 * ui.scale)), top = bar.line_above ? low.y : high.y - line;
  if (selected) list.AddRectFilled({low.x, top}, {high.x, top + line}, packed(bar.rgb));
  draw_text(list, {low.x + bar.pad, std::floor(low.y + (bar.height - words.y) * 0.5f)},
            selected ? palette().text : palette().dim, label);
  ImGui::PopFont();
  note(ui, path, "radio", tooltip, true, selected ? "on" : "off", low, high);
  ImGui::SameLine(0, 0);
  return pressed;
}

void heading(WidgetFrame& ui, std::string_view label, std::string_view tooltip) {
  const std::string words = in_units(ui, shown(label));
  tinted_line(words, palette().dim);
  note_item(ui, words == shown(label) ? std::string(label) : fmt::format("{}###{}", words, id_of(label)), "label",
            tooltip, true);
}

void tinted_line(std::string_view words, std::uint32_t rgb) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour(rgb));
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopStyleColor();
}

void tinted(std::string_view words, std::uint32_t rgb) {
  ImGui::PushTextWrapPos(0);
  tinted_line(words, rgb);
  ImGui::PopTextWrapPos();
}

void paragraph(WidgetFrame& ui, std::string_view label, std::string_view words, std::uint32_t rgb) {
  const std::string shown_words = in_units(ui, words);
  tinted(shown_words, rgb);
  note_item(ui, label, "label", "", true, shown_words);
}

bool button(WidgetFrame& ui, std::string_view label, std::string_view tooltip, bool enabled, float width) {
  ImGui::BeginDisabled(!enabled);
  const bool pressed = ImGui::Button(std::string(label).c_str(), {width > 0   ? sized(width)
                                                                  : width < 0 ? -1.0f
                                                                              : 0.0f,
                                                                  0});
  ImGui::EndDisabled();
  note_item(ui, label, "button", tooltip, enabled);
  note_if_cut(ui, label);
  return pressed && enabled;
}

bool wide_button(WidgetFrame& ui, std::string_view label, std::string_view tooltip, bool enabled) {
  return button(ui, label, tooltip, enabled, ImGui::GetContentRegionAvail().x);
}

bool radio(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled) {
  const auto draw = [&](const char* text) { return ImGui::RadioButton(text, on); };
  return toggle_item(ui, label, "radio", on, tooltip, enabled, draw) && !on;
}

std::optional<bool> checkbox(WidgetFrame& ui, std::string_view label, bool on, std::string_view tooltip, bool enabled) {
  bool wanted = on;
  const auto draw = [&](const char* text) { return ImGui::Checkbox(text, &wanted); };
  return toggle_item(ui, label, "checkbox", on, tooltip, enabled, draw) ? std::optional(wanted) : std::nullopt;
}

bool beside_last(WidgetFrame& ui, std::string_view label) {
  const float button = ImGui::GetTextLineHeight() + 2 * std::floor(2 * ui.scale),
              room = ImGui::GetContentRegionAvail().x;
  const float start = ImGui::GetCursorPosX(), middle = std::floor(room * 0.5f);
  const float last_end = ImGui::GetItemRectMax().x - ImGui::GetCursorScreenPos().x;
  if (last_end > middle || middle + button + ImGui::GetStyle().ItemInnerSpacing.x + text_size(shown(label)).x > room)
    return false;
  ImGui::SameLine(start + middle);
  return true;
}

void read_out(WidgetFrame& ui, std::string_view label, std::string_view value, std::string_view unit,
              std::string_view tooltip, bool warns, bool red) {
  const std::string_view words = shown(label);
  const ImVec2 start = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, gap = std::floor(5 * ui.scale),
              line = ImGui::GetTextLineHeight();
  const float digits = text_size(value).x, unit_width = text_size(unit).x;
  const float value_width = digits + (unit.empty() ? 0 : gap + unit_width);
  // Units share one column, so that the numbers before them are right-aligned.
  const float unit_room = unit.empty() ? 0 : std::max(unit_width, std::floor(38 * ui.scale)) + gap;
  const bool stacked = text_size(words).x + gap + value_width > room;
  const bool column = !stacked && text_size(words).x + gap + digits + unit_room <= room;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const std::uint32_t tint = red ? palette().error : warns ? palette().warning : palette().text;
  draw_text(list, start, palette().dim, words);
  const float top = start.y + (stacked ? line : 0);
  const float right = start.x + room;
  const float edge = unit.empty() ? right : column ? right - unit_room : right - unit_width - gap;
  float height = stacked ? 2 * line : line;
  if (value_width > room) {  // too long for a line: wrapped below its label
    height = line + ImGui::CalcTextSize(value.data(), value.data() + value.size(), false, room).y;
    list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {start.x, top}, packed(tint), value.data(),
                 value.data() + value.size(), room);
    unit = {};
  } else {
    draw_text(list, {edge - digits, top}, tint, value);
    draw_text(list, {edge + gap, top}, palette().dim, unit);
  }
  ImGui::Dummy(sized({room, height}));
  note_item(ui, label, "label", tooltip, true, fmt::format("{}{}{}", value, unit.empty() ? "" : " ", unit));
}

void read_out(WidgetFrame& ui, std::string_view label, double value, int decimals, std::string_view metric,
              std::string_view tooltip, bool warns) {
  read_out(ui, label, digits(ui, value, decimals, metric), base::shown_in(ui.units, metric).name, tooltip, warns);
}

std::string fixed(double value, int decimals) { return base::figure_text(value, decimals, ""); }

bool ButtonRows::operator()(std::string_view label, std::string_view tooltip, bool enabled) {
  if (placed == 0) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x, room = ImGui::GetContentRegionAvail().x + gap;
    const float least = text_size(widest).x + style.FramePadding.x;  // it may take the padding at the right
    columns = std::clamp(static_cast<int>(room / (least + gap)), 1, columns);
    width = std::floor(room / static_cast<float>(columns) - gap);
  }
  if (placed++ % columns != 0) ImGui::SameLine();
  return button(ui, label, tooltip, enabled, width);
}

}  // namespace coaster::ui
