#include "platform/surface.h"

#include <algorithm>
#include <cstdint>

namespace coaster::platform {
namespace {

int overlap(int a, int a_size, int b, int b_size) {
  return std::max(0, std::min(a + a_size, b + b_size) - std::max(a, b));
}

std::int64_t shared(const WindowPlacement& p, const Screen& s) {
  return std::int64_t{overlap(p.x, p.width, s.x, s.width)} * overlap(p.y, p.height, s.y, s.height);
}

}  // namespace

WindowPlacement fitted(const WindowPlacement& wanted, std::span<const Screen> screens) {
  constexpr int kReach = 100, kTitle = 32;  // px
  if (screens.empty()) return wanted;
  const Screen& on = *std::max_element(screens.begin(), screens.end(), [&](const Screen& a, const Screen& b) {
    return shared(wanted, a) < shared(wanted, b);
  });
  WindowPlacement placed = wanted;
  placed.width = std::min(wanted.width, on.width);
  placed.height = std::min(wanted.height, on.height);
  if (shared(wanted, on) == 0) {
    placed.x = on.x + (on.width - placed.width) / 2;
    placed.y = on.y + (on.height - placed.height) / 2;
    return placed;
  }
  const bool title = placed.y >= on.y && placed.y + kTitle <= on.y + on.height &&
                     overlap(placed.x, placed.width, on.x, on.width) >= std::min(kReach, placed.width);
  if (title) return placed;
  placed.x = std::clamp(placed.x, on.x, on.x + on.width - placed.width);
  placed.y = std::clamp(placed.y, on.y, on.y + on.height - placed.height);
  return placed;
}

}  // namespace coaster::platform
