#include "exchange/own/force_text.h"

#include <fmt/format.h>

#include "base/text.h"

namespace coaster::exchange {
namespace {

constexpr std::size_t kFew = 2, kAll = 5;  // numbers of a key

std::string number_text(double value) { return value == 0 ? "0" : base::to_text(value); }  // not -0

std::string key_text(const world::ForceKey& key) {
  const bool shaped = key.slope != 0 || key.before != 0 || key.after != 0;
  std::string text = fmt::format("[{}, {}", number_text(key.at), number_text(key.value));
  if (shaped)
    text += fmt::format(", {}, {}, {}", number_text(key.slope), number_text(key.before), number_text(key.after));
  return text + "]";
}

bool read_key(Fields& fields, std::string_view channel, std::size_t index, const Json& value, world::ForceKey& key) {
  const auto wrong = [&] {
    return fields.fail(fmt::format("{}[{}]", channel, index),
                       fmt::format("expected {} or {} numbers, found {}", kFew, kAll, describe(value)));
  };
  if (!value.is_array() || (value.size() != kFew && value.size() != kAll)) return wrong();
  double* const members[] = {&key.at, &key.value, &key.slope, &key.before, &key.after};
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_number()) return wrong();
    *members[i] = value[i].get<double>();
    if (*members[i] == 0) *members[i] = 0;  // not -0, which is written as 0
  }
  return true;
}

}  // namespace

std::string force_keys(const world::ForceProgram& force) {
  std::string text;
  for (std::size_t c = 0; c < force.channels.size(); ++c) {
    if (force.channels[c].empty()) continue;
    text += fmt::format(", \"{}\": [", base::name_of(static_cast<world::ForceChannel>(c)));
    for (std::size_t i = 0; i < force.channels[c].size(); ++i)
      text += (i == 0 ? "" : ", ") + key_text(force.channels[c][i]);
    text += "]";
  }
  return text;
}

bool read_force_keys(Fields& fields, world::ForceProgram& force) {
  for (std::size_t c = 0; c < force.channels.size(); ++c) {
    const std::string_view name = base::name_of(static_cast<world::ForceChannel>(c));
    if (!fields.has(name)) continue;
    const Json* const list = fields.list(name, world::kMostForceKeys);
    if (!list) return false;
    force.channels[c].resize(list->size());
    for (std::size_t i = 0; i < list->size(); ++i)
      if (!read_key(fields, name, i, (*list)[i], force.channels[c][i])) return false;
  }
  const auto wrong = world::broken(force);
  return !wrong || fields.fail({}, *wrong);
}

}  // namespace coaster::exchange
