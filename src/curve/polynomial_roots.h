// Roots in (0, 1) of polynomials in Bernstein form, by halving until the coefficients change sign at most once
// (Descartes' rule of signs for Bernstein's basis: there are as many roots as sign changes, or fewer by an even
// number).
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

#include "curve/bernstein.h"

namespace coaster::curve {

// C(N - 1, i) for i = 0..N - 1.
template <std::size_t N>
constexpr std::array<double, N> binomials() {
  std::array<double, N> c{1};
  for (std::size_t i = 1; i < N; ++i) c[i] = c[i - 1] * static_cast<double>(N - i) / static_cast<double>(i);
  return c;
}

// Returns the coefficients of the product of two polynomials in Bernstein form, of degrees A - 1 and B - 1, or of the
// scalar product of two curves.
template <std::size_t A, std::size_t B, class G2Unknowns>
std::array<double, A + B - 1> product(const std::array<G2Unknowns, A>& a, const std::array<G2Unknowns, B>& b) {
  static constexpr auto x = binomials<A>();
  static constexpr auto y = binomials<B>();
  static constexpr auto whole = binomials<A + B - 1>();
  std::array<double, A + B - 1> c{};
  for (std::size_t i = 0; i < A; ++i)
    for (std::size_t j = 0; j < B; ++j) c[i + j] += x[i] * y[j] * glm::dot(a[i], b[j]);
  for (std::size_t k = 0; k < c.size(); ++k) c[k] *= 1 / whole[k];
  return c;
}

// An interval with one root, where the polynomial goes from negative to positive.
struct Bracket {
  double low = 0, high = 1, guess = 0.5;
};

// Zeros count as positive, so a root at the very end of a half belongs to one of the two halves.
template <std::size_t N>
int sign_changes(const std::array<double, N>& c) {
  unsigned negative = 0;
  for (std::size_t i = 0; i < N; ++i) negative |= static_cast<unsigned>(c[i] < 0) << i;
  return std::popcount((negative ^ negative >> 1) & ((1u << (N - 1)) - 1));
}

template <std::size_t N>
void halve(const std::array<double, N>& c, std::array<double, N>& left, std::array<double, N>& right) {
  std::array<double, N> row = c;
  for (std::size_t level = N; level > 0; --level) {
    left[N - level] = row[0];
    right[level - 1] = row[level - 1];
    for (std::size_t i = 0; i + 1 < level; ++i) row[i] = 0.5 * (row[i] + row[i + 1]);
  }
}

// Returns where the control polygon crosses zero: near the root if it is flat. For coefficients with one sign change.
template <std::size_t N>
double polygon_crossing(const std::array<double, N>& c) {
  std::size_t i = 0;
  while (i + 2 < N && (c[i] < 0) == (c[i + 1] < 0)) ++i;
  return (static_cast<double>(i) + c[i] / (c[i] - c[i + 1])) / static_cast<double>(N - 1);
}

// Calls found(bracket, rising) for every root of odd order. Roots closer together than 1e-7 may count as one or none.
template <std::size_t N, class Found>
void each_crossing(const std::array<double, N>& c, double low, double high, const Found& found) {
  constexpr double kLeastWidth = 1e-7;
  const int changes = sign_changes(c);
  if (changes == 0) return;
  const bool rising = c.front() < 0;
  if (changes == 1) return found(Bracket{low, high, low + polygon_crossing(c) * (high - low)}, rising);
  if (high - low < kLeastWidth) {
    if (changes % 2 == 1) found(Bracket{low, high, 0.5 * (low + high)}, rising);
    return;
  }
  std::array<double, N> left, right;
  halve(c, left, right);
  const double middle = 0.5 * (low + high);
  each_crossing(left, low, middle, found);
  each_crossing(right, middle, high, found);
}

// Calls found(bracket) where the polynomial goes from negative to positive, in order.
template <std::size_t N, class Found>
void each_rise(const std::array<double, N>& c, const Found& found) {
  each_crossing(c, 0, 1, [&](const Bracket& bracket, bool rising) {
    if (rising) found(bracket);
  });
}

// Returns the root in a bracket, accurate to 1e-15, by Newton's method; halves the bracket where a step would leave it.
template <std::size_t N>
double refined_root(const std::array<double, N>& c, Bracket at, bool rising) {
  double t = at.guess;
  for (int i = 0; i < 60 && at.high - at.low > 1e-16; ++i) {
    std::array<double, N> row = c;
    for (std::size_t level = N; level > 2; --level)
      for (std::size_t k = 0; k + 1 < level; ++k) row[k] += t * (row[k + 1] - row[k]);
    const double rise = row[1] - row[0], value = row[0] + t * rise, step = value / (static_cast<double>(N - 1) * rise);
    if (std::abs(step) < 1e-15) break;
    ((value < 0) == rising ? at.low : at.high) = t;
    const bool inside = t - step > at.low && t - step < at.high;
    t = inside ? t - step : 0.5 * (at.low + at.high);
  }
  return t;
}

// Calls found(t), accurate to 1e-15, for the roots of odd order in order.
template <std::size_t N, class Found>
void each_root(const std::array<double, N>& c, const Found& found) {
  each_crossing(c, 0, 1, [&](const Bracket& at, bool rising) { found(refined_root(c, at, rising)); });
}

}  // namespace coaster::curve
