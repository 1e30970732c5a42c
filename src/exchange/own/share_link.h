// A track in the fragment of an address (docs/share.md): the document and the view of it. Opening the link gives both,
// without a file or a server.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {

inline constexpr int kLinkVersion = 1;
inline constexpr std::size_t kMaxLinkBytes = 8192;  // limit of a shared fragment: browsers and chats accept as much

// Returns "#coaster=1.PACKED", to be added to the address of a page. It may be longer than kMaxLinkBytes.
std::string print_link(const world::Document& document, const SharedView& view);

// True if the text is an address with such a fragment, of any version, even damaged. Surrounding blanks are ignored. A
// path counts as a link only if it contains "#coaster=", digits and a dot.
bool is_link(std::string_view text);

// Returns the document, with `view` set. Code::bad_file with one line for everything else: a newer version, a text that
// is cut off, damaged or larger than a track file may be, an invalid track (parse_track()), a document that differs
// from the shared one.
base::Result<LoadedTrack> parse_link(std::string_view text);

// Returns bytes as base64 (RFC 4648) without padding, whose last two digits are given.
std::string base64(std::string_view bytes, std::string_view last_two);

// Returns letters, digits, "-" and "_" only. unpack(pack(text)) is the text.
std::string pack(std::string_view text);

// Returns the text, of at most `most_bytes`. Stops unpacking there, so that memory stays below `most_bytes` and 64 KiB.
// Code::bad_file with a line that describes the error: an invalid character, a text that is cut off or damaged, too
// large.
base::Result<std::string> unpack(std::string_view packed, std::size_t most_bytes);

}  // namespace coaster::exchange
