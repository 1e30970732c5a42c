#include "curve/quadrature.h"

#include <vector>

#include "base/check.h"

namespace coaster::curve {
namespace {

constexpr long double kPi = 3.141592653589793238462643383279502884L;

// Taylor's series; |x| <= pi/2, where 16 terms leave less than the rounding of long double.
long double cosine_small(long double x) {
  long double term = 1, sum = 1;
  for (int k = 1; k <= 16; ++k) {
    term *= -x * x / static_cast<long double>((2 * k - 1) * (2 * k));
    sum += term;
  }
  return sum;
}

// cos(pi p / q) for 0 <= p <= q, exactly odd about p = q/2, so that rules are exactly symmetric.
long double cosine_of_share(int p, int q) {
  if (2 * p == q) return 0;
  if (2 * p > q) return -cosine_of_share(q - p, q);
  return cosine_small(kPi * static_cast<long double>(p) / static_cast<long double>(q));
}

struct StoredRule {
  std::vector<long double> nodes, weights;
  std::vector<double> nodes_d, weights_d;

  void round() {
    nodes_d.assign(nodes.begin(), nodes.end());
    weights_d.assign(weights.begin(), weights.end());
  }
};

struct LegendrePair {
  long double last, value;  // P_(n-1), P_n
};
LegendrePair legendre_pair(int n, long double x) {
  LegendrePair p{1, x};
  for (int j = 2; j <= n; ++j) {
    const auto k = static_cast<long double>(j);
    p = {p.value, ((2 * k - 1) * x * p.value - (k - 1) * p.last) / k};
  }
  return p;
}

// Newton's method on P_n from a guess within 1/n^2 of the node, so that four steps reach the rounding error; P_n' = n
// (x P_n - P_(n-1)) / (x^2 - 1), w = 2 / ((1 - x^2) P_n'^2).
StoredRule make_gauss_legendre(int n) {
  StoredRule rule;
  const auto size = static_cast<std::size_t>(n);
  rule.nodes.assign(size, 0);
  rule.weights.assign(size, 0);
  for (int i = 0; i < (n + 1) / 2; ++i) {
    long double x = 2 * i + 1 == n ? 0 : cosine_of_share(4 * i + 3, 4 * n + 2), slope = 1;
    for (int k = 0; k < 5; ++k) {
      const LegendrePair p = legendre_pair(n, x);
      slope = static_cast<long double>(n) * (x * p.value - p.last) / (x * x - 1);
      if (k < 4 && x != 0) x -= p.value / slope;  // the last iteration only updates the slope
    }
    const auto low = static_cast<std::size_t>(i), high = size - 1 - low;
    rule.nodes[low] = -x;
    rule.nodes[high] = x;
    rule.weights[low] = rule.weights[high] = 2 / ((1 - x * x) * slope * slope);
  }
  rule.round();
  return rule;
}

// w_k = c_k/n (1 - sum_j b_j / (4j^2 - 1) cos(2 j k pi / n)), c = 1 at the ends and 2 inside, b = 1 at j = n/2 and 2
// before.
StoredRule make_clenshaw_curtis(int n) {
  StoredRule rule;
  for (int k = 0; k <= n; ++k) {
    long double sum = 1;
    for (int j = 1; j <= n / 2; ++j) {
      int turn = 2 * j * k % (2 * n);  // cos has period 2n in units of pi/n, and is even
      if (turn > n) turn = 2 * n - turn;
      sum -= (2 * j == n ? 1.0L : 2.0L) / static_cast<long double>(4 * j * j - 1) * cosine_of_share(turn, n);
    }
    rule.nodes.push_back(-cosine_of_share(k, n));
    rule.weights.push_back((k == 0 || k == n ? 1.0L : 2.0L) * sum / static_cast<long double>(n));
  }
  if (n == 1) rule.weights = {1, 1};  // the trapezium: the sum above is empty
  rule.round();
  return rule;
}

std::vector<StoredRule> all_rules(StoredRule (*make)(int)) {
  std::vector<StoredRule> rules(1);
  for (int n = 1; n <= kMaxRule; ++n) rules.push_back(make(n));
  return rules;
}

const StoredRule& stored_gauss_legendre(int n) {
  COASTER_CHECK(n >= 1 && n <= kMaxRule, "a rule of 1 to kMaxRule nodes");
  static const std::vector<StoredRule> rules = all_rules(make_gauss_legendre);
  return rules[static_cast<std::size_t>(n)];
}

}  // namespace

long double legendre(int k, long double x) { return k == 0 ? 1 : legendre_pair(k, x).value; }

QuadratureRule gauss_legendre_rule(int n) {
  const StoredRule& rule = stored_gauss_legendre(n);
  return {rule.nodes_d, rule.weights_d};
}

RuleLongDouble gauss_legendre_rule_long_double(int n) {
  const StoredRule& rule = stored_gauss_legendre(n);
  return {rule.nodes, rule.weights};
}

QuadratureRule clenshaw_curtis_rule(int n) {
  COASTER_CHECK(n >= 1 && n <= kMaxRule, "a rule of 1 to kMaxRule intervals");
  static const std::vector<StoredRule> rules = all_rules(make_clenshaw_curtis);
  return {rules[static_cast<std::size_t>(n)].nodes_d, rules[static_cast<std::size_t>(n)].weights_d};
}

}  // namespace coaster::curve
