// The help text of the script language, from the tables that also parse it.
#pragma once

#include <string>

namespace coaster::script {

// Returns the text of --help-script: statements, commands, queries with units.
std::string help();

}  // namespace coaster::script
