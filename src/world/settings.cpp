// The boxes of the groups of settings.
#include "world/settings.h"

#include "world/aids.h"
#include "world/camera_feel.h"
#include "world/evaluation.h"
#include "world/lab_view.h"
#include "world/look.h"
#include "world/panels.h"

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

template class Box<Aids>;
template class Box<CameraFeel>;
template class Box<Evaluation>;
template class Box<LabView>;
template class Box<Look>;
template class Box<Panels>;

}  // namespace coaster::world
