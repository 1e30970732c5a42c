// The bytes of the Inter font, which the build embeds when it finds the font.
#include "ui/widgets/inter_font.h"

#include <cstddef>

#ifdef COASTER_HAS_INTER_FONT
namespace coaster::embedded {
extern const unsigned char inter_font[];
extern const std::size_t inter_font_size;
}  // namespace coaster::embedded
#endif

namespace coaster::ui {

std::span<const unsigned char> inter_font() {
#ifdef COASTER_HAS_INTER_FONT
  return {embedded::inter_font, embedded::inter_font_size};
#else
  return {};
#endif
}

}  // namespace coaster::ui
