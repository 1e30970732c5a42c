// The fields of components. Each component lists them once, in a function that calls visit(Field, member) for each in
// the order of files and hashes:
//
//   static constexpr void fields(auto visit) {
//     visit(Field{"speed", 0, kMaxSpeed, FilePresence::written}, &Equipment::speed);
//   }
//
// Parsing, printing and hashing of documents and the history's estimate of memory read this list.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <type_traits>

namespace coaster::world {

enum class FilePresence {
  required,  // always written, and refused where it is missing
  written,   // always written; where it is missing it has its usual value
  unusual,   // written where it does not have its usual value
};

struct Field {
  std::string_view name = {};  // of the member in files
  double low = 0, high = 0;    // limits of a number; high: of each component of a vector, 0: it is a direction
  FilePresence in_file = FilePresence::required;
  int since = 0;  // later fields of one number count in hashes where one of them is unusual, so that older documents
                  // keep their hashes; 0 always counts
};
inline constexpr std::size_t kMostSince = 6;

template <class T>
concept HasFields = requires {
  T::fields([](const Field&, auto) {});
};

// Calls add(value) for the fields that count in hashes, in order.
template <HasFields T, class Add>
void add_fields(const T& component, Add add) {
  const T usual;
  std::array<bool, kMostSince + 1> counts{true};
  T::fields([&](const Field& field, auto member) {
    if (!(component.*member == usual.*member)) counts[static_cast<std::size_t>(field.since)] = true;
  });
  T::fields([&](const Field& field, auto member) {
    if (counts[static_cast<std::size_t>(field.since)]) add(component.*member);
  });
}

// Returns the bytes of a component's texts and of its lists (list_bytes()).
template <class T>
std::size_t owned_bytes(const T& component) {
  std::size_t bytes = 0;
  if constexpr (requires { component.list_bytes(); }) bytes += component.list_bytes();
  if constexpr (HasFields<T>)
    T::fields([&](const Field&, auto member) {
      if constexpr (std::is_same_v<std::remove_cvref_t<decltype(component.*member)>, std::string>)
        bytes += (component.*member).size();
    });
  return bytes;
}

}  // namespace coaster::world
