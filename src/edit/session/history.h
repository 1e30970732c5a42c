// Undo and redo stacks and gestures. These functions know documents alone: apply() brings the rest of the session in
// line.
#pragma once

#include <string>

#include "edit/session/session.h"

namespace coaster::edit {

// Puts a step on the undo stack and empties the redo stack; drops the oldest steps beyond `limit` bytes, but never this
// one.
void record(History& history, std::string label, world::Document before, std::size_t limit = kMaxHistoryBytes);
// Exchange `document` with the newest step; false when there is none.
bool undo(History& history, world::Document& document);
bool redo(History& history, world::Document& document);

void begin_gesture(History& history, const world::Document& document);
// One step for all that changed since begin_gesture(), none when nothing did.
void end_gesture(History& history, const world::Document& document);
// The document as it was at begin_gesture().
void cancel_gesture(History& history, world::Document& document);

// Bytes that a snapshot takes, to about 20 %.
std::size_t estimated_bytes(const world::Document& document);

}  // namespace coaster::edit
