// What a track is called where people choose among files.
#pragma once

#include <filesystem>
#include <string>

namespace coaster::world {

// Returns the track's name; the name of its file, without the extension, where nobody has named it. "" or the default
// name if it has no file either.
std::string track_name(const std::string& name, const std::filesystem::path& file);

}  // namespace coaster::world
