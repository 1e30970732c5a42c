// Finding widgets by label path.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "script/host.h"

namespace coaster::script {

// The widgets that a path means, by the first of these that finds any: the whole path; its end behind a slash ("Insert
// point" for "Track/Insert point"); both in any case of letters; its parts in order with others between ("Inspector/x"
// for "Inspector/Position/x"). Labels that cannot be worked stand back behind widgets that can.
std::vector<std::size_t> find_widgets(std::span<const WidgetState> widgets, std::string_view path);

// The one widget of that path. Code::usage when there is none (with a suggestion) or several (with a list).
base::Result<std::size_t> find_widget(std::span<const WidgetState> widgets, std::string_view path);

// The path's part before the first slash.
std::string_view panel_of(std::string_view path);

// True for a header whose contents are not shown.
bool is_closed_header(const WidgetState& widget);
bool is_on(const WidgetState& widget);

}  // namespace coaster::script
