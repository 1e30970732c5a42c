// Arc lengths of many segments at once: Gauss-Legendre on the quartic |B'|^2 of four segments side by side, with the
// error estimated from the same samples. Segments that fail the estimate are measured again one by one. The lanes hold
// doubles; the instruction set is chosen at run time.
#include "base/check.h"
#include "curve/arc_length_detail.h"

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define COASTER_HAS_AVX2_LANES 1
#include <immintrin.h>
#define COASTER_AVX2 __attribute__((target("avx2,fma")))
#else
#define COASTER_HAS_AVX2_LANES 0
#endif

namespace coaster::curve {
namespace {

void one_by_one(std::span<const Cubic> cubics, double tolerance, std::span<double> lengths) {
  for (std::size_t i = 0; i < cubics.size(); ++i) lengths[i] = arc_length(cubics[i], 0.0, 1.0, tolerance);
}

#if COASTER_HAS_AVX2_LANES

struct Lanes3 {
  __m256d x, y, z;
};
struct LaneHodograph {
  Lanes3 v0, v1, v2;
};

COASTER_AVX2 inline __m256d splat(double a) { return _mm256_set1_pd(a); }
COASTER_AVX2 inline Lanes3 add(Lanes3 a, Lanes3 b) {
  return {_mm256_add_pd(a.x, b.x), _mm256_add_pd(a.y, b.y), _mm256_add_pd(a.z, b.z)};
}
COASTER_AVX2 inline Lanes3 sub(Lanes3 a, Lanes3 b) {
  return {_mm256_sub_pd(a.x, b.x), _mm256_sub_pd(a.y, b.y), _mm256_sub_pd(a.z, b.z)};
}
COASTER_AVX2 inline Lanes3 scale(double s, Lanes3 a) {
  const __m256d k = splat(s);
  return {_mm256_mul_pd(k, a.x), _mm256_mul_pd(k, a.y), _mm256_mul_pd(k, a.z)};
}
COASTER_AVX2 inline __m256d dot(Lanes3 a, Lanes3 b) {
  return _mm256_fmadd_pd(a.x, b.x, _mm256_fmadd_pd(a.y, b.y, _mm256_mul_pd(a.z, b.z)));
}
COASTER_AVX2 inline __m256d absolute(__m256d a) { return _mm256_andnot_pd(splat(-0.0), a); }

// Loads the twelve coordinates of four cubics, transposed: four floats of each at a time.
COASTER_AVX2 inline LaneHodograph load(const Cubic* four) {
  static_assert(sizeof(Cubic) == 12 * sizeof(float));
  __m256d p[12];
  for (int part = 0; part < 3; ++part) {
    __m128 rows[4];
    for (int lane = 0; lane < 4; ++lane) rows[lane] = _mm_loadu_ps(&four[lane].p0.x + 4 * part);
    _MM_TRANSPOSE4_PS(rows[0], rows[1], rows[2], rows[3]);
    for (int k = 0; k < 4; ++k) p[4 * part + k] = _mm256_cvtps_pd(rows[k]);
  }
  const Lanes3 p0{p[0], p[1], p[2]}, p1{p[3], p[4], p[5]}, p2{p[6], p[7], p[8]}, p3{p[9], p[10], p[11]};
  return {scale(3.0, sub(p1, p0)), scale(3.0, sub(p2, p1)), scale(3.0, sub(p3, p2))};
}

// Returns all bits set in the lanes that are steady enough; same rule as detail::steadiness.
COASTER_AVX2 inline __m256d is_steady(const LaneHodograph& h) {
  const Lanes3 m = add(h.v0, add(h.v1, h.v2));
  const __m256d least = _mm256_min_pd(dot(h.v0, m), _mm256_min_pd(dot(h.v1, m), dot(h.v2, m)));
  const __m256d most = _mm256_max_pd(dot(h.v0, h.v0), _mm256_max_pd(dot(h.v1, h.v1), dot(h.v2, h.v2)));
  // least / sqrt(most m.m) >= s without the root: both sides squared, where least is positive.
  const __m256d wanted =
      _mm256_mul_pd(splat(detail::kSteadyEnough * detail::kSteadyEnough), _mm256_mul_pd(most, dot(m, m)));
  return _mm256_and_pd(_mm256_cmp_pd(least, _mm256_setzero_pd(), _CMP_GT_OQ),
                       _mm256_cmp_pd(_mm256_mul_pd(least, least), wanted, _CMP_GE_OQ));
}

// Returns the lengths of four cubics and a mask of the lanes that meet the tolerance.
template <int kHalf>
COASTER_AVX2 int measure_four(const Cubic* four, const detail::EmbeddedRule<kHalf>& rule, double tolerance,
                              double* lengths) {
  const LaneHodograph h = load(four);
  const Lanes3 sum02 = add(h.v0, h.v2), w0 = scale(0.25, add(sum02, scale(2.0, h.v1))),
               w1 = scale(0.5, sub(h.v2, h.v0)), w2 = scale(0.25, sub(sum02, scale(2.0, h.v1)));
  const __m256d two = splat(2.0), e0 = dot(w0, w0), o1 = _mm256_mul_pd(two, dot(w0, w1)),
                e2 = _mm256_fmadd_pd(two, dot(w0, w2), dot(w1, w1)), o3 = _mm256_mul_pd(two, dot(w1, w2)),
                e4 = dot(w2, w2), zero = _mm256_setzero_pd();
  __m256d sum = zero, even0 = zero, even1 = zero, odd0 = zero, odd1 = zero;
  for (std::size_t i = 0; i < kHalf; ++i) {
    const __m256d u = splat(rule.x[i]), uu = splat(rule.x[i] * rule.x[i]);
    const __m256d e = _mm256_fmadd_pd(uu, _mm256_fmadd_pd(uu, e4, e2), e0),
                  o = _mm256_mul_pd(u, _mm256_fmadd_pd(uu, o3, o1));
    const __m256d plus = _mm256_sqrt_pd(_mm256_max_pd(zero, _mm256_add_pd(e, o))),
                  minus = _mm256_sqrt_pd(_mm256_max_pd(zero, _mm256_sub_pd(e, o)));
    const __m256d both = _mm256_add_pd(plus, minus), change = _mm256_sub_pd(plus, minus);
    sum = _mm256_fmadd_pd(splat(rule.weight[i]), both, sum);
    even0 = _mm256_fmadd_pd(splat(rule.even[0][i]), both, even0);
    even1 = _mm256_fmadd_pd(splat(rule.even[1][i]), both, even1);
    odd0 = _mm256_fmadd_pd(splat(rule.odd[0][i]), change, odd0);
    odd1 = _mm256_fmadd_pd(splat(rule.odd[1][i]), change, odd1);
  }
  _mm256_storeu_pd(lengths, sum);
  // detail::estimated_error <= tolerance * length, times the length.
  const __m256d last =
      _mm256_max_pd(_mm256_max_pd(absolute(even0), absolute(even1)), _mm256_max_pd(absolute(odd0), absolute(odd1)));
  const __m256d error = _mm256_mul_pd(splat(detail::kCoefficientFactor), _mm256_mul_pd(last, last)),
                allowed = _mm256_mul_pd(splat(tolerance), _mm256_mul_pd(sum, sum));
  return _mm256_movemask_pd(_mm256_and_pd(is_steady(h), _mm256_cmp_pd(error, allowed, _CMP_LE_OQ)));
}

template <int kHalf>
COASTER_AVX2 void four_by_four(std::span<const Cubic> cubics, const detail::EmbeddedRule<kHalf>& rule, double tolerance,
                               std::span<double> lengths) {
  std::size_t i = 0;
  for (; i + 4 <= cubics.size(); i += 4) {
    const int met = measure_four(&cubics[i], rule, tolerance, &lengths[i]);
    for (std::size_t lane = 0; met != 15 && lane < 4; ++lane)
      if (!(met >> lane & 1)) lengths[i + lane] = arc_length(cubics[i + lane], 0.0, 1.0, tolerance);
  }
  one_by_one(cubics.subspan(i), tolerance, lengths.subspan(i));
}

bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }

#endif

}  // namespace

void arc_lengths(std::span<const Cubic> cubics, double relative_tolerance, std::span<double> lengths) {
  COASTER_CHECK(cubics.size() == lengths.size(), "`lengths` has the size of `cubics`");
  const double tolerance = std::clamp(relative_tolerance, kFinestTolerance, 0.1);
#if COASTER_HAS_AVX2_LANES
  if (has_avx2())
    return detail::with_rule_for(tolerance, [&](const auto& rule) { four_by_four(cubics, rule, tolerance, lengths); });
#endif
  one_by_one(cubics, tolerance, lengths);
}

}  // namespace coaster::curve
