// The options' table as a manual page and as a completion for bash: what is installed beside the program.
#pragma once

#include <string>

namespace coaster::app {

// roff with the macros of man(7), section 6 (games).
std::string manual_page();

// A file for bash-completion: options, names of files by their ending, names of cameras and rates.
std::string bash_completion();

}  // namespace coaster::app
