// The system's fonts (fontconfig), for characters that the program's own font lacks.
#pragma once

#include <string>
#include <vector>

namespace coaster::platform {

// A font file of outlines, and the font's place in it.
struct SystemFont {
  std::string path;
  int index = 0;
};

// Returns the fonts that together have as many of the characters as the system's fonts have; none without fontconfig.
std::vector<SystemFont> fonts_with(std::vector<unsigned> characters);

}  // namespace coaster::platform
