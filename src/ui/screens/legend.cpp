#include "ui/screens/overlays.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "ui/plots/plot_ticks.h"
#include "ui/widgets/theme.h"
#include "view/colour_map.h"
#include "world/lab_view.h"

namespace coaster::ui {
namespace {

ImU32 opaque(glm::vec3 colour) { return ImGui::ColorConvertFloat4ToU32({colour.x, colour.y, colour.z, 1}); }

// Draws from left to right, interpolated as in the shader.
void draw_bar(ImDrawList& list, ImVec2 at, float width, float height) {
  constexpr std::size_t kPieces = view::kColourStops.size() - 1;
  for (std::size_t i = 0; i < kPieces; ++i) {
    const float left = at.x + width * static_cast<float>(i) / kPieces,
                right = at.x + width * static_cast<float>(i + 1) / kPieces;
    const ImU32 from = opaque(view::kColourStops[i]), to = opaque(view::kColourStops[i + 1]);
    list.AddRectFilledMultiColor({left, at.y}, {right, at.y + height}, from, to, to, from);
  }
}

}  // namespace

void draw_legend(Ui& ui, const view::Viewport& scene) {
  const world::Settings& settings = ui.session().settings;
  if (settings.lab->colouring == world::Colouring::plain || !settings.lab->layers.has(world::Layer::legend)) return;
  const world::ColouringRow& row = base::row_of(settings.lab->colouring);
  const base::ShownUnit unit = base::shown_in(ui.units, row.unit);
  const float scale = ui.scale, margin = std::floor(14 * scale), pad = std::floor(10 * scale),
              bar = std::floor(11 * scale);
  const float text = small_pixels();
  const float width = std::min(std::floor(240 * scale), scene.width - 2 * (margin + pad)),
              height = 2 * text + bar + std::floor(10 * scale);
  if (width < 120 * scale || scene.height < height + 2 * (margin + pad)) return;
  const ImVec2 low(scene.x + margin + pad, scene.y + margin + pad);  // notices and hints are at the bottom
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled({low.x - pad, low.y - pad}, {low.x + width + pad, low.y + height + pad},
                     packed(palette().background, 0.82f), std::floor(6 * scale));
  draw_small(list, low, palette().text, fmt::format("{} ({})", row.label, unit.name));
  const ImVec2 bar_at(low.x, low.y + text + std::floor(5 * scale));
  draw_bar(list, bar_at, width, bar);
  const AxisRange axis{ui.state.stats.colour_low * unit.factor, ui.state.stats.colour_high * unit.factor};
  const Ticks marks = ticks(axis, 6);
  float free_from = low.x;  // texts that would touch the previous one are left out
  for (const double value : marks.major) {
    const float x = std::floor(low.x + width * static_cast<float>(part_of(axis, value)));
    const std::string number = tick_text(axis, marks, value, true);
    const float wide = small_size(number).x;
    list.AddLine({x, bar_at.y + bar}, {x, bar_at.y + bar + 4 * scale}, packed(palette().dim));
    const float left = std::clamp(x - wide * 0.5f, low.x, low.x + width - wide);
    if (left < free_from) continue;
    draw_small(list, {left, bar_at.y + bar + std::floor(5 * scale)}, palette().dim, number);
    free_from = left + wide + std::floor(6 * scale);
  }
}

}  // namespace coaster::ui
