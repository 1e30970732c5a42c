// The strokes of each icon, buttons with icons, and medals.
#include "ui/widgets/icons.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/portable_math.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "world/element_rows.h"

namespace coaster::ui {
namespace {

using Place = VectorIcon::Place;
using Stroke = VectorIcon::Stroke;

constexpr Stroke line(Place a, Place b) {
  return {a, {(2 * a.x + b.x) / 3, (2 * a.y + b.y) / 3}, {(a.x + 2 * b.x) / 3, (a.y + 2 * b.y) / 3}, b};
}

constexpr std::array kStraight{line({0.02f, 0.75f}, {0.98f, 0.35f})};
constexpr std::array kCurve{Stroke{{0.1f, 0.95f}, {0.1f, 0.4f}, {0.4f, 0.12f}, {0.95f, 0.12f}}};
constexpr std::array kHelix{Stroke{{0.05f, 0.9f}, {0.4f, 1.0f}, {0.95f, 0.95f}, {0.92f, 0.76f}},
                            Stroke{{0.92f, 0.76f}, {0.88f, 0.55f}, {0.1f, 0.62f}, {0.12f, 0.45f}},
                            Stroke{{0.12f, 0.45f}, {0.15f, 0.25f}, {0.92f, 0.5f}, {0.88f, 0.28f}},
                            Stroke{{0.88f, 0.28f}, {0.84f, 0.1f}, {0.4f, 0.05f}, {0.12f, 0.1f}}};
// Seen from the side, with arrows up and down.
constexpr std::array kClimb{Stroke{{0.02f, 0.92f}, {0.6f, 0.92f}, {0.5f, 0.3f}, {0.98f, 0.3f}},
                            line({0.2f, 0.66f}, {0.2f, 0.06f}), line({0.2f, 0.06f}, {0.04f, 0.26f}),
                            line({0.2f, 0.06f}, {0.36f, 0.26f})};
constexpr std::array kDive{Stroke{{0.02f, 0.3f}, {0.5f, 0.3f}, {0.4f, 0.92f}, {0.98f, 0.92f}},
                           line({0.8f, 0.06f}, {0.8f, 0.66f}), line({0.8f, 0.66f}, {0.64f, 0.46f}),
                           line({0.8f, 0.66f}, {0.96f, 0.46f})};
constexpr std::array kCamelback{Stroke{{0.02f, 0.88f}, {0.28f, 0.88f}, {0.28f, 0.2f}, {0.5f, 0.2f}},
                                Stroke{{0.5f, 0.2f}, {0.72f, 0.2f}, {0.72f, 0.88f}, {0.98f, 0.88f}}};
constexpr std::array kLoop{Stroke{{0.02f, 0.92f}, {0.6f, 0.92f}, {0.86f, 0.66f}, {0.82f, 0.4f}},
                           Stroke{{0.82f, 0.4f}, {0.77f, 0.02f}, {0.23f, 0.02f}, {0.18f, 0.4f}},
                           Stroke{{0.18f, 0.4f}, {0.14f, 0.66f}, {0.4f, 0.92f}, {0.98f, 0.92f}}};
constexpr std::array kCorkscrew{Stroke{{0.02f, 0.7f}, {0.3f, 0.7f}, {0.62f, 0.62f}, {0.6f, 0.3f}},
                                Stroke{{0.6f, 0.3f}, {0.58f, 0.1f}, {0.34f, 0.1f}, {0.36f, 0.34f}},
                                Stroke{{0.36f, 0.34f}, {0.4f, 0.75f}, {0.7f, 0.85f}, {0.98f, 0.85f}}};
// Seen from above, as the curve: it begins at the bottom.
constexpr std::array kSBend{Stroke{{0.2f, 0.98f}, {0.2f, 0.36f}, {0.8f, 0.64f}, {0.8f, 0.02f}}};
constexpr std::array kOverbankedTurn{Stroke{{0.06f, 0.92f}, {0.1f, 0.1f}, {0.9f, 0.1f}, {0.94f, 0.92f}},
                                     line({0.5f, 0.3f}, {0.5f, 0.62f}), line({0.22f, 0.5f}, {0.36f, 0.66f}),
                                     line({0.78f, 0.5f}, {0.64f, 0.66f})};
constexpr std::array kBunnyHops{Stroke{{0.02f, 0.7f}, {0.12f, 0.7f}, {0.1f, 0.35f}, {0.19f, 0.35f}},
                                Stroke{{0.19f, 0.35f}, {0.3f, 0.35f}, {0.24f, 0.7f}, {0.35f, 0.7f}},
                                Stroke{{0.35f, 0.7f}, {0.45f, 0.7f}, {0.4f, 0.35f}, {0.5f, 0.35f}},
                                Stroke{{0.5f, 0.35f}, {0.6f, 0.35f}, {0.55f, 0.7f}, {0.65f, 0.7f}},
                                Stroke{{0.65f, 0.7f}, {0.76f, 0.7f}, {0.7f, 0.35f}, {0.81f, 0.35f}},
                                Stroke{{0.81f, 0.35f}, {0.9f, 0.35f}, {0.88f, 0.7f}, {0.98f, 0.7f}}};
constexpr std::array kZeroGRoll{Stroke{{0.02f, 0.9f}, {0.3f, 0.9f}, {0.28f, 0.42f}, {0.5f, 0.42f}},
                                Stroke{{0.5f, 0.42f}, {0.72f, 0.42f}, {0.7f, 0.9f}, {0.98f, 0.9f}},
                                Stroke{{0.3f, 0.26f}, {0.36f, 0.0f}, {0.64f, 0.0f}, {0.7f, 0.26f}},
                                line({0.7f, 0.26f}, {0.58f, 0.2f}), line({0.7f, 0.26f}, {0.77f, 0.13f})};
// Half a loop with an arrow at its end, which is above or below.
constexpr std::array kImmelmann{Stroke{{0.02f, 0.92f}, {0.7f, 0.92f}, {0.96f, 0.78f}, {0.96f, 0.52f}},
                                Stroke{{0.96f, 0.52f}, {0.96f, 0.26f}, {0.7f, 0.16f}, {0.06f, 0.2f}},
                                line({0.06f, 0.2f}, {0.26f, 0.04f}), line({0.06f, 0.2f}, {0.26f, 0.36f})};
constexpr std::array kDiveLoop{Stroke{{0.98f, 0.1f}, {0.3f, 0.08f}, {0.04f, 0.22f}, {0.04f, 0.48f}},
                               Stroke{{0.04f, 0.48f}, {0.04f, 0.76f}, {0.3f, 0.84f}, {0.94f, 0.8f}},
                               line({0.94f, 0.8f}, {0.74f, 0.64f}), line({0.94f, 0.8f}, {0.74f, 0.96f})};
constexpr std::array kCobraRoll{Stroke{{0.2f, 0.98f}, {0.3f, 0.6f}, {0.46f, 0.5f}, {0.42f, 0.24f}},
                                Stroke{{0.42f, 0.24f}, {0.38f, 0.0f}, {0.02f, 0.04f}, {0.08f, 0.34f}},
                                Stroke{{0.08f, 0.34f}, {0.16f, 0.74f}, {0.84f, 0.74f}, {0.92f, 0.34f}},
                                Stroke{{0.92f, 0.34f}, {0.98f, 0.04f}, {0.62f, 0.0f}, {0.58f, 0.24f}},
                                Stroke{{0.58f, 0.24f}, {0.54f, 0.5f}, {0.7f, 0.6f}, {0.8f, 0.98f}}};
constexpr std::array kBrakeRun{line({0.02f, 0.6f}, {0.98f, 0.6f}),   line({0.14f, 0.44f}, {0.14f, 0.76f}),
                               line({0.28f, 0.44f}, {0.28f, 0.76f}), line({0.42f, 0.44f}, {0.42f, 0.76f}),
                               line({0.58f, 0.2f}, {0.98f, 0.2f}),   line({0.66f, 0.2f}, {0.66f, 0.56f}),
                               line({0.9f, 0.2f}, {0.9f, 0.56f})};
constexpr std::array kReset{Stroke{{0.26f, 0.24f}, {0.6f, -0.02f}, {0.98f, 0.26f}, {0.9f, 0.62f}},
                            Stroke{{0.9f, 0.62f}, {0.78f, 1.02f}, {0.2f, 1.02f}, {0.1f, 0.6f}},
                            line({0.26f, 0.24f}, {0.24f, 0.0f}), line({0.26f, 0.24f}, {0.5f, 0.3f})};

// Knots joined by hand, and a ring with a dot.
constexpr std::array kPencil{Stroke{{0.08f, 0.86f}, {0.3f, 0.2f}, {0.5f, 1.0f}, {0.7f, 0.5f}},
                             line({0.7f, 0.5f}, {0.92f, 0.12f}),
                             line({0.0f, 0.86f}, {0.16f, 0.86f}),
                             line({0.08f, 0.78f}, {0.08f, 0.94f}),
                             line({0.62f, 0.5f}, {0.78f, 0.5f}),
                             line({0.7f, 0.42f}, {0.7f, 0.58f})};
// A ring whose last part is dashed.
constexpr std::array kCircuit{Stroke{{0.5f, 0.9f}, {-0.05f, 0.9f}, {-0.05f, 0.1f}, {0.5f, 0.1f}},
                              Stroke{{0.62f, 0.11f}, {0.7f, 0.13f}, {0.77f, 0.17f}, {0.82f, 0.24f}},
                              Stroke{{0.89f, 0.36f}, {0.92f, 0.46f}, {0.92f, 0.54f}, {0.89f, 0.64f}},
                              Stroke{{0.82f, 0.76f}, {0.77f, 0.83f}, {0.7f, 0.87f}, {0.62f, 0.89f}}};
// A curve through keys.
constexpr std::array kGraph{Stroke{{0.02f, 0.75f}, {0.2f, 0.75f}, {0.15f, 0.2f}, {0.35f, 0.2f}},
                            Stroke{{0.35f, 0.2f}, {0.55f, 0.2f}, {0.5f, 0.82f}, {0.7f, 0.82f}},
                            Stroke{{0.7f, 0.82f}, {0.85f, 0.82f}, {0.85f, 0.45f}, {0.98f, 0.45f}}};
constexpr VectorIcon::Bar kForceKeys[] = {{{0.25f, 0.1f}, {0.45f, 0.3f}}, {{0.6f, 0.72f}, {0.8f, 0.92f}}};
constexpr std::array kRing{Stroke{{0.06f, 0.5f}, {0.06f, -0.09f}, {0.94f, -0.09f}, {0.94f, 0.5f}},
                           Stroke{{0.94f, 0.5f}, {0.94f, 1.09f}, {0.06f, 1.09f}, {0.06f, 0.5f}}};

constexpr Place kPlayArrow[] = {{0.14f, 0.06f}, {0.14f, 0.94f}, {0.94f, 0.5f}},
                kStepArrow[] = {{0.14f, 0.06f}, {0.14f, 0.94f}, {0.7f, 0.5f}};
constexpr VectorIcon::Bar kDot[] = {{{0.36f, 0.36f}, {0.64f, 0.64f}}};
constexpr VectorIcon::Bar kStepBar[] = {{{0.74f, 0.06f}, {0.92f, 0.94f}}},
                          kPauseBars[] = {{{0.14f, 0.06f}, {0.4f, 0.94f}}, {{0.6f, 0.06f}, {0.86f, 0.94f}}},
                          kStopBar[] = {{{0.12f, 0.12f}, {0.88f, 0.88f}}};

// The icons of elements, by the name in their rows.
struct ElementIcon {
  std::string_view name;
  VectorIcon icon;
};
constexpr ElementIcon kElementIcons[] = {{"straight", {kStraight}},
                                         {"curve", {kCurve}},
                                         {"helix", {kHelix}},
                                         {"climb", {kClimb}},
                                         {"dive", {kDive}},
                                         {"camelback", {kCamelback}},
                                         {"loop", {kLoop}},
                                         {"corkscrew", {kCorkscrew}},
                                         {"s_bend", {kSBend}},
                                         {"overbanked_turn", {kOverbankedTurn}},
                                         {"bunny_hops", {kBunnyHops}},
                                         {"zero_g_roll", {kZeroGRoll}},
                                         {"immelmann", {kImmelmann}},
                                         {"dive_loop", {kDiveLoop}},
                                         {"cobra_roll", {kCobraRoll}},
                                         {"brake_run", {kBrakeRun}},
                                         {"forces", {kGraph, {}, kForceKeys}}};
constexpr const ElementIcon* icon_named(std::string_view name) {
  return std::ranges::find_if(kElementIcons, [&](const ElementIcon& icon) { return icon.name == name; });
}
static_assert(std::ranges::all_of(world::kElements,
                                  [](const world::ElementRow& row) {
                                    return icon_named(row.icon) != std::end(kElementIcons);
                                  }),
              "each element names an icon");

// Draws into the square of `size` px whose top left is `low`.
void draw_icon(ImDrawList& list, const VectorIcon& icon, ImVec2 low, float size, ImU32 colour) {
  const auto at = [&](Place p) { return ImVec2(low.x + p.x * size, low.y + p.y * size); };
  const float thick = std::max(1.25f, size * 0.1f);
  for (const Stroke& s : icon.strokes) list.AddBezierCubic(at(s.p0), at(s.p1), at(s.p2), at(s.p3), colour, thick);
  if (!icon.arrow.empty()) list.AddTriangleFilled(at(icon.arrow[0]), at(icon.arrow[1]), at(icon.arrow[2]), colour);
  for (const VectorIcon::Bar& bar : icon.bars) list.AddRectFilled(at(bar.low), at(bar.high), colour);
}

struct MedalColours {
  std::uint32_t face, rim, star;
};
constexpr std::array<MedalColours, 3> kMetals{MedalColours{0xCB8A57, 0x8F5A32, 0xF0C7A4},
                                              MedalColours{0xC5CCD6, 0x858F9E, 0xF7F9FC},
                                              MedalColours{0xF0C23B, 0xB07F12, 0xFFF3C4}};

// A star of five points about its middle, one of them up.
void draw_star(ImDrawList& list, ImVec2 middle, float radius, ImU32 colour) {
  constexpr float kTurn = static_cast<float>(base::kPi / 5), kInner = 0.42f;
  std::array<ImVec2, 10> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float angle = kTurn * static_cast<float>(i), r = i % 2 == 0 ? radius : radius * kInner;
    points[i] = {middle.x + r * std::sin(angle), middle.y - r * std::cos(angle)};
  }
  for (std::size_t i = 0; i < points.size(); i += 2)
    list.AddTriangleFilled(points[(i + 9) % 10], points[i], points[i + 1], colour);
  std::array<ImVec2, 5> inner;
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = points[2 * i + 1];
  list.AddConvexPolyFilled(inner.data(), static_cast<int>(inner.size()), colour);
}

}  // namespace

const VectorIcon kPlayIcon{{}, kPlayArrow}, kPauseIcon{{}, {}, kPauseBars}, kStepIcon{{}, kStepArrow, kStepBar},
    kResetIcon{kReset}, kPencilIcon{kPencil}, kCircuitIcon{kCircuit}, kRecordIcon{kRing, {}, kDot},
    kStopIcon{{}, {}, kStopBar};

const VectorIcon& icon_of(world::ElementKind kind) { return icon_named(base::row_of(kind).icon)->icon; }

bool icon_button(WidgetFrame& ui, const VectorIcon& icon, std::string_view label, std::string_view tooltip,
                 bool enabled, float width, IconPlace place) {
  const bool above = place == IconPlace::above, alone = place == IconPlace::alone;
  const std::string_view name = shown(label);
  if (above) ImGui::PushFont(small_font());
  const ImVec2 words = alone ? ImVec2(0, 0) : text_size(name);
  const float line = ImGui::GetTextLineHeight(), design = above ? 36.0f : 34.0f,
              size = std::floor(alone   ? 20 * ui.scale
                                : above ? 17 * ui.scale
                                        : 0.62f * line),
              gap = alone ? 0 : std::floor(above ? ui.scale : 0.35f * line);
  const float height = above || alone ? std::floor(design * ui.scale) : line + 2 * ImGui::GetStyle().FramePadding.y;
  ImGui::BeginDisabled(!enabled);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::Button(hidden(label).c_str(), sized({width, height}));
  const ImU32 colour = ImGui::GetColorU32(ImGuiCol_Text);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRect(low, {low.x + width, low.y + height}, true);
  const float inside = above ? words.x : words.x + gap + size, left = low.x + std::max(1.0f, (width - inside) / 2);
  const float top = low.y + std::floor((height - line - (above ? size + gap : 0)) / 2);
  const ImVec2 icon_at = above ? ImVec2(low.x + (width - size) / 2, top) : ImVec2(left, low.y + (height - size) / 2);
  const ImVec2 words_at = above ? ImVec2(left, top + size + gap) : ImVec2(std::floor(left) + size + gap, top);
  draw_icon(list, icon, {std::floor(icon_at.x), std::floor(icon_at.y)}, size, colour);
  if (!alone) list.AddText(words_at, colour, name.data(), name.data() + name.size());
  list.PopClipRect();
  ImGui::EndDisabled();
  if (above) ImGui::PopFont();
  note_item(ui, label, "button", tooltip, enabled);
  if (!alone && inside > width) ui.list.mark_cut();
  return pressed && enabled;
}

void draw_medal(ImDrawList& list, ImVec2 low, float size, int medal, bool earned) {
  const MedalColours& metal = kMetals[static_cast<std::size_t>(std::clamp(medal, 1, 3) - 1)];
  const float radius = size * 0.33f;
  const ImVec2 middle(low.x + size * 0.5f, low.y + size - radius - 1);
  const auto at = [&](float x, float y) { return ImVec2(low.x + x * size, low.y + y * size); };
  if (!earned) {
    const ImU32 line = packed(palette().dim, 0.55f);
    list.AddLine(at(0.26f, 0.02f), at(0.42f, 0.36f), line, std::max(1.0f, size * 0.05f));
    list.AddLine(at(0.74f, 0.02f), at(0.58f, 0.36f), line, std::max(1.0f, size * 0.05f));
    list.AddCircle(middle, radius, line, 0, std::max(1.0f, size * 0.06f));
    return;
  }
  const ImU32 left = packed(0x3E7FD6), right = packed(0x2C5FA8);
  list.AddQuadFilled(at(0.14f, 0), at(0.36f, 0), at(0.60f, 0.45f), at(0.44f, 0.5f), left);
  list.AddQuadFilled(at(0.64f, 0), at(0.86f, 0), at(0.56f, 0.5f), at(0.40f, 0.45f), right);
  list.AddCircleFilled(middle, radius, packed(metal.rim));
  list.AddCircleFilled(middle, radius * 0.84f, packed(metal.face));
  draw_star(list, middle, radius * 0.62f, packed(metal.star));
}

void draw_mark(ImDrawList& list, ImVec2 low, float size, bool good) {
  const ImVec2 middle(low.x + size * 0.5f, low.y + size * 0.5f);
  const auto at = [&](float x, float y) { return ImVec2(low.x + x * size, low.y + y * size); };
  const float thick = std::max(1.5f, size * 0.12f);
  if (good) {
    list.AddCircleFilled(middle, size * 0.5f, packed(palette().good));
    const ImVec2 tick[] = {at(0.26f, 0.52f), at(0.44f, 0.70f), at(0.75f, 0.32f)};
    list.AddPolyline(tick, 3, packed(0xFFFFFF), 0, thick);
  } else {
    list.AddCircle(middle, size * 0.5f - thick * 0.5f, packed(palette().error, 0.9f), 0, std::max(1.0f, thick * 0.75f));
    list.AddLine(at(0.34f, 0.34f), at(0.66f, 0.66f), packed(palette().error), thick);
    list.AddLine(at(0.66f, 0.34f), at(0.34f, 0.66f), packed(palette().error), thick);
  }
}

std::string_view medal_title(int medal) {
  constexpr std::array<std::string_view, 4> kTitles{"No medal", "Bronze", "Silver", "Gold"};
  return kTitles[static_cast<std::size_t>(std::clamp(medal, 0, 3))];
}

}  // namespace coaster::ui
