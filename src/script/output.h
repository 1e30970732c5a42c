// State as text: the values of all queries, all widgets.
#pragma once

#include <span>
#include <string>

#include "script/host.h"

namespace coaster::script {

// Returns a JSON object of all queries; queries with an argument appear once per entity (document and motion for hash).
std::string state_json(const query::Context& context);
// Returns one line per widget: path, kind, position, size, value, state.
std::string widgets_text(std::span<const WidgetState> widgets);

}  // namespace coaster::script
