// The bytes of the Inter font, embedded at build.
#include "ui/inter_font.h"

namespace coaster::ui {

std::span<const unsigned char> inter_font() { return {}; }

}  // namespace coaster::ui
