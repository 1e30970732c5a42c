// The probe, and the layout of a page.
#include "ui/lab/page_widgets.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "edit/commands/commands_settings.h"
#include "ui/widgets/theme.h"
#include "world/laboratory_settings.h"
#include "world/topology.h"

namespace coaster::ui {
namespace {

glm::dvec3 any_perpendicular(glm::dvec3 unit) {
  const glm::dvec3 other = std::abs(unit.y) < 0.9 ? glm::dvec3(0, 1, 0) : glm::dvec3(0, 0, 1);
  return glm::normalize(other - glm::dot(other, unit) * unit);
}

// Returns the direction between the two points that are farthest apart; {1,0,0} if all coincide.
glm::dvec3 longest_direction(std::span<const glm::dvec3> points) {
  glm::dvec3 longest(0);
  for (const glm::dvec3 a : points)
    for (const glm::dvec3 b : points)
      if (glm::dot(b - a, b - a) > glm::dot(longest, longest)) longest = b - a;
  const double length = glm::length(longest);
  return length > 0 ? longest / length : glm::dvec3(1, 0, 0);
}

world::Entity segment_for(const edit::Session& session) {
  const world::Entity selected = session.settings.selected;
  if (session.document.entities.find<world::Knot>(selected)) {
    const world::KnotSegments at = world::neighbours(session.document, selected);
    return at.after.valid() ? at.after : at.before;
  }
  const world::TrainMotion* const cart = session.motion.carts.find(selected);
  return cart ? cart->segment : selected;
}

// Right edges of three columns of figures.
float column_edge(const Ui& ui, ImVec2 at, float room, int i) {
  const float label = std::floor(44 * ui.scale);
  return at.x + label + (room - label) * static_cast<float>(i + 1) / 3;
}

}  // namespace

DrawingPlane sheet_of(std::span<const glm::dvec3> points) {
  const glm::dvec3 origin = points.front(), along = longest_direction(points);
  glm::dvec3 off(0);
  double largest = 0;
  for (const glm::dvec3 p : points) {
    const glm::dvec3 across = (p - origin) - glm::dot(p - origin, along) * along;
    if (glm::dot(across, across) > glm::dot(off, off)) off = across;
    largest = std::max(largest, glm::length(p - origin));
  }
  const double reach = glm::length(off);
  const glm::dvec3 across = reach > 1e-9 * largest && reach > 0 ? off / reach : any_perpendicular(along);
  DrawingPlane sheet{origin, along, across};
  if (glm::dot(points.back() - origin, along) < 0) sheet.right = -along;
  if (across.y < 0) sheet.up = -across;
  return sheet;
}

std::optional<Probe> need_probe(Ui& ui) {
  const edit::Session& session = ui.session();
  const std::vector<world::Entity>& order = session.derived.order;
  if (order.empty()) {
    paragraph(ui, "No segment", "No segment yet. Click on the ground to place two knots.", palette().dim);
    return std::nullopt;
  }
  const auto found = std::find(order.begin(), order.end(), segment_for(session));
  const world::Entity segment = found == order.end() ? order.front() : *found;
  const double t = session.settings.selected == segment ? session.settings.selected_t : 0.5;
  return Probe{segment, world::name_of(session.document, segment), &session.derived.shape(segment), t};
}

void move_probe(Ui& ui, const Probe& probe, double t) { ui.emit(edit::Select{{probe.name}, std::clamp(t, 0.0, 1.0)}); }

void probe_slider(Ui& ui, const Probe& probe) {
  const auto to = real_slider(
      ui, "t", probe.t, 0, 1, 3,
      "Parameter of the probe: 0 at the segment's start, 1 at its end. Or drag the probe along the curve in the view.");
  if (to) move_probe(ui, probe, *to);
}

void plot_over_t(Ui& ui, const Probe& probe, std::string_view label, Plot picture, std::string_view tooltip) {
  picture.x = {"t", "", AxisScale::linear, 0, 1};
  picture.cursor = probe.t;
  if (const auto drag = plot(ui, label, picture, tooltip)) move_probe(ui, probe, drag->x);
}

PageLayout::PageLayout(const Ui& ui, float side) : scale_(ui.scale) {
  constexpr float kLeast = 200, kGap = 14, kRoomy = 210;  // design px
  const float room = ImGui::GetContentRegionAvail().x;
  stacked_ = room < (side + kLeast) * scale_;
  pictures_width_ = stacked_ ? room : room - std::floor(side * scale_) - std::floor(kGap * scale_);
  compact_ = ImGui::GetContentRegionAvail().y < kRoomy * scale_;
  ImGui::BeginChild("##side", {stacked_ ? 0.0f : sized(std::floor(side * scale_)), 0}, false, ImGuiWindowFlags_NoNav);
  if (!compact_) return;
  ImGui::PushFont(small_font());
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(std::floor(6 * scale_), std::floor(3 * scale_)));
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(std::floor(6 * scale_), std::floor(2 * scale_)));
}

void PageLayout::end_side() {
  if (in_side_ && compact_) {
    ImGui::PopStyleVar(2);
    ImGui::PopFont();
  }
  in_side_ = false;
}

float PageLayout::pictures() {
  constexpr float kStacked = 150;  // design px
  end_side();
  if (stacked_) return std::floor(kStacked * scale_);
  ImGui::EndChild();
  ImGui::SameLine(ImGui::GetWindowWidth() - ImGui::GetStyle().WindowPadding.x - pictures_width_);
  ImGui::BeginChild("##pictures", {0, 0}, false, ImGuiWindowFlags_NoNav);
  return ImGui::GetContentRegionAvail().y;
}

PageLayout::~PageLayout() {
  end_side();
  ImGui::EndChild();
}

void colour_value(Ui& ui, std::uint32_t rgb, std::string_view path, std::string_view shown, std::string_view value,
                  std::string_view tooltip) {
  ImGui::PushFont(small_font());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight(),
              mark = std::floor(10 * ui.scale), y = std::floor(at.y + line * 0.5f);
  list.AddRectFilled({at.x, y - 1.5f * ui.scale}, {at.x + mark, y + 1.5f * ui.scale}, packed(ink(rgb)));
  draw_text(list, {at.x + mark + std::floor(6 * ui.scale), at.y}, palette().dim, shown);
  draw_text(list, {at.x + room - text_size(value).x, at.y}, palette().text, value);
  ImGui::Dummy(sized({room, line}));
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

void triple_heading(Ui& ui, std::string_view unit) {
  ImGui::PushFont(small_font());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x;
  for (int i = 0; i < 3; ++i) {
    const std::string words = fmt::format("{} ({})", "xyz"[i], base::shown_in(ui.units, unit).name);
    draw_text(*ImGui::GetWindowDrawList(), {column_edge(ui, at, room, i) - text_size(words).x, at.y}, palette().dim,
              words);
  }
  ImGui::Dummy(sized({room, ImGui::GetTextLineHeight()}));
  ImGui::PopFont();
}

void triple(Ui& ui, std::string_view path, std::string_view shown, std::uint32_t rgb, glm::dvec3 value, int decimals,
            std::string_view unit, std::string_view tooltip) {
  ImGui::PushFont(small_font());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float room = ImGui::GetContentRegionAvail().x, line = ImGui::GetTextLineHeight();
  draw_text(list, at, ink(rgb), shown);
  std::string words;
  for (int i = 0; i < 3; ++i) {
    const std::string one = digits(ui, value[i], decimals, unit);
    words += (i > 0 ? " " : "") + one;
    draw_text(list, {column_edge(ui, at, room, i) - text_size(one).x, at.y}, palette().text, one);
  }
  if (!unit.empty()) words += fmt::format(" {}", base::shown_in(ui.units, unit).name);
  ImGui::Dummy(sized({room, line}));
  note_item(ui, path, "label", tooltip, true, words);
  ImGui::PopFont();
}

void small_note(std::string_view words) {
  ImGui::PushFont(small_font());
  tinted(words, palette().dim);
  ImGui::PopFont();
}

void choose_side(Ui& ui, bool& second, const RadioLabel& off, const RadioLabel& on) {
  if (radio(ui, off.label, !second, off.tooltip)) second = false;
  ImGui::SameLine();
  if (radio(ui, on.label, second, on.tooltip)) second = true;
}

void two_pictures(Ui& ui, PageLayout& page, const Picture& first, const Picture& second) {
  const float height = page.pictures(), room = ImGui::GetContentRegionAvail().x, gap = std::floor(12 * ui.scale);
  const bool beside = room > 380 * ui.scale;
  const float width = beside ? std::floor((room - gap) / 2) : room;
  first(width, height);
  if (beside) ImGui::SameLine(0, gap);
  second(width, height);
}

std::optional<float> height_edge(Ui& ui, const view::Viewport& area, float bar, float tallest,
                                 std::string_view tooltip) {
  const ImVec2 low = ImGui::GetCursorScreenPos(), size(area.width, std::floor(5 * ui.scale));
  ImGui::InvisibleButton("##edge", sized(size));
  const bool held = ImGui::IsItemActive(), hot = held || ImGui::IsItemHovered();
  if (hot) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + size.x, low.y + std::floor(2 * ui.scale)},
                                              packed(palette().accent));
  }
  note_item(ui, "Edge", "edge", fmt::format("{} Drag, or double-click for the usual height.", tooltip), true);
  ImGui::SetCursorScreenPos(low);
  const float bottom = area.y + area.height, middle = bottom - bar;  // the menu is as high as the bar
  const ImGuiIO& io = ImGui::GetIO();
  if (hot && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) return 0.0f;
  if (!held || io.MouseDelta.y == 0) return std::nullopt;
  constexpr float kLeast = 0.05f, kSteps = 1000;
  const float share = std::round(kSteps * (bottom - io.MousePos.y) / std::max(1.0f, middle)) / kSteps;
  return std::clamp(share, kLeast, tallest);
}

std::uint32_t row_colour(std::size_t row) {
  static constexpr std::array<std::uint32_t, 10> kColours{0x4C9AFF, 0xF2B84B, 0x7FD1B9, 0xE5736B, 0xB39DDB,
                                                          0xD8DEE9, 0x9CCC65, 0xFF9EC4, 0x8D9DB6, 0xD4A373};
  return kColours[row % kColours.size()];
}

}  // namespace coaster::ui
