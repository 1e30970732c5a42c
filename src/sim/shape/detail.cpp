#include "sim/shape/detail.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::sim {

Detail detail_of(const Derived& derived) {
  Detail detail;
  detail.parts = derived.length <= kMaxDetailedLength;
  const std::size_t segments = derived.order.size();
  while (static_cast<std::size_t>(detail.most_rings) * segments > kMaxAllRings && detail.most_rings > 2)
    detail.most_rings = std::max(2, detail.most_rings / 2);
  if (static_cast<std::size_t>(detail.most_rings) * segments > kMaxAllRings) detail.most_rings = 0;
  detail.parts = detail.parts && detail.most_rings > 0;
  while (derived.length / detail.table_step > kMaxTableEntries) detail.table_step *= 2;
  return detail;
}

std::string detail_text(const Detail& detail) {
  std::string text;
  if (detail.most_rings == 0) text = "The track is drawn as a curve alone.";
  else if (!detail.parts) text = "Ties, equipment and supports are drawn only near the eye.";
  if (detail.table_step > kTableStep)
    text += fmt::format("{}Forces are computed every {} m.", text.empty() ? "" : " ", base::to_text(detail.table_step));
  return text.empty() ? text : "This is a very long track. " + text;
}

}  // namespace coaster::sim
