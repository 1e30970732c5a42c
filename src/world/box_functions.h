// The functions of world/box.h, for the one file that makes those of a type: template class Box<T>.
#pragma once

#include "world/box.h"

namespace coaster::world {

template <class T>
Box<T>::Box() : value_(new T) {}
template <class T>
Box<T>::Box(const Box& other) : value_(new T(*other.value_)) {}
template <class T>
Box<T>& Box<T>::operator=(const Box& other) {
  if (this != &other) *value_ = *other.value_;
  return *this;
}
template <class T>
Box<T>::~Box() {
  delete value_;
}
template <class T>
bool Box<T>::operator==(const Box& other) const {
  return *value_ == *other.value_;
}

}  // namespace coaster::world
