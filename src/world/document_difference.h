// The difference between two documents, which turns one into the other without a full copy: an undo step.
#pragma once

#include <cstddef>
#include <vector>

#include "world/document.h"

namespace coaster::world {

// In one column of a document, `there` items from `at` on replace the `items` of the other document.
template <class T>
struct ColumnEdit {
  int column = 0;  // counted over all of the document's columns
  std::size_t at = 0, there = 0;
  std::vector<T> items;
};
template <class T>
using ColumnEdits = std::vector<ColumnEdit<T>>;

struct DocumentDifference {
  Document rest;  // the other document without entities and order
  Entities::ColumnsOf<ColumnEdits> edits;
  std::size_t tile_bytes = 0;  // of the park's tiles that the two documents do not share
};

// Returns how `other` differs from `document`, bit by bit, entity slots included. Linear in their size; the size of the
// result depends only on what differs.
DocumentDifference difference_of(Document other, const Document& document);

// Turns the document that a difference was made for into the other one, and the difference into its reverse.
void exchange(DocumentDifference& difference, Document& document);

// Returns the memory of a difference, bytes.
std::size_t bytes_of(const DocumentDifference& difference);

}  // namespace coaster::world
