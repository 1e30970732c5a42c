#include "exchange/fvd/fvd_function.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/portable_math.h"

namespace coaster::exchange {
namespace {

// Shifts the middle of a piece, and makes it steeper in its middle or at its ends.
double warped(const FvdPiece& piece, double x) {
  constexpr double kNone = 0.0005;
  if (piece.centre > 0) x = std::pow(x, std::exp2(piece.centre / 2));
  if (piece.centre < 0) x = 1 - std::pow(1 - x, std::exp2(-piece.centre / 2));
  const double t = piece.tension, hurry = 2 * (x - 0.5);
  if (t > kNone) return 0.5 * (std::sinh(t * hurry) / std::sinh(t) + 1);
  if (t < -kNone) return 0.5 * (std::asinh(std::sinh(t) * hurry) / t + 1);
  return x;
}

// Goes from 0 over two extrema back to 0, with slope 0 at both ends, and is 0 at `zero`; one extremum is 1.
double two_humps(double x, double form) {
  const double zero = std::abs(form) / 10, root = std::sqrt(9 + 16 * zero * (zero - 1));
  const auto humps = [&](double at) { return at * at * (at - 1) * (at - 1) * (at - zero); };
  const double peak = humps((3 + 4 * zero + (form > 0 ? root : -root)) / 10);
  return peak == 0 ? 0 : humps(x) / peak;
}

// True if the piece returns to its start value, with which the next piece begins.
bool returns(const FvdPiece& piece) {
  switch (piece.shape) {
    case FvdShape::quadratic: return std::abs(piece.form) < 0.5;
    case FvdShape::quartic: return piece.form < 0;
    case FvdShape::quintic: return std::abs(piece.form) > 0.005;
    case FvdShape::plateau: return true;
    default: return false;
  }
}

// Returns the fraction of the change at a fraction x of the piece.
double shape_at(const FvdPiece& piece, double x) {
  const double y = 1 - x, form = piece.form;
  switch (piece.shape) {
    case FvdShape::quadratic:
      if (returns(piece)) return 4 * x * y;
      return form < 0 ? 1 - y * y : x * x;
    case FvdShape::cubic: return x * x * (3 - 2 * x);
    case FvdShape::quartic:
      if (returns(piece)) return 16 * x * x * y * y;
      return x * x * (x * (4 * form + 4) - 6 * form - 3 * x * x) /
             (std::abs(1 - 2 * form) < 1e-3 ? 1e-3 : 1 - 2 * form);
    case FvdShape::quintic:
      if (returns(piece)) return two_humps(x, form);
      return x * x * x * (10 + x * (6 * x - 15));
    case FvdShape::sinusoidal: return 0.5 * (1 - base::sin_cos(base::kPi * x).cos);
    case FvdShape::plateau: {
      const double side = 1 - std::abs(2 * x - 1);
      return 1 - std::exp(-15 * form * side * side * side);
    }
    default: return x;
  }
}

// Returns a quartic that begins with the rate and its slope, ends with both 0, and turns by -roll in total.
double to_horizon(const FvdPiece& piece, double x, const FvdLevelling& from) {
  const double rate = piece.start, mean = -from.roll / std::max(piece.to - piece.from, 1e-6), slope = from.slope;
  const double quartic = -2.5 * (slope + 6 * (rate - 2 * mean)), cubic = 6 * slope + 32 * rate - 60 * mean,
               square = -4.5 * slope - 18 * rate + 30 * mean;
  return rate + x * (slope + x * (square + x * (cubic + x * quartic)));
}

double end_of(const FvdPiece& piece) {
  if (piece.shape == FvdShape::to_zero) return 0;
  return piece.start + (returns(piece) ? 0 : piece.change);
}

// Adds keys strictly between two, where their curve differs from f.
void refine(const std::function<double(double)>& f, const world::ForceKey& from, const world::ForceKey& to,
            double tolerance, double gap, std::vector<world::ForceKey>& keys) {
  constexpr int kChecks = 8;
  const double length = to.at - from.at;
  if (length < 2 * gap || keys.size() > world::kMostForceKeys) return;
  double worst = 0;
  for (int i = 1; i < kChecks; ++i) {
    const double u = i / double(kChecks), v = 1 - u;
    const double curve = from.value * v * v * (1 + 2 * u) + to.value * u * u * (3 - 2 * u) +
                         length * u * v * (from.slope * v - to.slope * u);
    worst = std::max(worst, std::abs(curve - f(from.at + u * length)));
  }
  if (worst <= tolerance) return;
  const double middle = (from.at + to.at) / 2, step = std::min(length / 20, 1e-3);
  const world::ForceKey key{middle, f(middle), (f(middle + step) - f(middle - step)) / (2 * step)};
  refine(f, from, key, tolerance, gap, keys);
  keys.push_back(key);
  refine(f, key, to, tolerance, gap, keys);
}

}  // namespace

double value_of(const FvdPiece& piece, double x, const FvdLevelling& levelling) {
  const double length = piece.to - piece.from;
  const double share = length > 0 ? std::clamp((x - piece.from) / length, 0.0, 1.0) : 1.0;
  const double place = warped(piece, share);
  if (piece.shape == FvdShape::to_zero) return to_horizon(piece, place, levelling);
  return piece.start + piece.change * shape_at(piece, place);
}

const FvdPiece& piece_at(const FvdFunction& function, double x) {
  const auto found = std::ranges::find_if(function, [&](const FvdPiece& piece) { return piece.to >= x; });
  return found == function.end() ? function.back() : *found;
}

void join_pieces(FvdFunction& function, double start, double length) {
  for (FvdPiece& piece : function) {
    piece.start = start, start = end_of(piece);
    if (piece.follows) piece.to = std::max(length, piece.from);
  }
}

double shared_length(std::span<const FvdFunction* const> functions) {
  double length = std::numeric_limits<double>::infinity();
  for (const FvdFunction* const function : functions)
    if (std::ranges::none_of(*function, &FvdPiece::follows)) length = std::min(length, function->back().to);
  return std::isfinite(length) ? length : 0;
}

std::vector<world::ForceKey> keys_along(const std::function<double(double)>& f, std::vector<double> corners,
                                        double length, double tolerance, double gap, double limit) {
  std::erase_if(corners, [&](double at) { return !(at > 1.5 * gap && at < length - 1.5 * gap); });
  std::ranges::sort(corners);
  const double step = gap / 50;
  std::vector<world::ForceKey> ends{{0, f(0), (f(step) - f(0)) / step}};
  for (const double at : corners) {
    if (at - ends.back().at < 1.5 * gap) continue;
    const double before = at - 0.51 * gap, after = at + 0.51 * gap;
    const double slope = (f(before) - f(before - step)) / step, next = (f(after + step) - f(after)) / step;
    if (std::abs(f(after) - f(before) - (after - before) * slope) + gap * std::abs(next - slope) < tolerance) {
      ends.push_back({at, f(at), (next + slope) / 2});
    } else {
      ends.push_back({before, f(before), slope});
      ends.push_back({after, f(after), next});
    }
  }
  ends.push_back({length, f(length), (f(length) - f(length - step)) / step});
  std::vector<world::ForceKey> keys;
  do {
    keys = {ends.front()};
    for (std::size_t i = 1; i < ends.size(); ++i) {
      if (ends[i].at - ends[i - 1].at > 1.01 * gap) refine(f, ends[i - 1], ends[i], tolerance, gap, keys);
      keys.push_back(ends[i]);
    }
    tolerance *= 2;
  } while (keys.size() > world::kMostForceKeys && ends.size() <= world::kMostForceKeys);
  if (keys.size() > world::kMostForceKeys) keys.resize(world::kMostForceKeys);
  for (world::ForceKey& key : keys) {
    key.value = std::clamp(key.value, -limit, limit);
    key.slope = std::clamp(key.slope, -world::kMostForceSlope, world::kMostForceSlope);
  }
  const bool level = std::ranges::all_of(keys, [&](const world::ForceKey& key) {
    return std::abs(key.value - keys.front().value) < 1e-9 && std::abs(key.slope) < 1e-9;
  });
  if (level) keys.resize(1), keys.front().slope = 0;
  return keys;
}

}  // namespace coaster::exchange
