// Undo and redo stacks and gestures. These functions handle only documents: apply() updates the rest of the session.
#pragma once

#include <string>

#include "edit/session/session.h"

namespace coaster::edit {

// Pushes a step on the undo stack and clears the redo stack; drops the oldest steps beyond `limit` bytes, but never
// this one.
void record(History& history, std::string label, world::Document before, std::size_t limit = kMaxHistoryBytes);
// Exchange `document` with the newest step; return false if there is none.
bool undo(History& history, world::Document& document);
bool redo(History& history, world::Document& document);

void begin_gesture(History& history, const world::Document& document);
// Makes one step of everything that changed since begin_gesture(); none if nothing changed.
void end_gesture(History& history, const world::Document& document);
// Restores the document from begin_gesture().
void cancel_gesture(History& history, world::Document& document);

// Returns the size of a snapshot in bytes, to about 20 %.
std::size_t estimated_bytes(const world::Document& document);

}  // namespace coaster::edit
