// State as text: every query's value, every widget.
#pragma once

#include <span>
#include <string>

#include "script/host.h"

namespace coaster::script {

// A JSON object of all queries; those with an argument once for each entity (document and motion for hash).
std::string state_json(const query::Context& context);
// A widget a line: path, kind, place, size, value, state.
std::string widgets_text(std::span<const WidgetState> widgets);

}  // namespace coaster::script
