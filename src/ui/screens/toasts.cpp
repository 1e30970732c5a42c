// Notices over the bottom of the viewport.
#include "ui/screens/toasts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

constexpr double kFade = 0.4;  // s, the end of its lifetime

double lifetime(edit::NoticeKind kind) { return kind == edit::NoticeKind::info ? 4.0 : 6.0; }

std::uint32_t colour_of(edit::NoticeKind kind) {
  switch (kind) {
    case edit::NoticeKind::info: return palette().accent;
    case edit::NoticeKind::warning: return palette().warning;
    case edit::NoticeKind::error: return palette().error;
  }
  return palette().accent;
}

}  // namespace

void Toasts::update(const edit::Session& session, double seconds, bool scripted) {
  if (!session.notices.list.empty() && session.notices.list.back().serial != serial) {
    const edit::Notice& notice = session.notices.list.back();
    serial = notice.serial;
    show(notice.kind, notice.text, seconds);
  }
  if (!scripted && seconds - since > lifetime(kind)) shown.clear();
}

void Toasts::show(edit::NoticeKind what, std::string text, double seconds) {
  kind = what;
  shown = std::move(text);
  since = seconds;
}

double Toasts::still_for(double seconds) const {
  if (shown.empty()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, lifetime(kind) - kFade - (seconds - since));
}

void Toasts::draw(const Ui& ui, const view::Viewport& viewport) const {
  if (shown.empty()) return;
  const std::string words = in_units(ui, shown);
  const float scale = ui.scale;
  const double seconds = ui.state.seconds;
  const float alpha =
      ui.state.scripted ? 1.0f : static_cast<float>(std::clamp((lifetime(kind) - (seconds - since)) / kFade, 0.0, 1.0));
  const float margin = 12 * scale, pad = 10 * scale, bar = 4 * scale;
  const float room = std::max(40.0f, std::min(520 * scale, viewport.width - 2 * margin) - 2 * pad - bar);
  const ImVec2 size = ImGui::CalcTextSize(words.c_str(), nullptr, false, room);
  const float width = size.x + 2 * pad + bar, height = size.y + 2 * pad * 0.8f;
  const ImVec2 low(std::floor(viewport.x + (viewport.width - width) * 0.5f),
                   std::floor(viewport.y + viewport.height - height - margin));
  const ImVec2 high(low.x + width, low.y + height);
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.AddRectFilled(low, high, packed(palette().raised, 0.96f * alpha), 4 * scale);
  list.AddRectFilled(low, {low.x + bar, high.y}, packed(colour_of(kind), alpha), 4 * scale,
                     ImDrawFlags_RoundCornersLeft);
  list.AddRect(low, high, packed(palette().border, alpha), 4 * scale);
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + bar + pad, low.y + pad * 0.8f},
               packed(palette().text, alpha), words.c_str(), nullptr, room + 1);
}

}  // namespace coaster::ui
