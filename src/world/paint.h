// Paint: the colours of a coaster, or of one section of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/enum_names.h"
#include "world/component_fields.h"

namespace coaster::world {

// A colour as shown on screen (sRGB), or none: then what it paints has the usual colour of the coaster's kind.
struct Colour {
  std::int32_t rgb = -1;  // 0xRRGGBB; -1: none
  bool own() const { return rgb >= 0; }
  friend auto operator<=>(const Colour&, const Colour&) = default;
};
std::string to_text(Colour colour);  // "#d9452f", "own" for none
// Reads what to_text() gives, in capital or small letters.
std::optional<Colour> parse_colour(std::string_view text);

// What one colour paints. Ties of wood keep their own.
enum class PaintPart : std::uint8_t { rails, spine, supports, train };
inline constexpr base::NameRow kPaintParts[] = {{"rails", "Rails", "The rails."},
                                                {"spine", "Spine and ties", "What holds the rails together."},
                                                {"supports", "Supports", "Columns, bents and handrails."},
                                                {"train", "Train", "The bodies of the cars."}};
constexpr std::span<const base::NameRow> rows_of(PaintPart) { return kPaintParts; }
inline constexpr std::size_t kPaintPartCount = std::size(kPaintParts);

// The colours of a track with its trains. Of a section: those that differ from the track's; trains have one paint for
// the whole track, so a section has none for them.
struct Paint {
  Colour rails, spine, supports, train;
  static constexpr Colour Paint::*kMembers[] = {&Paint::rails, &Paint::spine, &Paint::supports, &Paint::train};
  Colour& of(PaintPart part) { return this->*kMembers[static_cast<std::size_t>(part)]; }
  Colour of(PaintPart part) const { return this->*kMembers[static_cast<std::size_t>(part)]; }
  static constexpr void fields(auto visit) {
    visit(Field{"paint_rails", 0, 0, FilePresence::unusual, 1}, &Paint::rails);
    visit(Field{"paint_spine", 0, 0, FilePresence::unusual, 1}, &Paint::spine);
    visit(Field{"paint_supports", 0, 0, FilePresence::unusual, 1}, &Paint::supports);
    visit(Field{"paint_train", 0, 0, FilePresence::unusual, 1}, &Paint::train);
  }
  friend bool operator==(const Paint&, const Paint&) = default;
};

// Returns `paint` with the colours of `below` where it has none.
Paint over(const Paint& paint, const Paint& below);

// Named sets of colours. `own` is the usual paint of the coaster's kind.
enum class Palette : std::uint8_t {
  own,
  red,
  teal,
  sunset,
  forest,
  royal,
  lemon,
  ice,
  night,
  candy,
  copper,
  timber,
  chalk
};
struct PaletteRow {
  std::string_view name, label, help;
  Paint paint;
};
inline constexpr PaletteRow kPalettes[] = {
    {"own", "Usual", "The usual colours of the coaster's kind.", {}},
    {"red", "Red", "Red rails, a dark red spine, white supports.", {{0xd9452f}, {0xa83426}, {0xe4e7eb}, {0x2e5eaa}}},
    {"teal", "Teal", "White rails, teal spine, navy supports.", {{0xf0f0ea}, {0x1a8599}, {0x29385c}, {0xf26b1a}}},
    {"sunset", "Sunset", "Orange rails, violet spine.", {{0xf28c38}, {0x6b3f8c}, {0xe9d8c4}, {0x6b2b66}}},
    {"forest", "Forest", "Cream rails, green spine, brown supports.", {{0xe8dfc4}, {0x2f6b3d}, {0x6b4f33}, {0x8c2f1f}}},
    {"royal", "Royal", "Blue rails, gold spine.", {{0x2a4fb0}, {0xd9a62e}, {0xdfe3ee}, {0xb3202c}}},
    {"lemon", "Lemon", "Yellow rails, blue supports.", {{0xf2c72e}, {0xe0a51f}, {0x2f6fb3}, {0x2f6fb3}}},
    {"ice", "Ice", "Pale blue rails, white supports.", {{0x8fd0e8}, {0x4f8fb8}, {0xf4f8fa}, {0xeaf4f8}}},
    {"night", "Night", "Black track with violet rails.", {{0x7a4fd0}, {0x20222b}, {0x30333d}, {0x20222b}}},
    {"candy", "Candy", "Pink rails, mint spine.", {{0xe85a94}, {0x7fd0ac}, {0xf8ecf2}, {0x9b4fd0}}},
    {"copper", "Copper", "Grey rails, copper spine, sand supports.", {{0x6b6e73}, {0xa0562e}, {0xc7b899}, {0x9e1f1a}}},
    {"timber", "Timber", "Steel straps, brown timber, cream bents.", {{0x8c8f94}, {0x855c38}, {0xdbccae}, {0x9e1f1a}}},
    {"chalk", "Chalk", "White all over.", {{0xf4f4f0}, {0xe4e4de}, {0xf4f4f0}, {0xd8d8d2}}}};
constexpr std::span<const PaletteRow> rows_of(Palette) { return kPalettes; }

// Returns the palette with these colours, if there is one. Paint without a colour for trains, as of a section, is that
// of the palette with its other three.
std::optional<Palette> palette_of(const Paint& paint);

}  // namespace coaster::world
