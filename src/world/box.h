// A value that its owner's header need not know: a struct with a Box<T> compiles with T declared alone, and only files
// that read the value include T's header.
#pragma once

namespace coaster::world {

// Never empty. Copying copies the value; there is no moving. The functions are defined in settings.cpp, for the groups
// of settings alone.
template <class T>
class Box {
 public:
  Box();
  Box(const Box& other);
  Box& operator=(const Box& other);
  ~Box();

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_; }
  const T* operator->() const { return value_; }
  bool operator==(const Box& other) const;

 private:
  T* value_;
};

}  // namespace coaster::world
