// Keys by what is printed on them: from their place, and what they type in the layout in use.
#pragma once

#include <string_view>

#include "platform/events.h"

namespace coaster::platform {

// Returns the key at a place of the US layout that types `print` without modifiers (UTF-8; "" if nothing or a dead
// key); Key::unknown if it has no name. A Latin letter is the printed one. The row of digits has the digits, also where
// they need Shift. Other keys are the printed ones, or have their place if the US layout has no key for what is
// printed. In a layout of another script all letters have their US places.
Key key_at(Key place, std::string_view print, bool other_script);

// True if a character is no Latin letter and no symbol. If a key at a letter's place types it, the layout is of another
// script: Cyrillic, Greek, Hebrew.
bool is_other_script(std::string_view print);

}  // namespace coaster::platform
