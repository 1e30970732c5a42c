#include "base/names.h"

namespace coaster::base {

std::string alternatives(std::span<const std::string> names, std::string_view quote) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 < names.size() ? ", " : " or ";
    text += std::string(quote) + names[i] + std::string(quote);
  }
  return text;
}

}  // namespace coaster::base
