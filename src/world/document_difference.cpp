#include "world/document_difference.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>

#include "base/bits.h"

namespace coaster::world {
namespace {

void for_each_column(auto visit, auto&... documents) {
  visit(documents.track.knots...), visit(documents.track.segments...);
  Entities::for_each_column(visit, documents.entities...);
}

// Compares bits if the type has no other state.
template <class T>
bool same(const T* a, const T* b, std::size_t count) {
  if constexpr (std::is_trivially_copyable_v<T>) return base::same_bits(std::span(a, count), std::span(b, count));
  else return std::equal(a, a + count, b);
}

// Parts of a column: [at, at + there) of one document and `here` items from `at` on of the other.
struct ChangedItems {
  std::size_t at, there, here;
};

// Returns the part between the common start and end of both columns: minimal for an order with an insertion.
template <class T>
std::vector<ChangedItems> middle_of(const std::vector<T>& other, const std::vector<T>& column) {
  const std::size_t common = std::min(other.size(), column.size());
  std::size_t before = 0, after = 0;
  while (before < common && same(&other[before], &column[before], 1)) ++before;
  while (after < common - before && same(&other[other.size() - 1 - after], &column[column.size() - 1 - after], 1))
    ++after;
  if (before + after == std::max(other.size(), column.size())) return {};
  return {{before, column.size() - before - after, other.size() - before - after}};
}

// Returns the runs of items that differ at the same index, and the longer column's end: minimal for a pool. Runs are
// joined where a separate edit would take more memory than the items between them.
template <class T>
std::vector<ChangedItems> places_of(const std::vector<T>& other, const std::vector<T>& column) {
  constexpr std::size_t kBlock = 64, kEdit = sizeof(ColumnEdit<T>), kItem = sizeof(T), kJoin = kEdit / kItem;
  const std::size_t common = std::min(other.size(), column.size());
  std::vector<ChangedItems> places;
  for (std::size_t i = 0; i < common; ++i) {
    if (i % kBlock == 0 && i + kBlock <= common && same(&other[i], &column[i], kBlock)) i += kBlock - 1;
    else if (same(&other[i], &column[i], 1)) continue;
    else if (!places.empty() && i - (places.back().at + places.back().there) <= kJoin)
      places.back().there = places.back().here = i + 1 - places.back().at;
    else places.push_back({i, 1, 1});
  }
  if (other.size() != column.size()) places.push_back({common, column.size() - common, other.size() - common});
  return places;
}

template <class T>
std::size_t bytes_of(const std::vector<ChangedItems>& stretches) {
  std::size_t bytes = stretches.size() * sizeof(ColumnEdit<T>);
  for (const ChangedItems& stretch : stretches) bytes += stretch.here * sizeof(T);
  return bytes;
}

// Only the last edit of a column changes its size, so the positions of the others are valid in both documents.
template <class T>
void exchange(ColumnEdit<T>& edit, std::vector<T>& column) {
  const auto first = column.begin() + static_cast<std::ptrdiff_t>(edit.at),
             last = first + static_cast<std::ptrdiff_t>(edit.there);
  if (edit.items.size() == edit.there) {
    std::swap_ranges(first, last, edit.items.begin());
    return;
  }
  std::vector<T> out(std::make_move_iterator(first), std::make_move_iterator(last));
  const auto place = column.erase(first, last);
  column.insert(place, std::make_move_iterator(edit.items.begin()), std::make_move_iterator(edit.items.end()));
  edit.there = edit.items.size();
  edit.items = std::move(out);
}

// Returns the bytes of the tiles, and of their list, that `tiles` does not share with `others`.
std::size_t own_bytes(const GroundTiles& tiles, const GroundTiles& others) {
  if (&tiles.map() == &others.map()) return 0;
  std::size_t bytes = 0;
  for (const auto& [place, tile] : tiles.map()) {
    constexpr std::size_t kNode = 64;  // of the list
    bytes += kNode + (others.find(place) == tile.get() ? 0 : sizeof(GroundTile));
  }
  return bytes;
}

}  // namespace

DocumentDifference difference_of(Document other, const Document& document) {
  DocumentDifference difference;
  int number = 0;
  for_each_column(
      [&]<class T>(const std::vector<T>& from, const std::vector<T>& column) {
        std::vector<ChangedItems> stretches = middle_of(from, column), places = places_of(from, column);
        if (bytes_of<T>(places) < bytes_of<T>(stretches)) stretches = std::move(places);
        auto& edits = std::get<ColumnEdits<T>>(difference.edits);
        for (const auto& [at, there, here] : stretches) {
          const auto first = from.begin() + static_cast<std::ptrdiff_t>(at);
          edits.push_back({number, at, there, {first, first + static_cast<std::ptrdiff_t>(here)}});
        }
        ++number;
      },
      std::as_const(other), document);
  other.entities = {};
  for (std::vector<Entity>* const list : {&other.track.knots, &other.track.segments})
    *list = std::vector<Entity>();  // `= {}` would keep the memory
  difference.rest = std::move(other);
  difference.tile_bytes = own_bytes(difference.rest.park.tiles, document.park.tiles);
  return difference;
}

void exchange(DocumentDifference& difference, Document& document) {
  int number = 0;
  for_each_column(
      [&]<class T>(std::vector<T>& column) {
        auto& edits = std::get<ColumnEdits<T>>(difference.edits);
        for (auto edit = edits.rbegin(); edit != edits.rend(); ++edit)
          if (edit->column == number) exchange(*edit, column);
        ++number;
      },
      document);
  std::swap(difference.rest, document);
  std::swap(difference.rest.entities, document.entities);
  std::swap(difference.rest.track.knots, document.track.knots);
  std::swap(difference.rest.track.segments, document.track.segments);
  difference.tile_bytes = own_bytes(difference.rest.park.tiles, document.park.tiles);
}

std::size_t bytes_of(const DocumentDifference& difference) {
  const Document& rest = difference.rest;
  std::size_t bytes = sizeof(DocumentDifference) + difference.tile_bytes + rest.name.capacity() +
                      owned_bytes(rest.extra) +
                      (rest.track.knots.capacity() + rest.track.segments.capacity()) * sizeof(Entity);
  const auto add = [&]<class T>(const ColumnEdits<T>& edits) {
    bytes += edits.capacity() * sizeof(ColumnEdit<T>);
    for (const ColumnEdit<T>& edit : edits) {
      bytes += edit.items.capacity() * sizeof(T);
      for (const T& item : edit.items) bytes += owned_bytes(item);
    }
  };
  std::apply([&](const auto&... edits) { (add(edits), ...); }, difference.edits);
  return bytes;
}

}  // namespace coaster::world
