// The probe, and the layout of a page.
#include "ui/lab/page_parts.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "edit/commands/commands_lab.h"
#include "edit/commands/commands_settings.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widget_parts.h"
#include "world/lab_view.h"
#include "world/topology.h"

namespace coaster::ui {
namespace {

world::Entity segment_for(const edit::Session& session) {
  const world::Entity selected = session.settings.selected;
  const world::Name* name = session.document.entities.find<world::Name>(selected);
  if (name != nullptr && name->kind == world::Kind::segment) return selected;
  if (name != nullptr && name->kind == world::Kind::knot) {
    const world::Neighbours at = world::neighbours(session.document, selected);
    return at.after.valid() ? at.after : at.before;
  }
  if (name != nullptr && name->kind == world::Kind::cart)
    if (const world::CartMotion* motion = session.motion.carts.find(selected)) return motion->segment;
  return {};
}

}  // namespace

std::optional<Probe> probe_of(const edit::Session& session) {
  const std::vector<world::Entity>& order = session.derived.order;
  if (order.empty()) return std::nullopt;
  const auto found = std::find(order.begin(), order.end(), segment_for(session));
  const std::size_t index = found == order.end() ? 0 : static_cast<std::size_t>(found - order.begin());
  const world::Entity segment = order[index];
  const double t = session.settings.selected == segment ? session.settings.selected_t : 0.5;
  return Probe{segment, world::name_of(session.document, segment), &session.derived.shape(segment), t, index};
}

std::optional<Probe> need_probe(Ui& ui) {
  const auto probe = probe_of(ui.session());
  if (!probe) paragraph(ui, "No segment", "No segment yet. Click on the ground to place two knots.", palette().dim);
  return probe;
}

void move_probe(Ui& ui, const Probe& probe, double t) { ui.emit(edit::Select{{probe.name}, std::clamp(t, 0.0, 1.0)}); }

void probe_slider(Ui& ui, const Probe& probe) {
  const auto to = real_slider(
      ui, "t", probe.t, 0, 1, 3,
      "Parameter of the probe: 0 at the segment's start, 1 at its end. Or drag the probe along the curve in the view.");
  if (to) move_probe(ui, probe, *to);
}

Page::Page(const Ui& ui, float side) : scale_(ui.scale) {
  constexpr float kLeast = 200, kGap = 14;  // design px
  const float room = ImGui::GetContentRegionAvail().x;
  stacked_ = room < (side + kLeast) * scale_;
  pictures_width_ = stacked_ ? room : room - std::floor(side * scale_) - std::floor(kGap * scale_);
  constexpr float kRoomy = 210;  // design px
  compact_ = ImGui::GetContentRegionAvail().y < kRoomy * scale_;
  ImGui::BeginChild("##side", {stacked_ ? 0.0f : std::floor(side * scale_), 0}, false, ImGuiWindowFlags_NoNav);
  if (!compact_) return;
  ImGui::PushFont(small_font());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(std::floor(6 * scale_), std::floor(3 * scale_)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(std::floor(6 * scale_), std::floor(2 * scale_)));
}

void Page::end_side() {
  if (in_side_ && compact_) {
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
  }
  in_side_ = false;
}

float Page::pictures() {
  constexpr float kStacked = 150;  // design px
  end_side();
  if (stacked_) return std::floor(kStacked * scale_);
  ImGui::EndChild();
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - pictures_width_);
  ImGui::BeginChild("##pictures", {0, 0}, false,
                    ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  return ImGui::GetContentRegionAvail().y;
}

Page::~Page() {
  end_side();
  ImGui::EndChild();
}

void colour_value(Ui& ui, std::uint32_t rgb, std::string_view path, std::string_view shown, std::string_view value,
                  std::string_view tooltip) {
  ImGui::PushFont(small_font());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight(),
              mark = std::floor(10 * ui.scale);
  const float y = std::floor(at.y + line * 0.5f);
  list.AddRectFilled({at.x, y - 1.5f * ui.scale}, {at.x + mark, y + 1.5f * ui.scale}, packed(ink(rgb)));
  list.AddText({at.x + mark + std::floor(6 * ui.scale), at.y}, packed(palette().dim), shown.data(),
               shown.data() + shown.size());
  list.AddText({std::floor(at.x + room - text_size(value).x), at.y}, packed(palette().text), value.data(),
               value.data() + value.size());
  ImGui::Dummy({room, line});
  note_item(ui, path, "label", tooltip, true, std::string(value));
  ImGui::PopFont();
}

void layer_box(Ui& ui, world::Layer layer) {
  const base::NameRow& row = base::row_of(layer);
  const std::string panel = std::exchange(ui.panel, ui.panel + "/View");  // pages and layers share names
  if (const auto on = checkbox(ui, row.label, ui.session().settings.lab->layers.has(layer), row.help))
    ui.emit(edit::ShowLayer{layer, *on});
  ui.panel = panel;
}

namespace {

// Right edges of three columns of figures.
float column_edge(ImVec2 at, float room, float label, int i) {
  return at.x + label + (room - label) * static_cast<float>(i + 1) / 3;
}
float triple_label(const Ui& ui) { return std::floor(44 * ui.scale); }

}  // namespace

void triple_heading(Ui& ui, std::string_view unit) {
  ImGui::PushFont(small_font());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  for (int i = 0; i < 3; ++i) {
    const std::string words = std::string(1, "xyz"[i]) + (unit.empty() ? "" : " (" + std::string(unit) + ")");
    ImGui::GetWindowDrawList()->AddText(
        {std::floor(column_edge(at, room, triple_label(ui), i) - text_size(words).x), at.y}, packed(palette().dim),
        words.c_str());
  }
  ImGui::Dummy({room, ImGui::GetTextLineHeight()});
  ImGui::PopFont();
}

void triple(Ui& ui, std::string_view path, std::string_view shown, std::uint32_t rgb, glm::dvec3 value, int decimals,
            std::string_view unit, std::string_view tooltip) {
  ImGui::PushFont(small_font());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight();
  list.AddText(at, packed(ink(rgb)), shown.data(), shown.data() + shown.size());
  std::string words;
  for (int i = 0; i < 3; ++i) {
    const std::string digits = fixed(value[i], decimals);
    words += (i > 0 ? " " : "") + digits;
    list.AddText({std::floor(column_edge(at, room, triple_label(ui), i) - text_size(digits).x), at.y},
                 packed(palette().text), digits.c_str());
  }
  if (!unit.empty()) words += " " + std::string(unit);
  ImGui::Dummy({room, line});
  note_item(ui, path, "label", tooltip, true, words);
  ImGui::PopFont();
}

void small_note(std::string_view words) {
  ImGui::PushFont(small_font());
  tinted(words, palette().dim);
  ImGui::PopFont();
}

void colour_key(Ui& ui, std::uint32_t rgb, std::string_view label, std::string_view tooltip) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight(), mark = std::floor(10 * ui.scale);
  const float y = std::floor(at.y + line * 0.5f);
  ImGui::GetWindowDrawList()->AddRectFilled({at.x, y - mark * 0.3f}, {at.x + mark * 1.6f, y + mark * 0.3f},
                                            packed(ink(rgb)), 2);
  ImGui::Dummy({mark * 1.6f, line});
  ImGui::SameLine(0, std::floor(6 * ui.scale));
  const std::string_view words = shown(label);
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  note(ui, label, "label", tooltip, true, std::string(words), at, ImGui::GetItemRectMax());
}

std::uint32_t row_colour(std::size_t row) {
  static constexpr std::array<std::uint32_t, 10> kColours{0x4C9AFF, 0xF2B84B, 0x7FD1B9, 0xE5736B, 0xB39DDB,
                                                          0xD8DEE9, 0x9CCC65, 0xFF9EC4, 0x8D9DB6, 0xD4A373};
  return kColours[row % kColours.size()];
}

}  // namespace coaster::ui
