// Text in the characters of an address: raw deflate (RFC 1951) by zlib, then base64url (RFC 4648) without padding.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace coaster::exchange {

// Returns letters, digits, "-" and "_" only. unpack(pack(text)) is the text.
std::string pack(std::string_view text);

// Returns the text, of at most `most_bytes`. Stops unpacking there, so that memory stays below `most_bytes` and 64 KiB.
// Code::bad_file with a line that describes the error: an invalid character, a text that is cut off or damaged, too
// large.
base::Result<std::string> unpack(std::string_view packed, std::size_t most_bytes);

}  // namespace coaster::exchange
