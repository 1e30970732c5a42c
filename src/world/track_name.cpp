#include "world/track_name.h"

#include "world/document.h"

namespace coaster::world {

std::string track_name(const std::string& name, const std::filesystem::path& file) {
  static const std::string kUnnamed = Document{}.name;
  return !file.empty() && (name.empty() || name == kUnnamed) ? file.stem().string() : name;
}

}  // namespace coaster::world
