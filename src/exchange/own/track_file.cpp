// Names of tracks that their files do not tell.
#include "exchange/own/track_file.h"

#include "base/utf8.h"

namespace coaster::exchange {

std::string name_of_file(std::string_view path) {
  const std::string printable = base::printable_utf8(std::filesystem::path(path).stem().string());
  return std::string(base::utf8_start(printable, world::kMaxNameBytes));
}

}  // namespace coaster::exchange
