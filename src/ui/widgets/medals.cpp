#include "ui/widgets/medals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/portable_math.h"
#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

struct Metal {
  std::uint32_t face, rim, star;
};
constexpr std::array<Metal, 3> kMetals{Metal{0xCB8A57, 0x8F5A32, 0xF0C7A4}, Metal{0xC5CCD6, 0x858F9E, 0xF7F9FC},
                                       Metal{0xF0C23B, 0xB07F12, 0xFFF3C4}};

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

void draw_medal(ImDrawList& list, ImVec2 low, float size, int medal, bool earned) {
  const Metal& metal = kMetals[static_cast<std::size_t>(std::clamp(medal, 1, 3) - 1)];
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
