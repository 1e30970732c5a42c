// Finds widgets by label path.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "script/host.h"

namespace coaster::script {

inline constexpr std::size_t kMostPathBytes = 1000;  // of a widget's path; longer ones match nothing

// Returns the widgets that match a path, by the first of these rules that finds any: the whole path; its end after a
// slash ("Insert point" for "Track/Insert point"); both ignoring case; its parts in order with others in between
// ("Inspector/x" for "Inspector/Position/x"). Widgets that can be operated take precedence over plain labels.
// A widget's alias counts as its path.
std::vector<std::size_t> find_widgets(std::span<const query::Widget> widgets, std::string_view path);

// Returns the one widget of that path. Code::usage if there is none (with a suggestion) or several (with a list).
base::Result<std::size_t> find_widget(std::span<const query::Widget> widgets, std::string_view path);

// Returns the path's part before the first slash.
std::string_view panel_of(std::string_view path);

// True for a header whose contents are hidden.
bool is_closed_header(const query::Widget& widget);
bool is_on(const query::Widget& widget);

}  // namespace coaster::script
