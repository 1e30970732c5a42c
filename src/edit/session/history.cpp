// Undo and redo by the differences between documents, bit by bit: exact by construction, with memory proportional to
// the changes.
#include "edit/session/history.h"

#include <utility>

namespace coaster::edit {
namespace {

// Applies the newest step of one stack and moves it to the other. Its size may change: the other side may be larger.
template <class From, class To>
bool step_over(History& history, From& from, To& to, world::Document& document) {
  if (from.empty()) return false;
  HistoryStep step = std::move(from.back());
  from.pop_back();
  history.bytes -= bytes_of(step);
  world::exchange(step.change, document);
  history.bytes += bytes_of(step);
  to.push_back(std::move(step));
  return true;
}

}  // namespace

std::size_t bytes_of(const HistoryStep& step) {
  return sizeof(HistoryStep) - sizeof(world::DocumentDifference) + step.text.command.capacity() +
         step.text.sentence.capacity() + world::bytes_of(step.change);
}

void record(History& history, StepText text, world::Document before, const world::Document& after) {
  for (const HistoryStep& step : history.redo) history.bytes -= bytes_of(step);
  history.redo.clear();
  history.undo.push_back({std::move(text), world::difference_of(std::move(before), after)});
  history.bytes += bytes_of(history.undo.back());
  while (history.undo.size() > 1 && history.bytes > history.limit) {
    history.bytes -= bytes_of(history.undo.front());
    history.undo.pop_front();
    ++history.dropped;
  }
}

bool undo(History& history, world::Document& document) {
  return step_over(history, history.undo, history.redo, document);
}

bool redo(History& history, world::Document& document) {
  return step_over(history, history.redo, history.undo, document);
}

void begin_gesture(History& history, const world::Document& document) {
  history.in_gesture = true;
  history.gesture_start = document;
  history.gesture_text = {};
}

void end_gesture(History& history, const world::Document& document) {
  history.in_gesture = false;
  world::Document start = std::exchange(history.gesture_start, {});
  if (!(start == document)) record(history, history.gesture_text, std::move(start), document);
}

void cancel_gesture(History& history, world::Document& document) {
  history.in_gesture = false;
  document = std::exchange(history.gesture_start, {});
}

}  // namespace coaster::edit
