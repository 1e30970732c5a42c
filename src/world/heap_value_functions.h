// The functions of world/heap_value.h, for the one file that makes those of a type: template class HeapValue<T>.
#pragma once

#include "world/heap_value.h"

namespace coaster::world {

template <class T>
HeapValue<T>::HeapValue() : value_(new T) {}
template <class T>
HeapValue<T>::HeapValue(const HeapValue& other) : value_(new T(*other.value_)) {}
template <class T>
HeapValue<T>& HeapValue<T>::operator=(const HeapValue& other) {
  if (this != &other) *value_ = *other.value_;
  return *this;
}
template <class T>
HeapValue<T>::~HeapValue() {
  delete value_;
}
template <class T>
bool HeapValue<T>::operator==(const HeapValue& other) const {
  return *value_ == *other.value_;
}

}  // namespace coaster::world
