// The unknown members of a file that a document keeps.
#pragma once

#include <string_view>

#include "world/components.h"

namespace coaster::exchange {

// Takes a member out of those that a document has kept, if it is among them.
void drop_member(world::UnknownMembers& kept, std::string_view member);

}  // namespace coaster::exchange
