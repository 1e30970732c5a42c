// The curve that NoLimits 2 makes of an element's vertices and rolls, written from the rule alone
// (docs/track-format.md) with the recurrence of Cox and de Boor in long double: an oracle that shares no code with
// reader and writer.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

namespace coaster::test {

struct RuleVertex {
  glm::dvec3 p{0};
  bool strict = false;
  double weight = 1;
};

struct RuleRoll {
  double coord = 0;
  glm::dvec3 up{0, 1, 0};
};

// The knots of a clamped uniform B-spline of `count` control points: 0 (degree + 1 times), 1, 2, ...
inline long double rule_knot(int j, int degree, int count) {
  return static_cast<long double>(std::clamp(j - degree, 0, count - degree));
}

inline long double rule_basis(int i, int degree, int of_degree, int count, long double x) {
  const auto t = [&](int j) { return rule_knot(j, of_degree, count); };
  if (degree == 0) return x >= t(i) && x < t(i + 1) ? 1 : 0;
  const auto share = [](long double a, long double b) { return b > 0 ? a / b : 0; };
  return share(x - t(i), t(i + degree) - t(i)) * rule_basis(i, degree - 1, of_degree, count, x) +
         share(t(i + degree + 1) - x, t(i + degree + 1) - t(i + 1)) *
             rule_basis(i + 1, degree - 1, of_degree, count, x);
}

// One polynomial piece of the curve: the span of a run's B-spline from knot `span` to the next.
struct RuleSpan {
  std::vector<RuleVertex> run;
  int span = 0;
  glm::dvec3 at(double t) const {
    const int count = static_cast<int>(run.size()), degree = std::min(3, count - 1);
    const long double x = span + std::min(static_cast<long double>(t), 1 - 1e-15L);
    long double sum[4] = {0, 0, 0, 0};
    for (int i = 0; i < count; ++i) {
      const RuleVertex& v = run[static_cast<std::size_t>(i)];
      const long double weight = v.weight * rule_basis(i, degree, degree, count, x);
      for (int axis = 0; axis < 3; ++axis) sum[axis] += weight * v.p[axis];
      sum[3] += weight;
    }
    return {static_cast<double>(sum[0] / sum[3]), static_cast<double>(sum[1] / sum[3]),
            static_cast<double>(sum[2] / sum[3])};
  }
};

inline std::vector<RuleSpan> rule_spans(const std::vector<RuleVertex>& vertices) {
  std::vector<RuleSpan> spans;
  std::vector<RuleVertex> run;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    run.push_back(vertices[i]);
    if (i == 0 || (!vertices[i].strict && i + 1 < vertices.size())) continue;
    const int count = static_cast<int>(run.size()), pieces = count - std::min(3, count - 1);
    for (int k = 0; k < pieces; ++k) spans.push_back({run, k});
    run = {vertices[i]};
  }
  return spans;
}

// The rates of the cubic spline through (s, angle) with rate 0 at both ends, by Gauss-Seidel.
inline std::vector<double> rule_rates(const std::vector<double>& s, const std::vector<double>& angle) {
  std::vector<double> rate(s.size(), 0.0);
  for (int sweep = 0; sweep < 200; ++sweep)
    for (std::size_t i = 1; i + 1 < s.size(); ++i) {
      const double a = s[i] - s[i - 1], b = s[i + 1] - s[i];
      rate[i] = (3 * (angle[i] - angle[i - 1]) / (a * a) + 3 * (angle[i + 1] - angle[i]) / (b * b) - rate[i - 1] / a -
                 rate[i + 1] / b) /
                (2 / a + 2 / b);
    }
  return rate;
}

// The cubic spline through points (s, angle) with rate 0 at both ends and at strict points: four coefficients a step by
// Gauss's elimination of the whole system in long double.
struct RuleRollSpline {
  std::vector<double> s;
  std::vector<long double> c;  // of powers of the distance from the step's start

  RuleRollSpline(const std::vector<double>& at, const std::vector<double>& angle, const std::vector<bool>& strict)
      : s(at), c(4 * (at.size() - 1)) {
    const std::size_t n = c.size(), steps = at.size() - 1;
    std::vector<std::vector<long double>> rows;
    const auto row = [&](std::size_t step, int derivative, long double x, long double sign) {
      auto& r = rows.back();
      for (int k = derivative; k < 4; ++k) {
        long double factor = sign;
        for (int j = 0; j < derivative; ++j) factor *= k - j;
        r[4 * step + static_cast<std::size_t>(k)] += factor * std::pow(x, static_cast<long double>(k - derivative));
      }
    };
    const auto add = [&](long double right) { rows.emplace_back(n + 1, 0.0L), rows.back()[n] = right; };
    for (std::size_t i = 0; i < steps; ++i) {
      const long double h = at[i + 1] - at[i];
      add(angle[i]), row(i, 0, 0, 1);
      add(angle[i + 1]), row(i, 0, h, 1);
      const bool joined = i + 1 < steps && !strict[i + 1];
      if (i == 0 || strict[i]) add(0), row(i, 1, 0, 1);
      if (!joined) add(0), row(i, 1, h, 1);
      for (int derivative = 1; joined && derivative < 3; ++derivative)
        add(0), row(i, derivative, h, 1), row(i + 1, derivative, 0, -1);
    }
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t best = k;
      for (std::size_t i = k; i < n; ++i)
        if (std::abs(rows[i][k]) > std::abs(rows[best][k])) best = i;
      std::swap(rows[k], rows[best]);
      for (std::size_t i = 0; i < n; ++i)
        if (const long double f = i != k ? rows[i][k] / rows[k][k] : 0; f != 0)
          for (std::size_t j = k; j <= n; ++j) rows[i][j] -= f * rows[k][j];
    }
    for (std::size_t k = 0; k < n; ++k) c[k] = rows[k][n] / rows[k][k];
  }
  double angle(double at, int derivative = 0) const {
    std::size_t i = 0;
    while (i + 2 < s.size() && s[i + 1] < at) ++i;
    const long double x = at - s[i], *k = &c[4 * i];
    return static_cast<double>(derivative == 0 ? k[0] + x * (k[1] + x * (k[2] + x * k[3]))
                                               : k[1] + x * (2 * k[2] + x * 3 * k[3]));
  }
};

// Frames of least rotation along the rule's curve, by projection over very short steps.
struct RuleFrame {
  double s;
  glm::dvec3 place, forward, up;
};
inline std::vector<RuleFrame> rule_frames(const std::vector<RuleVertex>& vertices, int steps) {
  std::vector<glm::dvec3> places;
  for (const RuleSpan& span : rule_spans(vertices))
    for (int k = places.empty() ? 0 : 1; k <= steps; ++k) places.push_back(span.at(static_cast<double>(k) / steps));
  std::vector<RuleFrame> frames;
  glm::dvec3 up(0, 1, 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 forward = glm::normalize(places[std::min(i + 1, places.size() - 1)] - places[i > 0 ? i - 1 : 0]);
    up = glm::normalize(up - glm::dot(up, forward) * forward);
    frames.push_back({i > 0 ? frames.back().s + glm::distance(places[i], places[i - 1]) : 0, places[i], forward, up});
  }
  return frames;
}

// The number in a tag after `from`, which moves behind it.
inline double rule_number(const std::string& text, const std::string& tag, std::size_t& from) {
  from = text.find("<" + tag + ">", from) + tag.size() + 2;
  return std::stod(text.substr(from));
}

// The vertices and rolls of a file that the program wrote.
inline void read_by_rule(const std::string& text, std::vector<RuleVertex>& vertices, std::vector<RuleRoll>& rolls) {
  for (std::size_t at = text.find("<vertex>"); at != std::string::npos; at = text.find("<vertex>", at)) {
    RuleVertex v;
    v.p.x = rule_number(text, "x", at), v.p.y = rule_number(text, "y", at), v.p.z = rule_number(text, "z", at);
    v.strict = text.compare(text.find("<strict>", at) + 8, 4, "true") == 0;
    vertices.push_back(v);
  }
  for (std::size_t at = text.find("<roll>"); at != std::string::npos; at = text.find("<roll>", at)) {
    RuleRoll r;
    r.up.x = rule_number(text, "ux", at), r.up.y = rule_number(text, "uy", at), r.up.z = rule_number(text, "uz", at);
    r.coord = rule_number(text, "coord", at);
    rolls.push_back(r);
  }
}

// As NoLimits 2 writes on Windows: CRLF, exponents of three digits.
inline std::string rule_text(double x) {
  char text[64];
  std::snprintf(text, sizeof text, "%.9e", x);
  std::string out = text;
  out.insert(out.find('e') + 2, "0");
  return out;
}

inline std::string encode(const std::vector<RuleVertex>& vertices,
                          const std::vector<std::pair<double, glm::dvec3>>& rolls = {},
                          const std::vector<bool>& strict_rolls = {}) {
  std::size_t roll = 0;
  std::string out =
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\" ?>\r\n<root>\r\n<element>\r\n<description>made by "
      "hand</description>\r\n";
  for (const RuleVertex& v : vertices)
    out += "<vertex><x>" + rule_text(v.p.x) + "</x><y>" + rule_text(v.p.y) + "</y>\r\n<z> " + rule_text(v.p.z) +
           " </z>" + (v.strict ? "<strict>true</strict>" : "") +
           (v.weight != 1 ? "<w>" + rule_text(v.weight) + "</w>" : "") + "</vertex>\r\n";
  for (const auto& [coord, up] : rolls) {
    const glm::dvec3 right =
        glm::normalize(glm::cross(std::abs(up.x) < 0.9 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), up));
    out += "<roll><ux>" + rule_text(up.x) + "</ux><uy>" + rule_text(up.y) + "</uy><uz>" + rule_text(up.z) +
           "</uz><rx>" + rule_text(right.x) + "</rx><ry>" + rule_text(right.y) + "</ry><rz>" + rule_text(right.z) +
           "</rz>\r\n<coord>" + rule_text(coord) + "</coord><strict>" +
           (roll < strict_rolls.size() && strict_rolls[roll] ? "true" : "false") + "</strict></roll>\r\n";
    ++roll;
  }
  return out + "</element>\r\n</root>\r\n";
}

}  // namespace coaster::test
