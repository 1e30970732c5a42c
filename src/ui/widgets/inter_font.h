// The bytes of the Inter font, embedded at build; empty when the build found no such font.
#pragma once

#include <span>

namespace coaster::ui {

std::span<const unsigned char> inter_font();

}  // namespace coaster::ui
