// Where menu, columns, status bar and viewport lie.
#include "ui/host/layout.h"

#include <algorithm>
#include <cmath>

namespace coaster::ui {
namespace {

float strip_height(float height, float scale, float bar, float middle, Strip strip) {
  constexpr float kDesign = 190, kPart = 0.26f, kMost = 0.5f, kLeast = 4;  // kLeast: bars
  if (middle < kLeast * bar) return 0;
  const float usual = std::min(std::max(kDesign * scale, kPart * height), kMost * middle);
  const float wanted = std::floor(strip.share > 0 ? std::max(strip.share * middle, kLeast * bar) : usual);
  return strip.open && wanted >= kLeast * bar ? wanted : bar;
}

}  // namespace

float fitted_scale(int width, int height, float ui_scale, float content_scale) {
  constexpr float kRoomyWidth = 1000, kRoomyHeight = 560, kSmallest = 0.8f;  // 12 px text: still legible
  const float fit =
      std::min(static_cast<float>(width) / kRoomyWidth, static_cast<float>(height) / kRoomyHeight) / content_scale;
  return ui_scale * content_scale * std::clamp(fit, kSmallest, 1.0f);
}

Layout make_layout(int width, int height, float scale, float bar, bool show_panels, Strip strip) {
  constexpr float kLeft = 300, kRight = 320, kLargestPart = 0.59f;
  const float w = static_cast<float>(width), h = static_cast<float>(height);
  constexpr view::Viewport kNothing{0, 0, 0, 0};
  if (!show_panels) return {kNothing, kNothing, kNothing, kNothing, kNothing, {0, 0, w, h}};
  const float both = std::min((kLeft + kRight) * scale, w * kLargestPart);
  const float left = std::floor(both * kLeft / (kLeft + kRight)), right = std::floor(both * kRight / (kLeft + kRight));
  const float top = std::min(bar, h), bottom = std::max(top, h - bar);
  const float middle = std::max(1.0f, bottom - top), between = std::max(1.0f, w - left - right);
  const float below = strip_height(h, scale, bar, middle, strip);
  Layout layout;
  layout.menu = {0, 0, w, top};
  layout.status = {0, bottom, w, h - bottom};
  layout.left = {0, top, left, middle};
  layout.right = {w - right, top, right, middle};
  layout.scene = {left, top, between, middle - below};
  layout.strip = {left, layout.scene.y + layout.scene.height, between, below};
  return layout;
}

}  // namespace coaster::ui
