// The last frame as a PNG file, and its comparison with a golden one.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "app/program.h"

namespace coaster::app {

base::Status write_picture(Program& program, const std::filesystem::path& path);

// The last frame as NAME-1.png, or the first number that is free, after the track's name: in the user's folder of
// pictures ($XDG_PICTURES_DIR, else
// ~/Pictures, else the current folder), a script's in its own. A notice says where it is, or why it is not.
void take_photo(Program& program);

// Puts PNG files side by side into one, each at half its size if asked to. Code::bad_file for one that is no picture.
base::Status write_sheet(const base::Root& root, const std::filesystem::path& path, int columns, bool half,
                         std::span<const std::filesystem::path> pictures);

// Where movies go, each in a folder of its own: the user's of videos ($XDG_VIDEOS_DIR, else ~/Videos, else that of
// pictures), a script's in its own.
std::filesystem::path movie_folder(const Program& program);

// Letters and digits of a track's name, in lower case, joined by "-".
std::string file_stem(const std::string& name);

// By the rule of gfx/image.h. Writes NAME.new.png, NAME.reference.png, NAME.difference.png and NAME.html into `folder`
// when they differ. `update`: writes the golden instead, SCRIPTS/golden/NAME.png, below the folder SCRIPTS.
// Code::expectation when there is no golden or the pictures differ.
base::Status compare_picture(Program& program, const std::string& name, const std::filesystem::path& golden,
                             const std::filesystem::path& folder, bool update);

}  // namespace coaster::app
