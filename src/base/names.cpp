#include "base/names.h"

#include <fmt/format.h>

namespace coaster::base {

std::string alternatives(std::span<const std::string> names, std::string_view quote) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += fmt::format("{}{}{}{}", i == 0 ? "" : i + 1 < names.size() ? ", " : " or ", quote, names[i], quote);
  return text;
}

}  // namespace coaster::base
