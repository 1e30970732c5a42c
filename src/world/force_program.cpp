#include "world/force_program.h"

#include <algorithm>

#include <fmt/format.h>

namespace coaster::world {
namespace {

bool inside(double value, double low, double high) { return value >= low && value <= high; }  // false for NaN

std::optional<std::string> broken_key(const ForceProgram& program, ForceChannel channel, const ForceKey& key) {
  const ForceChannelRow& row = channel_of(program.of, channel);
  const double longest = longest_of(program.over);
  if (!inside(key.at, 0, longest))
    return fmt::format("a key of {} is at {:.6g} {}, expected 0 to {}", row.name, key.at, unit_of(program.over),
                       longest);
  const auto at = [&] { return fmt::format("the key of {} at {:.6g} {}", row.name, key.at, unit_of(program.over)); };
  if (!inside(key.value, -row.limit, row.limit))
    return fmt::format("{} has the value {:.6g} {}, expected {} to {}", at(), key.value, unit_of(program, channel),
                       -row.limit, row.limit);
  if (!inside(key.slope, -kMostForceSlope, kMostForceSlope))
    return fmt::format("{} has the slope {:.6g}, expected {} to {}", at(), key.slope, -kMostForceSlope,
                       kMostForceSlope);
  if (!inside(key.before, 0, longest) || !inside(key.after, 0, longest))
    return fmt::format("{} has a handle that is not between 0 and {} {} away", at(), longest, unit_of(program.over));
  return {};
}

}  // namespace

std::string_view unit_of(ForceDomain over) { return over == ForceDomain::distance ? "m" : "s"; }
std::string_view unit_of(const ForceProgram& program, ForceChannel channel) {
  if (channel != ForceChannel::roll || program.of == ForceQuantity::curvature)
    return channel_of(program.of, channel).unit;
  return program.over == ForceDomain::distance ? "deg/m" : "deg/s";
}

std::optional<std::string> broken(const ForceProgram& program) {
  if (!base::has_row(program.over)) return "a force section is over distance or time";
  if (!base::has_row(program.of)) return "a force section is of forces or curvature";
  const double low = shortest_of(program.over), high = longest_of(program.over), gap = key_gap_of(program.over);
  const std::string_view unit = unit_of(program.over);
  if (!inside(program.length, low, high))
    return fmt::format("the length is {:.6g} {}, expected {} to {}", program.length, unit, low, high);
  if (!inside(program.tolerance, kLeastTolerance, kMostTolerance))
    return fmt::format("the tolerance is {:.6g} g, expected {} to {}", program.tolerance, kLeastTolerance,
                       kMostTolerance);
  if (!inside(program.speed, 0, 1000)) return fmt::format("the speed is {:.6g} m/s, expected 0 to 1000", program.speed);
  for (std::size_t c = 0; c < program.channels.size(); ++c) {
    const auto channel = static_cast<ForceChannel>(c);
    const std::vector<ForceKey>& keys = program.channels[c];
    if (keys.size() > kMostForceKeys)
      return fmt::format("{} has {} keys, the limit is {}", base::name_of(channel), keys.size(), kMostForceKeys);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (auto wrong = broken_key(program, channel, keys[i])) return wrong;
      if (i > 0 && keys[i].at < keys[i - 1].at)
        return fmt::format("the keys of {} do not ascend: {:.6g} {} follows {:.6g}", base::name_of(channel), keys[i].at,
                           unit, keys[i - 1].at);
      if (i > 0 && !(keys[i].at - keys[i - 1].at >= gap))
        return fmt::format("{} has two keys within {} {} at {:.6g} {}", base::name_of(channel), gap, unit, keys[i].at,
                           unit);
    }
  }
  return {};
}

std::vector<ForceKey> shaping_keys(const ForceProgram& program, ForceChannel channel) {
  std::vector<ForceKey> keys = program.keys(channel);
  if (!keys.empty() && keys.front().at > 0) keys.front().slope = 0;
  if (!keys.empty() && keys.back().at < program.length) keys.back().slope = 0;
  return keys;
}

std::array<glm::dvec2, 4> curve_between(const ForceKey& from, const ForceKey& to) {
  constexpr double kShortest = 0.02;  // fraction of the gap
  const double gap = to.at - from.at;
  double after = from.after > 0 ? std::clamp(from.after, kShortest * gap, gap) : gap / 3,
         before = to.before > 0 ? std::clamp(to.before, kShortest * gap, gap) : gap / 3;
  if (after + before > gap) {
    const double share = gap / (after + before);
    after *= share, before *= share;
  }
  return {glm::dvec2(from.at, from.value), glm::dvec2(from.at + after, from.value + after * from.slope),
          glm::dvec2(to.at - before, to.value - before * to.slope), glm::dvec2(to.at, to.value)};
}

}  // namespace coaster::world
