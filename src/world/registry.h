// A registry that is a value: copy it for a snapshot, compare it for equality. Sparse-set pools over a compile-time
// list of components; no type erasure, no signals.
#pragma once

#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

#include "base/check.h"
#include "world/entity.h"

namespace coaster::world {

// The components of one type, dense, found by entity in O(1). Pointers are valid until the next insert or erase.
template <class T>
class Pool {
 public:
  bool contains(Entity e) const {
    return e.index < sparse_.size() && sparse_[e.index] != kAbsent && entities_[sparse_[e.index]] == e;
  }
  T* find(Entity e) { return contains(e) ? &items_[sparse_[e.index]] : nullptr; }
  const T* find(Entity e) const { return contains(e) ? &items_[sparse_[e.index]] : nullptr; }
  T& get(Entity e) {
    COASTER_CHECK(contains(e), "the entity has this component");
    return items_[sparse_[e.index]];
  }
  const T& get(Entity e) const {
    COASTER_CHECK(contains(e), "the entity has this component");
    return items_[sparse_[e.index]];
  }
  // Adds or replaces a component, including one of an older generation in the same slot.
  T& put(Entity e, T value) {
    COASTER_CHECK(e.valid(), "a component belongs to an entity");
    if (e.index >= sparse_.size()) sparse_.resize(e.index + 1, kAbsent);
    std::uint32_t& slot = sparse_[e.index];
    if (slot == kAbsent) {
      slot = static_cast<std::uint32_t>(items_.size());
      entities_.push_back(e);
      items_.push_back(std::move(value));
    } else {
      entities_[slot] = e;
      items_[slot] = std::move(value);
    }
    return items_[slot];
  }
  // Reserves memory for that many components, so that adding them moves none.
  void reserve(std::size_t count) { entities_.reserve(count), items_.reserve(count); }
  // Returns an entity's component, a default one if it had none.
  T& obtain(Entity e) { return contains(e) ? items_[sparse_[e.index]] : put(e, T{}); }
  // O(1); moves the last item into the gap. No effect if absent.
  void erase(Entity e) {
    if (!contains(e)) return;
    const std::uint32_t slot = sparse_[e.index], last = static_cast<std::uint32_t>(items_.size() - 1);
    if (slot != last) {
      items_[slot] = std::move(items_[last]);
      entities_[slot] = entities_[last];
      sparse_[entities_[slot].index] = slot;
    }
    items_.pop_back();
    entities_.pop_back();
    sparse_[e.index] = kAbsent;
  }
  // Erases components whose entities are not in `others`.
  template <class Other>
  void keep_those_of(const Pool<Other>& others) {
    std::vector<Entity> gone;
    for (const Entity e : entities_)
      if (!others.contains(e)) gone.push_back(e);
    for (const Entity e : gone) erase(e);
  }
  std::size_t size() const { return items_.size(); }
  const std::vector<Entity>& entities() const { return entities_; }  // in the order of items()
  const std::vector<T>& items() const { return items_; }
  std::vector<T>& items() { return items_; }

  // Calls visit(column of each pool...) for each column, to store differences.
  static void for_each_column(auto visit, auto&... pools) {
    visit(pools.sparse_...), visit(pools.entities_...), visit(pools.items_...);
  }

  // True for the same components on the same entities, in any dense order.
  friend bool operator==(const Pool& a, const Pool& b) {
    if (a.size() != b.size()) return false;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const T* other = b.find(a.entities_[i]);
      if (!other || !(*other == a.items_[i])) return false;
    }
    return true;
  }

 private:
  static constexpr std::uint32_t kAbsent = 0xffffffffu;
  std::vector<std::uint32_t> sparse_;
  std::vector<Entity> entities_;
  std::vector<T> items_;
};

template <class... Components>
struct ComponentList {
  // Calls visit.template operator()<C>() for each component, in order.
  template <class Visit>
  static void for_each(Visit visit) {
    (visit.template operator()<Components>(), ...);
  }
};

template <class... Components>
class Registry {
 public:
  Entity create() {
    if (!free_.empty()) {
      const std::uint32_t index = free_.back();
      free_.pop_back();
      return {index, generations_[index]};
    }
    generations_.push_back(0);
    return {static_cast<std::uint32_t>(generations_.size() - 1), 0};
  }
  void destroy(Entity e) {
    COASTER_CHECK(alive(e), "only a living entity can be destroyed");
    (pool<Components>().erase(e), ...);
    ++generations_[e.index];
    free_.push_back(e.index);
  }
  // True for ids made by create() and not destroyed since.
  bool alive(Entity e) const { return e.index < generations_.size() && generations_[e.index] == e.generation; }
  std::size_t size() const { return generations_.size() - free_.size(); }

  template <class T>
  Pool<T>& pool() {
    return std::get<Pool<T>>(pools_);
  }
  template <class T>
  const Pool<T>& pool() const {
    return std::get<Pool<T>>(pools_);
  }
  template <class T>
  T& get(Entity e) {
    return pool<T>().get(e);
  }
  template <class T>
  const T& get(Entity e) const {
    return pool<T>().get(e);
  }
  template <class T>
  const T* find(Entity e) const {
    return pool<T>().find(e);
  }
  // Calls visit(column of each registry...) for each column.
  static void for_each_column(auto visit, auto&... registries) {
    visit(registries.generations_...), visit(registries.free_...);
    (columns_of<Components>(visit, registries...), ...);
  }
  // One Of<T> for each type of items in the columns.
  template <template <class> class Of>
  using ColumnsOf = std::tuple<Of<std::uint32_t>, Of<Entity>, Of<Components>...>;
  template <class T>
  T& put(Entity e, T value) {
    COASTER_CHECK(alive(e), "components go on living entities");
    return pool<T>().put(e, std::move(value));
  }

  friend bool operator==(const Registry& a, const Registry& b) {
    return a.generations_ == b.generations_ && a.pools_ == b.pools_;
  }

 private:
  template <class T>
  static void columns_of(auto visit, auto&... registries) {
    Pool<T>::for_each_column(visit, registries.template pool<T>()...);
  }

  std::vector<std::uint32_t> generations_;
  std::vector<std::uint32_t> free_;
  std::tuple<Pool<Components>...> pools_;
};

// The registry of all components of two lists.
template <class... A, class... B>
Registry<A..., B...> registry_of(ComponentList<A...>, ComponentList<B...>);
template <class A, class B>
using RegistryOf = decltype(registry_of(A{}, B{}));

}  // namespace coaster::world
