// Saves the last frame as a PNG file, and compares it with a golden picture.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/program.h"

namespace coaster::app {

base::Status write_picture(Program& program, const std::filesystem::path& path);

// Saves the scene, or with `panels` the whole last frame, as NAME-1.png or with the first unused number, where NAME is
// the track's name, or its file's where nobody has named it: in the user's picture folder ($XDG_PICTURES_DIR, else
// ~/Pictures, else the current folder), in a script's $OUT. A notice gives the path or the error.
void take_photo(Program& program, bool panels);

// Combines PNG files into one, optionally each at half its size. Code::bad_file if one is not a picture.
base::Status write_sheet(const base::FileRoot& root, const std::filesystem::path& path, int columns, bool half,
                         std::span<const std::filesystem::path> pictures);

// Returns a new folder for a movie, "red-comet-movie-1": in the user's video folder ($XDG_VIDEOS_DIR, else ~/Videos,
// else the folder of take_photo()), in a script's $OUT.
std::filesystem::path movie_folder(const Program& program);

// Returns how two PNG files differ, as script::Host says.
std::string picture_difference(std::string_view png, std::string_view other);

// Compares the last frame with a golden picture, by the rule of gfx/image.h. If they differ, writes NAME.new.png,
// NAME.reference.png, NAME.difference.png and NAME.html into `folder`. `update`: writes the golden instead,
// SCRIPTS/golden/NAME.png, below the folder SCRIPTS, if it is missing or differs. Code::expectation if there is no
// golden or the pictures differ.
base::Status compare_picture(Program& program, const std::string& name, const std::filesystem::path& golden,
                             const std::filesystem::path& folder, bool update);

}  // namespace coaster::app
