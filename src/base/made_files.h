// The list of the files that runs made in a folder (kMadeList). Runs replace and remove no other files there.
#pragma once

#include <string>
#include <string_view>

namespace coaster::base {

bool is_there(int folder, const std::string& name);  // in an open folder; links are not followed

// Returns the list's text, a line for each file, and whether it has a file.
std::string made_in(int folder);
bool is_made(const std::string& list, std::string_view name);
// Adds a file to the list. Where that fails the file is not replaced later.
void note_made(int folder, const std::string& name);

}  // namespace coaster::base
