// Small dense systems of linear equations, and roots by bisection. The order of operations is fixed, so results have
// the same bits everywhere; a library's may differ from version to version, and documents depend on them.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace coaster::base {

// The ends of an interval.
struct Interval {
  double low = 0, high = 0;
  double middle() const { return 0.5 * (low + high); }
};

// Returns the interval halved `steps` times, each time to its upper half if `below(middle)`. Ends early at neighbouring
// numbers. `low` may be more than `high`.
template <class Below>
Interval bisect(Interval at, int steps, const Below& below) {
  for (int i = 0; i < steps; ++i) {
    const double middle = at.middle();
    if (middle == at.low || middle == at.high) break;
    (below(middle) ? at.low : at.high) = middle;
  }
  return at;
}

// Solves A x = b for the first `count` unknowns by Gauss's elimination with row pivots; b becomes x. False, and both
// are unusable, where no pivot is larger than `least`.
template <std::size_t n>
bool solve_linear(std::array<std::array<double, n>, n>& a, std::array<double, n>& b, std::size_t count = n,
                  double least = 1e-13) {
  for (std::size_t k = 0; k < count; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k + 1; i < count; ++i)
      if (std::abs(a[i][k]) > std::abs(a[pivot][k])) pivot = i;
    if (!(std::abs(a[pivot][k]) > least)) return false;
    std::swap(a[k], a[pivot]), std::swap(b[k], b[pivot]);
    for (std::size_t i = k + 1; i < count; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (std::size_t j = k; j < count; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = count; k-- > 0;) {
    for (std::size_t j = k + 1; j < count; ++j) b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return true;
}

// Returns the solution x of A x = b for a symmetric positive definite A, n x n row by row, of which the lower triangle
// is read: Cholesky's factorisation. Diagonal elements of the factor are at least 1e-6.
inline std::vector<double> solve_positive(std::vector<double> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i * n + j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i * n + k] * a[j * n + k];
      a[i * n + j] = i == j ? std::sqrt(std::max(sum, 1e-12)) : sum / a[j * n + j];
    }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i * n + k] * b[k];
    b[i] /= a[i * n + i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k * n + i] * b[k];
    b[i] /= a[i * n + i];
  }
  return b;
}

}  // namespace coaster::base
