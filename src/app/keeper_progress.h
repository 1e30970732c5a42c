// Loads and saves the progress in challenges.
#pragma once

#include <string>
#include <vector>

namespace coaster::app {

struct Keeper;
struct Program;

// At the start. Problems with the file are added to `problems`.
void load_progress(Program& program, Keeper& keeper, std::vector<std::string>& problems);
// Writes what has been earned since.
void watch_progress(Program& program, Keeper& keeper);

}  // namespace coaster::app
