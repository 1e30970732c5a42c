// Undo and redo stacks and gestures. These functions handle only documents: apply() updates the rest of the session.
#pragma once

#include <string>

#include "edit/session/session.h"

namespace coaster::edit {

// Pushes the step from `before` to `after` on the undo stack and clears the redo stack; drops the oldest steps beyond
// the history's limit, but never this one.
void record(History& history, StepText text, world::Document before, const world::Document& after);
// Turn `document` into the one before the newest step or after the next one; return false if there is none.
bool undo(History& history, world::Document& document);
bool redo(History& history, world::Document& document);

void begin_gesture(History& history, const world::Document& document);
// Makes one step of everything that changed since begin_gesture(); none if nothing changed.
void end_gesture(History& history, const world::Document& document);
// Restores the document from begin_gesture().
void cancel_gesture(History& history, world::Document& document);

// Returns the memory of a step, bytes.
std::size_t bytes_of(const HistoryStep& step);

}  // namespace coaster::edit
