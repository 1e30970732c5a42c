// How a file of points or rows becomes a track: the words of the command `load` (docs/script.md).
#pragma once

#include <functional>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "world/settings.h"

namespace coaster::exchange {

enum class ImportBank : std::uint8_t { level, automatic };
inline constexpr base::NameRow kImportBanks[] = {
    {"level", "Level", "Rolls follow the horizon."},
    {"auto", "Auto-bank", "Banks each knot until riders feel no lateral g."}};
constexpr std::span<const base::NameRow> rows_of(ImportBank) { return kImportBanks; }

struct ImportOptions {
  std::optional<world::Axis> up;        // of the file; nothing: as proposed for the points
  std::optional<double> scale, smooth;  // metres a unit, nothing: as proposed; m, nothing: through every point
  std::optional<ImportBank> bank;       // nothing: level
  bool origin = false;                  // moves the track to the origin
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("up", self.up), visit("scale", self.scale), visit("smooth", self.smooth), visit("bank", self.bank);
    visit("origin", self.origin);
  }
  friend bool operator==(const ImportOptions&, const ImportOptions&) = default;
};

inline constexpr double kFar = 10'000;  // m: further from the origin, float positions round to 1 mm or more

// Returns the way that rows are moved by to the origin: the middle to x = z = 0, the lowest point to 2 m, by whole mm.
// place(row): its position, m, Y up.
template <class Rows, class JsonLocation>
glm::dvec3 way_to_origin(const Rows& rows, JsonLocation place) {
  glm::dvec3 low = std::invoke(place, rows.front()), high = low;
  for (const auto& row : rows)
    low = glm::min(low, std::invoke(place, row)), high = glm::max(high, std::invoke(place, row));
  const glm::dvec3 middle = 0.5 * (low + high), from(middle.x, low.y - 2, middle.z);
  return 0.0 - glm::round(from * 1000.0) / 1000.0;
}
inline std::string moved_text(glm::dvec3 way) {
  return fmt::format("Moved by ({:.3f}, {:.3f}, {:.3f}) m to the origin.", way.x, way.y, way.z);
}

}  // namespace coaster::exchange
