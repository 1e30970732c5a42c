// The default arc length, whose bits the ride depends on, and its inversion. The table of methods is in
// arc_length_methods.cpp.
#include "curve/arc_length.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "curve/arc_length_detail.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

struct QuadratureNode {
  double x, weight;  // on [-1,1], the positive half; the rule is symmetric
};
// Roots of the Legendre polynomials P8 and P16 and their weights.
constexpr QuadratureNode kGauss8[] = {{0.183434642495649804939, 0.362683783378361982965},
                                      {0.525532409916328985817, 0.313706645877887287337},
                                      {0.796666477413626739591, 0.222381034453374470544},
                                      {0.960289856497536231683, 0.101228536290376259152}};
constexpr QuadratureNode kGauss16[] = {
    {0.095012509837637440185, 0.189450610455068496285}, {0.281603550779258913230, 0.182603415044923588866},
    {0.458016777657227386342, 0.169156519395002538189}, {0.617876244402643748446, 0.149595988816576732081},
    {0.755404408355003033895, 0.124628971255533872052}, {0.865631202387831743880, 0.095158511682492784809},
    {0.944575023073232576077, 0.062253523938647892862}, {0.989400934991649932596, 0.027152459411754094851}};

constexpr int kMaxDepth = 24;

template <std::size_t N>
double gauss(const CoefficientsD& c, double a, double b, const QuadratureNode (&nodes)[N]) {
  const double half = 0.5 * (b - a), middle = 0.5 * (a + b);
  double sum = 0;
  for (const QuadratureNode& node : nodes)
    sum += node.weight * (c.speed(middle - half * node.x) + c.speed(middle + half * node.x));
  return half * sum;
}

// Returns the error bound of 16 nodes where 8 nodes differ from them by `difference`: its square over the C below, and
// at most the difference itself.
double agreement_error(double fine, double difference) {
  return fine > 0.0 ? std::min(difference, 1e4 * difference * difference / fine) : difference;
}

// Both rules converge geometrically with the same base r: errors C r^16 and C r^32, so where they agree to 1e-10 the
// 16-node rule is right to about 1e-20 / C. C can be as small as 1e-4 near a bend, hence the wide margin to the
// promised 1e-12. `floor` is a negligible absolute error: it ends the subdivision towards a cusp.
double adaptive(const CoefficientsD& c, double a, double b, double floor, int depth) {
  const double fine = gauss(c, a, b, kGauss16);
  const double difference = std::abs(fine - gauss(c, a, b, kGauss8));
  if (difference <= std::max(1e-10 * fine, floor) || depth >= kMaxDepth) return fine;
  const double middle = 0.5 * (a + b);
  return adaptive(c, a, middle, floor, depth + 1) + adaptive(c, middle, b, floor, depth + 1);
}

// Returns the length of the control polygon, an upper bound of the arc length.
double polygon_length(const CoefficientsD& c) { return detail::polygon_length(detail::hodograph(c, 0, 1)); }

// Returns the parameters in (0,1) where |B'| has a minimum. At a cusp it is a kink that nodes may miss, so integrals
// are split there. |B'|^2 is smallest where g = B'.B'' goes from negative to positive; g is a cubic, monotone between
// the roots of g'.
SpeedMinima slow_points(const CoefficientsD& c) {
  const double g0 = glm::dot(c.c1, c.c2) * 2.0, g1 = 4.0 * glm::dot(c.c2, c.c2) + 6.0 * glm::dot(c.c1, c.c3),
               g2 = 18.0 * glm::dot(c.c2, c.c3), g3 = 18.0 * glm::dot(c.c3, c.c3);
  const auto g = [&](double t) { return g0 + t * (g1 + t * (g2 + t * g3)); };
  std::array<double, 4> edges{0.0, 1.0, 1.0, 1.0};
  std::size_t count = 1;
  const double discriminant = g2 * g2 - 3.0 * g3 * g1;
  if (g3 > 0 && discriminant > 0) {
    const double root = std::sqrt(discriminant);
    for (const double t : {(-g2 - root) / (3.0 * g3), (-g2 + root) / (3.0 * g3)})
      if (t > 0 && t < 1) edges[count++] = t;
  }
  edges[count++] = 1.0;
  SpeedMinima slow;
  for (std::size_t i = 0; i + 1 < count; ++i) {
    double low = edges[i], high = edges[i + 1];
    if (!(g(low) < 0 && g(high) > 0)) continue;
    for (int k = 0; k < 55; ++k) {
      const double middle = 0.5 * (low + high);
      (g(middle) < 0 ? low : high) = middle;
    }
    slow.t[slow.count++] = 0.5 * (low + high);
  }
  return slow;
}

double split_at_slow_points(const CoefficientsD& c, const SpeedMinima& slow, double a, double b, double floor) {
  double sum = 0, from = a;
  for (int i = 0; i < slow.count; ++i) {
    const double t = slow.t[static_cast<std::size_t>(i)];
    if (!(t > from && t < b)) continue;
    sum += adaptive(c, from, t, floor, 0);
    from = t;
  }
  return sum + adaptive(c, from, b, floor, 0);
}

// True if the speed falls below a quarter of its maximum: there may be a cusp between any two samples.
bool slows_down(const CoefficientsD& c, double a, double b) {
  double slowest = c.speed(b), fastest = slowest;
  for (int i = 0; i < 8; ++i) {
    const double v = c.speed(a + (b - a) * i / 8.0);
    slowest = std::min(slowest, v);
    fastest = std::max(fastest, v);
  }
  return slowest < 0.25 * fastest;
}

// True if the hodograph cannot be shown to stay away from 0 (kSteady) and the curve does slow down, by samples or at a
// slow point.
constexpr double kSteady = 0.25;
bool nearly_stops(const CoefficientsD& c, double a, double b) {
  if (detail::steadiness(detail::hodograph(c, a, b)) >= kSteady) return false;
  if (slows_down(c, a, b)) return true;
  const SpeedMinima slow = slow_points(c);
  const double usual = std::max(c.speed(a), c.speed(b));
  return std::any_of(slow.t.begin(), slow.t.begin() + slow.count,
                     [&](double t) { return t > a && t < b && c.speed(t) < kSteady * usual; });
}

// Near a stop the two rules may agree by chance, or both miss a kink. So only steady pieces are accepted. The others
// are halved without evaluation, and the piece about the stop is measured by Gravesen's mean once it is shorter than
// `floor`.
double believed(const CoefficientsD& c, double a, double b, double floor, int depth, LengthEstimate& tally) {
  const detail::Hodograph h = detail::hodograph(c, a, b);
  if (detail::steadiness(h) >= kSteady || depth >= kMaxDepth) {
    const double fine = gauss(c, a, b, kGauss16), difference = std::abs(fine - gauss(c, a, b, kGauss8));
    tally.evaluations += 24;
    if (difference <= std::max(1e-10 * fine, floor) || depth >= kMaxDepth) {
      tally.error_bound += agreement_error(fine, difference);
      return fine;
    }
  } else if (const double polygon = detail::polygon_length(h); !(polygon > floor)) {
    tally.error_bound += 0.5 * polygon;
    tally.evaluations += 4;
    return 0.5 * (polygon + detail::chord_length(h));
  }
  const double middle = 0.5 * (a + b);
  return believed(c, a, middle, floor, depth + 1, tally) + believed(c, middle, b, floor, depth + 1, tally);
}

LengthEstimate default_length(const CoefficientsD& c, double a, double b) {
  LengthEstimate total{0.0, 0.0, 0};
  total.length = believed(c, a, b, 1e-13 * polygon_length(c), 0, total);
  total.error_bound += 1e-15 * total.length;  // rounding
  return total;
}

}  // namespace

LengthEstimate measure_arc_length(const Cubic& cubic, double t0, double t1, double relative_tolerance) {
  COASTER_CHECK(t0 <= t1, "arc_length() needs t0 <= t1");
  const CoefficientsD c = coefficients_d(cubic);
  if (!(relative_tolerance > kFinestTolerance)) return default_length(c, t0, t1);
  return detail::adaptive_gauss_legendre(detail::hodograph(c, t0, t1), std::min(relative_tolerance, 0.1));
}

double arc_length(const Cubic& cubic, double t0, double t1, double relative_tolerance) {
  return measure_arc_length(cubic, t0, t1, relative_tolerance).length;
}

ArcLengthMap::ArcLengthMap(const Cubic& cubic) : c_(coefficients_d(cubic)) {
  const double floor = 1e-13 * polygon_length(c_) / kIntervals;
  if (nearly_stops(c_, 0.0, 1.0)) slow_ = slow_points(c_);
  for (int i = 0; i < slow_.count; ++i)
    rough_ |= 1u << std::min(static_cast<int>(slow_.t[static_cast<std::size_t>(i)] * kIntervals), kIntervals - 1);
  table_[0] = 0;
  for (int i = 0; i < kIntervals; ++i) {
    const double a = static_cast<double>(i) / kIntervals, b = static_cast<double>(i + 1) / kIntervals,
                 middle = 0.5 * (a + b);
    double length = gauss(c_, a, b, kGauss8);
    // Eight nodes are exact to rounding on smooth intervals. The others (near a cusp) are always measured adaptively.
    const double halves = rough_ >> i & 1u ? 0.0 : gauss(c_, a, middle, kGauss8) + gauss(c_, middle, b, kGauss8);
    if (std::abs(length - halves) > std::max(1e-14 * length, floor)) {
      rough_ |= 1u << i;
      length = split_at_slow_points(c_, slow_, a, b, floor);
    }
    table_[static_cast<std::size_t>(i) + 1] = table_[static_cast<std::size_t>(i)] + length;
  }
}

double ArcLengthMap::partial(int interval, double t) const {
  const double a = static_cast<double>(interval) / kIntervals;
  if (rough_ >> interval & 1u) return split_at_slow_points(c_, slow_, a, t, 1e-13 * table_.back() / kIntervals);
  return gauss(c_, a, t, kGauss8);
}

double ArcLengthMap::distance(double t) const {
  if (!(t > 0.0)) return 0.0;
  if (t >= 1.0) return length();
  const int interval = std::min(static_cast<int>(t * kIntervals), kIntervals - 1);
  if (t * kIntervals == interval) return table_[static_cast<std::size_t>(interval)];
  return table_[static_cast<std::size_t>(interval)] + partial(interval, t);
}

double ArcLengthMap::parameter(double s) const {
  const double total = length();
  if (!(s > 0.0) || !(total > 0.0)) return 0.0;
  if (s >= total) return 1.0;
  const auto above = std::upper_bound(table_.begin(), table_.end(), s);
  const int interval = static_cast<int>(above - table_.begin()) - 1;
  const double s0 = table_[static_cast<std::size_t>(interval)], s1 = table_[static_cast<std::size_t>(interval) + 1];
  double low = static_cast<double>(interval) / kIntervals, high = static_cast<double>(interval + 1) / kIntervals;
  double t = low + (high - low) * ((s - s0) / (s1 - s0));
  const double tolerance = 4e-16 * total;
  // Newton on distance(t) - s with derivative |B'|; bisects where it would leave the bracket (a cusp has |B'| = 0).
  for (int i = 0; i < 60; ++i) {
    const double error = s0 + partial(interval, t) - s;
    if (std::abs(error) <= tolerance) break;
    (error > 0 ? high : low) = t;
    const double next = t - error / c_.speed(t);
    const double previous = t;
    t = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(t - previous) <= 1e-16) break;
  }
  return t;
}

}  // namespace coaster::curve
