// A value whose type the owner's header need not define: a struct with a HeapValue<T> compiles with T only declared,
// and only files that read the value include T's header.
#pragma once

namespace coaster::world {

// Never empty. Copying copies the value; it cannot be moved. The functions are in world/heap_value_functions.h: one
// file makes those of a type.
template <class T>
class HeapValue {
 public:
  HeapValue();
  HeapValue(const HeapValue& other);
  HeapValue& operator=(const HeapValue& other);
  ~HeapValue();

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_; }
  const T* operator->() const { return value_; }
  bool operator==(const HeapValue& other) const;

 private:
  T* value_;
};

}  // namespace coaster::world
