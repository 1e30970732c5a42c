// Undo and redo by whole documents: exact by construction, with memory bounded by kMaxHistoryBytes.
#include "edit/session/history.h"

#include <utility>

namespace coaster::edit {
namespace {

void push_undo(History& history, HistoryStep step, std::size_t limit) {
  history.undo_bytes += estimated_bytes(step.document);
  history.undo.push_back(std::move(step));
  while (history.undo.size() > 1 && history.undo_bytes > limit) {
    history.undo_bytes -= estimated_bytes(history.undo.front().document);
    history.undo.pop_front();
  }
}

}  // namespace

std::size_t estimated_bytes(const world::Document& document) {
  const auto& entities = document.entities;
  // Each pool keeps item, entity and a sparse slot; the registry a generation; the track an id for each knot and
  // segment.
  constexpr std::size_t kIds = sizeof(world::Entity) * 2 + 2 * sizeof(std::uint32_t);
  std::size_t bytes = sizeof(world::Document) + document.name.size() + document.extra.json.size();
  entities.for_each_pool([&]<class T>(const world::Pool<T>& pool) {
    bytes += pool.size() * (sizeof(T) + kIds);
    for (const T& component : pool.items()) bytes += world::text_bytes(component);
  });
  return bytes;
}

void record(History& history, std::string label, world::Document before, std::size_t limit) {
  history.redo.clear();
  push_undo(history, {std::move(label), std::move(before)}, limit);
}

bool undo(History& history, world::Document& document) {
  if (history.undo.empty()) return false;
  HistoryStep step = std::move(history.undo.back());
  history.undo.pop_back();
  history.undo_bytes -= estimated_bytes(step.document);
  std::swap(step.document, document);
  history.redo.push_back(std::move(step));
  return true;
}

bool redo(History& history, world::Document& document) {
  if (history.redo.empty()) return false;
  HistoryStep step = std::move(history.redo.back());
  history.redo.pop_back();
  std::swap(step.document, document);
  push_undo(history, std::move(step), kMaxHistoryBytes);
  return true;
}

void begin_gesture(History& history, const world::Document& document) {
  history.in_gesture = true;
  history.gesture_start = document;
  history.gesture_label.clear();
}

void end_gesture(History& history, const world::Document& document) {
  history.in_gesture = false;
  world::Document start = std::exchange(history.gesture_start, {});
  if (!(start == document)) record(history, history.gesture_label, std::move(start));
}

void cancel_gesture(History& history, world::Document& document) {
  history.in_gesture = false;
  document = std::exchange(history.gesture_start, {});
}

}  // namespace coaster::edit
