#include "sim/plan/force_curve.h"

#include <algorithm>
#include <cmath>

namespace coaster::sim {
namespace {

using world::ForceChannel;

using Piece = std::array<glm::dvec2, 4>;

double value_of(const Piece& p, int axis, double u) {
  const double rest = 1 - u;
  return rest * rest * (rest * p[0][axis] + 3 * u * p[1][axis]) + u * u * (3 * rest * p[2][axis] + u * p[3][axis]);
}
// Returns a third of the derivative by u.
double rate_of(const Piece& p, int axis, double u) {
  const double rest = 1 - u;
  return rest * rest * (p[1][axis] - p[0][axis]) + 2 * rest * u * (p[2][axis] - p[1][axis]) +
         u * u * (p[3][axis] - p[2][axis]);
}

// Returns the parameter at which the piece's x, which ascends, has that value: Newton within a bracket.
double parameter_at(const Piece& p, double x) {
  const double gap = p[3].x - p[0].x;
  double low = 0, high = 1, u = std::clamp((x - p[0].x) / gap, 0.0, 1.0);
  for (int i = 0; i < 60; ++i) {
    const double off = value_of(p, 0, u) - x, rate = 3 * rate_of(p, 0, u);
    if (std::abs(off) <= 1e-13 * gap) break;
    (off > 0 ? high : low) = u;
    const double next = rate > 0 ? u - off / rate : low;
    u = next > low && next < high ? next : 0.5 * (low + high);
  }
  return u;
}

}  // namespace

ForceCurve::ForceCurve(const world::ForceProgram& program, ForceChannel channel)
    : before_(world::channel_of(program.of, channel).usual), after_(before_) {
  const std::vector<world::ForceKey> keys = world::shaping_keys(program, channel);
  if (!keys.empty()) before_ = keys.front().value, after_ = keys.back().value;
  for (std::size_t i = 1; i < keys.size(); ++i) pieces_.push_back(world::curve_between(keys[i - 1], keys[i]));
}

const ForceCurve::Piece* ForceCurve::piece_at(double x) const {
  auto piece =
      std::upper_bound(pieces_.begin(), pieces_.end(), x, [](double place, const Piece& p) { return place < p[3].x; });
  if (piece == pieces_.end() && !pieces_.empty() && x == pieces_.back()[3].x) --piece;  // the slope of its end
  return piece == pieces_.end() || x < (*piece)[0].x ? nullptr : &*piece;
}

ForceCurve::Value ForceCurve::at(double x) const {
  const Piece* const piece = piece_at(x);
  if (piece == nullptr) return {pieces_.empty() || x > pieces_.back()[3].x ? after_ : before_, 0};
  const double u = parameter_at(*piece, x);
  return {value_of(*piece, 1, u), rate_of(*piece, 1, u) / rate_of(*piece, 0, u)};
}

double ForceCurve::bend_at(double x) const {
  const Piece* const piece = piece_at(x);
  if (piece == nullptr) return 0;
  const Piece& p = *piece;
  const double u = parameter_at(p, x), rate = rate_of(p, 0, u);
  // A sixth of the second derivatives by u; those by u of the first are thirds.
  const auto second = [&](int axis) {
    return (1 - u) * (p[0][axis] - 2 * p[1][axis] + p[2][axis]) + u * (p[1][axis] - 2 * p[2][axis] + p[3][axis]);
  };
  return 2.0 / 3 * (second(1) * rate - rate_of(p, 1, u) * second(0)) / (rate * rate * rate);
}

void insert_on_curve(world::ForceProgram& program, ForceChannel channel, double at) {
  const ForceCurve::Value there = ForceCurve(program, channel).at(at);
  std::vector<world::ForceKey> keys = world::shaping_keys(program, channel);
  const auto next = std::upper_bound(keys.begin(), keys.end(), at,
                                     [](double place, const world::ForceKey& key) { return place < key.at; });
  world::ForceKey key{at, there.value, there.slope};
  if (next != keys.begin() && next != keys.end()) {
    const Piece p = world::curve_between(next[-1], *next);
    const double u = parameter_at(p, at);
    const double middle = std::lerp(p[1].x, p[2].x, u);
    next[-1].after = u * (p[1].x - p[0].x), next->before = (1 - u) * (p[3].x - p[2].x);
    key.before = at - std::lerp(std::lerp(p[0].x, p[1].x, u), middle, u);
    key.after = std::lerp(middle, std::lerp(p[2].x, p[3].x, u), u) - at;
  }
  keys.insert(next, key);
  program.keys(channel) = std::move(keys);
}

}  // namespace coaster::sim
