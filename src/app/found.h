// What a long job finds for the command that follows it: a file's track, the values of a search, or a way home. Also as
// text, in which a page's worker hands it over.
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"
#include "edit/perform/found.h"

namespace coaster::app {

using edit::Found;

// parse_found(print_found(f)) equals f: documents by hash, numbers exactly. Of a way home only what a command needs:
// not the figures of its fit. Tracks have no SharedView: links are read at once.
std::string print_found(const base::Result<Found>& found);
// Code::io for a text that print_found() does not print.
base::Result<Found> parse_found(std::string_view text);

}  // namespace coaster::app
