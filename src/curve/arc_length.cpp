#include "curve/arc_length.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"

namespace coaster::curve {
namespace {

using glm::dvec3;

struct Node {
  double x, weight;  // on [-1,1], the positive half; the rule is symmetric
};
// Roots of the Legendre polynomials P8 and P16 and their weights.
constexpr Node kGauss8[] = {{0.183434642495649804939, 0.362683783378361982965},
                            {0.525532409916328985817, 0.313706645877887287337},
                            {0.796666477413626739591, 0.222381034453374470544},
                            {0.960289856497536231683, 0.101228536290376259152}};
constexpr Node kGauss16[] = {{0.095012509837637440185, 0.189450610455068496285},
                             {0.281603550779258913230, 0.182603415044923588866},
                             {0.458016777657227386342, 0.169156519395002538189},
                             {0.617876244402643748446, 0.149595988816576732081},
                             {0.755404408355003033895, 0.124628971255533872052},
                             {0.865631202387831743880, 0.095158511682492784809},
                             {0.944575023073232576077, 0.062253523938647892862},
                             {0.989400934991649932596, 0.027152459411754094851}};

constexpr int kMaxDepth = 24;

double speed(const CoefficientsD& c, double t) {
  const dvec3 d = c.c1 + t * (2.0 * c.c2 + t * (3.0 * c.c3));
  return std::sqrt(glm::dot(d, d));
}

template <std::size_t N>
double gauss(const CoefficientsD& c, double a, double b, const Node (&nodes)[N]) {
  const double half = 0.5 * (b - a), middle = 0.5 * (a + b);
  double sum = 0;
  for (const Node& node : nodes) sum += node.weight * (speed(c, middle - half * node.x) + speed(c, middle + half * node.x));
  return half * sum;
}

// Both rules converge geometrically with the same base r: errors C r^16 and C r^32, so where they agree to 1e-10 the 16-node rule is
// right to about 1e-20 / C. C may be as small as 1e-4 near a bend, hence the wide margin to the 1e-12 that is promised.
// `floor` is an absolute error too small to matter: it ends the subdivision towards a cusp.
double adaptive(const CoefficientsD& c, double a, double b, double floor, int depth) {
  const double fine = gauss(c, a, b, kGauss16);
  const double error = std::abs(fine - gauss(c, a, b, kGauss8));
  if (error <= std::max(1e-10 * fine, floor) || depth >= kMaxDepth) return fine;
  const double middle = 0.5 * (a + b);
  return adaptive(c, a, middle, floor, depth + 1) + adaptive(c, middle, b, floor, depth + 1);
}

// The length of the control polygon, from the coefficients: bounds the arc length from above.
double polygon_length(const CoefficientsD& c) {
  const dvec3 d0 = c.c1 / 3.0, d1 = d0 + c.c2 / 3.0, d2 = d1 + (c.c3 + c.c2 / 3.0);
  return glm::length(d0) + glm::length(d1) + glm::length(d2);
}

// The parameters in (0,1) where |B'| has a minimum: at a cusp it is a kink that nodes may miss, so integrals are split there.
// |B'|^2 is smallest where g = B'.B'' goes from negative to positive; g is a cubic, monotone between the roots of g'.
SlowPoints slow_points(const CoefficientsD& c) {
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
  SlowPoints slow;
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

double split_at_slow_points(const CoefficientsD& c, const SlowPoints& slow, double a, double b, double floor) {
  double sum = 0, from = a;
  for (int i = 0; i < slow.count; ++i) {
    const double t = slow.t[static_cast<std::size_t>(i)];
    if (!(t > from && t < b)) continue;
    sum += adaptive(c, from, t, floor, 0);
    from = t;
  }
  return sum + adaptive(c, from, b, floor, 0);
}

// A curve that slows down to less than a quarter of its fastest may have a cusp between any samples.
bool slows_down(const CoefficientsD& c, double a, double b) {
  double slowest = speed(c, b), fastest = slowest;
  for (int i = 0; i < 8; ++i) {
    const double v = speed(c, a + (b - a) * i / 8.0);
    slowest = std::min(slowest, v);
    fastest = std::max(fastest, v);
  }
  return slowest < 0.25 * fastest;
}

double adaptive_length(const CoefficientsD& c, double a, double b) {
  const double floor = 1e-13 * polygon_length(c);
  return split_at_slow_points(c, slows_down(c, a, b) ? slow_points(c) : SlowPoints{}, a, b, floor);
}

// --- the rows -------------------------------------------------------------------------------------------------------

double gauss_legendre(const Cubic& cubic, int) { return arc_length(cubic); }

double gravesen(const Cubic& c, int) {
  // Paper erratum: half the polygon "multiplied by" the chord is square metres; the estimate is their mean, and errs by at
  // most half their difference.
  const double chord = glm::length(dvec3(c.p3) - dvec3(c.p0));
  const double polygon = glm::length(dvec3(c.p1) - dvec3(c.p0)) + glm::length(dvec3(c.p2) - dvec3(c.p1)) + glm::length(dvec3(c.p3) - dvec3(c.p2));
  return 0.5 * (chord + polygon);
}

double chord_sum(const Cubic& cubic, int steps) {
  double sum = 0;
  dvec3 last(cubic.p0);
  for (int i = 1; i <= steps; ++i) {
    const dvec3 next = point(cubic, static_cast<double>(i) / steps);
    sum += glm::length(next - last);
    last = next;
  }
  return sum;
}

double simpson(const Cubic& cubic, int steps) {
  const CoefficientsD c = coefficients_d(cubic);
  const int n = steps + steps % 2;  // Simpson's rule takes pairs of intervals
  double sum = speed(c, 0) + speed(c, 1);
  for (int i = 1; i < n; ++i) sum += (i % 2 == 1 ? 4.0 : 2.0) * speed(c, static_cast<double>(i) / n);
  return sum / (3.0 * n);
}

double trapezium(const Cubic& cubic, int steps) {
  const CoefficientsD c = coefficients_d(cubic);
  double sum = 0.5 * (speed(c, 0) + speed(c, 1));
  for (int i = 1; i < steps; ++i) sum += speed(c, static_cast<double>(i) / steps);
  return sum / steps;
}

double riemann(const Cubic& cubic, int steps) {
  const CoefficientsD c = coefficients_d(cubic);
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += speed(c, static_cast<double>(i) / steps);
  return sum / steps;
}

constexpr std::array<ArcLengthMethod, 6> kTable{{
    {"gauss_legendre", "Gauss-Legendre, adaptive", "sum of w_i |B'(t_i)|, 16 nodes, halved until 8 nodes agree", gauss_legendre},
    {"gravesen", "Gravesen's mean", "(chord + control polygon) / 2", gravesen},
    {"chord_sum", "Chords of the polyline", "sum of |B(t_(i+1)) - B(t_i)|", chord_sum},
    {"simpson", "Simpson", "h/3 (f_0 + 4 f_1 + 2 f_2 + ... + f_n), f = |B'|", simpson},
    {"trapezium", "Trapezium", "h (f_0/2 + f_1 + ... + f_n/2), f = |B'|", trapezium},
    {"riemann", "Riemann (left)", "h (f_0 + f_1 + ... + f_(n-1)), f = |B'|", riemann},
}};

}  // namespace

std::span<const ArcLengthMethod> arc_length_methods() { return kTable; }

const ArcLengthMethod& arc_length_method(ArcLengthId id) {
  const auto row = static_cast<std::size_t>(id);
  COASTER_CHECK(row < kTable.size(), "the id is a row of the arc-length table");
  return kTable[row];
}

std::optional<ArcLengthId> find_arc_length_method(std::string_view name) {
  for (std::size_t i = 0; i < kTable.size(); ++i)
    if (kTable[i].name == name) return static_cast<ArcLengthId>(i);
  return std::nullopt;
}

double arc_length(const Cubic& cubic, double t0, double t1) { return adaptive_length(coefficients_d(cubic), t0, t1); }

ArcLengthMap::ArcLengthMap(const Cubic& cubic) : c_(coefficients_d(cubic)) {
  const double floor = 1e-13 * polygon_length(c_) / kIntervals;
  if (slows_down(c_, 0.0, 1.0)) slow_ = slow_points(c_);
  for (int i = 0; i < slow_.count; ++i)
    rough_ |= 1u << std::min(static_cast<int>(slow_.t[static_cast<std::size_t>(i)] * kIntervals), kIntervals - 1);
  table_[0] = 0;
  for (int i = 0; i < kIntervals; ++i) {
    const double a = static_cast<double>(i) / kIntervals, b = static_cast<double>(i + 1) / kIntervals, middle = 0.5 * (a + b);
    double length = gauss(c_, a, b, kGauss8);
    // Smooth intervals are right to rounding with 8 nodes; the others (near a cusp) are measured adaptively for good.
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
  // Newton on distance(t) - s with derivative |B'|, halving where it would leave the bracket (a cusp has |B'| = 0).
  for (int i = 0; i < 60; ++i) {
    const double error = s0 + partial(interval, t) - s;
    if (std::abs(error) <= tolerance) break;
    (error > 0 ? high : low) = t;
    const double slope = speed(c_, t);
    const double next = slope > 0 ? t - error / slope : -1.0;
    const double previous = t;
    t = next > low && next < high ? next : 0.5 * (low + high);
    if (std::abs(t - previous) <= 1e-16) break;
  }
  return t;
}

}  // namespace coaster::curve
