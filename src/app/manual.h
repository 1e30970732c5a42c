// The manual page and the bash completion, from the table of options.
#pragma once

#include <string>

namespace coaster::app {

// roff with the macros of man(7), section 6 (games).
std::string manual_page();

// Returns a file for bash-completion: options, file names by extension, names of cameras and rates.
std::string bash_completion();

}  // namespace coaster::app
