#include "world/paint.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace coaster::world {

std::string to_text(Colour colour) { return colour.own() ? fmt::format("#{:06x}", colour.rgb) : "own"; }

std::optional<Colour> parse_colour(std::string_view text) {
  if (text == "own") return Colour{};
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  std::int32_t rgb = 0;
  for (const char c : text.substr(1)) {
    const std::size_t digit = std::string_view("0123456789abcdef").find(c >= 'A' && c <= 'F' ? char(c - 'A' + 'a') : c);
    if (digit == std::string_view::npos) return std::nullopt;
    rgb = 16 * rgb + static_cast<std::int32_t>(digit);
  }
  return Colour{rgb};
}

Paint over(const Paint& paint, const Paint& below) {
  Paint all = paint;
  for (Colour Paint::*const member : Paint::kMembers)
    if (!(all.*member).own()) all.*member = below.*member;
  return all;
}

std::optional<Palette> palette_of(const Paint& paint) {
  const auto* const row = std::ranges::find_if(kPalettes, [&](const PaletteRow& each) {
    Paint whole = paint;
    if (!whole.train.own()) whole.train = each.paint.train;
    return whole == each.paint;
  });
  if (row == std::end(kPalettes)) return std::nullopt;
  return static_cast<Palette>(row - kPalettes);
}

}  // namespace coaster::world
