// The language's words as text, from the tables that also parse it.
#pragma once

#include <string>

namespace coaster::script {

// What --help-script prints: statements, commands, queries with units.
std::string help();

}  // namespace coaster::script
