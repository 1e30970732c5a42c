// Notices over the bottom of the viewport.
#include "ui/screens/toasts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "ui/widgets/theme.h"

namespace coaster::ui {
namespace {

constexpr double kFade = 0.4;          // s, the end of its lifetime
constexpr double kMoreTime = 2;        // s for each line above the newest notice
constexpr std::size_t kMostLines = 3;  // above it

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

void Toasts::update(const edit::Session& session, double seconds, bool scripted, bool over) {
  if (over) since += seconds - updated;
  updated = seconds;
  const std::vector<edit::Notice>& notices = session.notices.list;
  if (!notices.empty() && notices.back().serial != serial) {
    edit::NoticeKind most = notices.back().kind;
    std::string text;
    std::size_t lines = 0, left_out = 0;
    const std::uint64_t seen = std::max(serial, session.notices.before);
    for (const edit::Notice& notice : std::span(notices).first(notices.size() - 1)) {
      if (notice.serial <= seen || notice.kind == edit::NoticeKind::info) continue;
      most = std::max(most, notice.kind);
      if (lines < kMostLines) text += notice.text + "\n", ++lines;
      else ++left_out;
    }
    if (left_out > 0) text += fmt::format("and {} more\n", left_out);
    serial = notices.back().serial;
    show(most, text + notices.back().text, seconds);
    lasts += kMoreTime * static_cast<double>(lines);
  }
  if (!scripted && seconds - since > lasts) shown.clear();
}

void Toasts::show(edit::NoticeKind what, std::string text, double seconds) {
  kind = what;
  shown = std::move(text);
  since = seconds;
  lasts = lifetime(kind);
}

double Toasts::still_for(double seconds) const {
  if (shown.empty()) return std::numeric_limits<double>::infinity();
  return std::max(0.0, lasts - kFade - (seconds - since));
}

void Toasts::draw(const Ui& ui, const view::Viewport& viewport) const {
  if (shown.empty()) return;
  const std::string words = in_units(ui, shown);
  const float scale = ui.scale;
  const double seconds = ui.state.seconds;
  const float alpha =
      ui.state.scripted ? 1.0f : static_cast<float>(std::clamp((lasts - (seconds - since)) / kFade, 0.0, 1.0));
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
