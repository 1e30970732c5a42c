// A track in the fragment of an address (docs/share.md): the document, and how it was seen. Whoever opens the link gets
// both, with no file and no server.
#pragma once

#include <string>
#include <string_view>

#include "exchange/own/track_file.h"

namespace coaster::exchange {

inline constexpr int kLinkVersion = 1;
inline constexpr std::size_t kMaxLinkBytes = 8192;  // of a fragment that is shared: browsers and chats keep so much

// Returns "#coaster=1.PACKED", to be added to the address of a page. It may be longer than kMaxLinkBytes.
std::string print_link(const world::Document& document, const SharedView& view);

// Returns whether the text is an address with such a fragment, of any version, damaged or not. Blanks around it do not
// count. A path is none unless it holds "#coaster=", digits and a dot.
bool is_link(std::string_view text);

// Returns the document, with `view` set. Code::bad_file with one line for everything else: a newer version, a text
// that is cut off, damaged or larger than a track file may be, a bad track (parse_track()), another document than
// the one that was shared.
base::Result<LoadedTrack> parse_link(std::string_view text);

}  // namespace coaster::exchange
