// A small change of the path is one of the place p, a turn theta of the frame about the world's axes, and one of the
// squared speed q. Per unit of the axis, of m metres, the frame turns by B about its tangent T, up and left, and
//
//   p' = m T,   dp' = m theta x T + T dm,   dtheta' = (T, up, left) dB,   dq' = d(2 m a)
//
// so that the row (P, Theta, Q) of derivatives of a condition by these goes back along the path by the transposed
// equations, P constant. Turns about the vertical change nothing but direction: gravity stays as it is.
#include "sim/plan/force_end_sensitivities.h"

#include <cmath>

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kSample = 1;       // m between samples, about
constexpr double kChange = 1e-6;    // rad, g, degrees; of the square: as a fraction
constexpr std::size_t kInputs = 4;  // vertical, lateral, roll and its slope

// The change of the rates with something: of the turn of the frame in the world, and of the squared speed.
struct RateChange {
  dvec3 turn{0};
  double square = 0;
};

struct AdjointRow {
  dvec3 place{0}, turn{0};
  double square = 0;
};
double times(const AdjointRow& row, const RateChange& change) {
  return glm::dot(row.turn, change.turn) + row.square * change.square;
}

struct AdjointSample {
  dvec3 tangent{0};
  double metres = 0, metres_by_square = 0;
  RateChange by_x, by_z, by_square;  // by turns about two axes of the world
  std::array<RateChange, kInputs> by_input;
};

// Per unit of the axis: the turn about tangent, up and left, and the change of the squared speed.
struct AxisRates {
  dvec3 turn;
  double square;
};
AxisRates body_of(const ForceLaw& law, const ProgramValues& wanted, const ForceState& s) {
  const ForceRates r = law.rates_for(wanted, s);
  const double metres = law.metres_per_unit(s);
  const dvec3 left = glm::cross(s.up, s.tangent);
  return {metres * dvec3(r.spin, glm::dot(r.curvature, left), -glm::dot(r.curvature, s.up)), 2 * metres * r.along};
}

ForceState turned(ForceState s, dvec3 by) {
  s.tangent += glm::cross(by, s.tangent), s.up += glm::cross(by, s.up);
  return s;
}
ForceState faster(ForceState s, double by) {
  s.square += by;
  return s;
}
// Returns a number of `wanted`, by input.
double& input_of(ProgramValues& wanted, std::size_t input) {
  ForceCurve::Value* const values[] = {&wanted.up, &wanted.side, &wanted.roll, &wanted.roll};
  return input + 1 < kInputs ? values[input]->value : values[input]->slope;
}

// By differences to both sides, so that what is symmetric stays so: a plane section has no reason to leave its plane.
AdjointSample sample_at(const ForceLaw& law, double x, const ForceState& s) {
  const ProgramValues wanted = law.wanted(x);
  const dvec3 left = glm::cross(s.up, s.tangent);
  const auto change = [&](const AxisRates& less, const AxisRates& more, double by) {
    const dvec3 turn = (more.turn - less.turn) / (2 * by);
    return RateChange{turn.x * s.tangent + turn.y * s.up + turn.z * left, (more.square - less.square) / (2 * by)};
  };
  const auto by_state = [&](const ForceState& less, const ForceState& more, double by) {
    return change(body_of(law, wanted, less), body_of(law, wanted, more), by);
  };
  AdjointSample sample;
  sample.tangent = s.tangent, sample.metres = law.metres_per_unit(s);
  sample.by_x = by_state(turned(s, {-kChange, 0, 0}), turned(s, {kChange, 0, 0}), kChange);
  sample.by_z = by_state(turned(s, {0, 0, -kChange}), turned(s, {0, 0, kChange}), kChange);
  const double by = kChange * std::max(s.square, 1.0);
  const ForceState slower = faster(s, -by), quicker = faster(s, by);
  sample.by_square = by_state(slower, quicker, by);
  sample.metres_by_square = (law.metres_per_unit(quicker) - law.metres_per_unit(slower)) / (2 * by);
  for (std::size_t i = 0; i < kInputs; ++i) {
    ProgramValues less = wanted, more = wanted;
    input_of(less, i) -= kChange, input_of(more, i) += kChange;
    sample.by_input[i] = change(body_of(law, less, s), body_of(law, more, s), kChange);
  }
  return sample;
}

// Returns the change of a row per unit backwards.
AdjointRow backwards(const AdjointRow& row, const AdjointSample& at) {
  AdjointRow rate;
  rate.turn = at.metres * glm::cross(at.tangent, row.place) + dvec3(times(row, at.by_x), 0, times(row, at.by_z));
  rate.square = at.metres_by_square * glm::dot(row.place, at.tangent) + times(row, at.by_square);
  return rate;
}
AdjointRow moved(const AdjointRow& row, const AdjointRow& rate, double by) {
  return {row.place, row.turn + by * rate.turn, row.square + by * rate.square};
}

// The cubic Hermite of a gap by the values and slopes at its ends, and its derivative.
struct Hermite {
  std::array<double, 4> value, slope;
  Hermite(double u, double gap)
      : value{(1 + 2 * u) * (1 - u) * (1 - u), u * u * (3 - 2 * u), gap * u * (1 - u) * (1 - u), gap * u * u * (u - 1)},
        slope{-6 * u * (1 - u) / gap, 6 * u * (1 - u) / gap, (1 - u) * (1 - 3 * u), u * (3 * u - 2)} {}
};

// The derivatives of a condition by the values and slopes of the nodes, by channel, the start's first.
struct ByNodes {
  std::array<std::vector<double>, 3> values, slopes;
  explicit ByNodes(std::size_t nodes) {
    for (auto* const lists : {&values, &slopes}) lists->fill(std::vector<double>(nodes + 1, 0.0));
  }
  // Adds the effect of a sample in the gap behind a node, where the row is this one.
  void add(std::size_t node, const AdjointRow& row, const AdjointSample& at, const Hermite& curve, double weight) {
    for (std::size_t i = 0; i < kInputs; ++i) {
      const std::size_t c = std::min<std::size_t>(i, 2);
      const std::array<double, 4>& by = i + 1 < kInputs ? curve.value : curve.slope;
      const double effect = weight * times(row, at.by_input[i]);
      values[c][node] += effect * by[0], values[c][node + 1] += effect * by[1];
      slopes[c][node] += effect * by[2], slopes[c][node + 1] += effect * by[3];
    }
  }
};

class Adjoint {
 public:
  Adjoint(const ForceLaw& law, double length, std::size_t nodes, const MissAt& miss)
      : law_(law), miss_(miss), length_(length), nodes_(nodes), gap_(length / static_cast<double>(nodes)) {}

  std::optional<std::vector<EndMiss>> run() {
    if (!sample_path()) return std::nullopt;
    const std::optional<std::vector<AdjointRow>> rows = rows_at_end();
    if (!rows) return std::nullopt;
    std::vector<EndMiss> slopes(3 * nodes_, EndMiss{});
    for (std::size_t e = 0; e < rows->size(); ++e) {
      const ByNodes by = go_back((*rows)[e], e);
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t i = 1; i <= nodes_; ++i) slopes[c * nodes_ + i - 1][e] = of_node(by, c, i);
    }
    return slopes;
  }

 private:
  bool sample_path() {
    last_ = law_.start();
    const double metres = gap_ * law_.metres_per_unit(last_);
    parts_ = 2 * std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(metres / (2 * kSample))));
    samples_ = {sample_at(law_, 0, last_)};
    const double by = gap_ / static_cast<double>(parts_);
    for (std::size_t k = 1; k <= nodes_ * parts_; ++k) {
      const double x = by * static_cast<double>(k);
      last_ = law_.step(x - by, last_, by);
      if (law_.too_slow(last_)) return false;
      samples_.push_back(sample_at(law_, k == nodes_ * parts_ ? length_ : x, last_));
    }
    return true;
  }

  // Returns the derivatives of each condition by the place, the frame and the speed at the end, and sets those by what
  // is added there.
  std::optional<std::vector<AdjointRow>> rows_at_end() {
    const ProgramValues wanted = law_.wanted(length_);
    std::vector<AdjointRow> rows(EndMiss{}.size());
    bool good = true;
    const auto at = [&](const ProgramValues& want, const ForceState& s) { return miss_(law_.rates_for(want, s), s); };
    const auto differ = [&](const std::optional<EndMiss>& less, const std::optional<EndMiss>& more, double by,
                            const auto& put) {
      good = good && less && more;
      for (std::size_t e = 0; good && e < rows.size(); ++e) put(e, ((*more)[e] - (*less)[e]) / (2 * by));
    };
    for (int axis = 0; axis < 3; ++axis) {
      dvec3 by(0);
      by[axis] = kChange;
      ForceState less = last_, more = last_;
      less.position -= by, more.position += by;
      differ(at(wanted, less), at(wanted, more), kChange,
             [&](std::size_t e, double slope) { rows[e].place[axis] = slope; });
      differ(at(wanted, turned(last_, -by)), at(wanted, turned(last_, by)), kChange,
             [&](std::size_t e, double slope) { rows[e].turn[axis] = slope; });
    }
    const double by = kChange * std::max(last_.square, 1.0);
    differ(at(wanted, faster(last_, -by)), at(wanted, faster(last_, by)), by,
           [&](std::size_t e, double slope) { rows[e].square = slope; });
    for (std::size_t c = 0; c < 3; ++c) {
      ProgramValues less = wanted, more = wanted;
      input_of(less, c) -= kChange, input_of(more, c) += kChange;
      differ(at(less, last_), at(more, last_), kChange, [&](std::size_t e, double slope) { at_end_[c][e] = slope; });
    }
    return good ? std::optional(std::move(rows)) : std::nullopt;
  }

  ByNodes go_back(AdjointRow row, std::size_t condition) const {
    ByNodes by(nodes_);
    for (std::size_t c = 0; c < 3; ++c) by.values[c].back() = at_end_[c][condition];
    const double step = 2 * gap_ / static_cast<double>(parts_);
    for (std::size_t node = nodes_; node-- > 0;)
      for (std::size_t part = parts_; part > 0; part -= 2) {
        const std::size_t k = node * parts_ + part;
        const AdjointSample &from = samples_[k], &middle = samples_[k - 1], &to = samples_[k - 2];
        const auto curve = [&](std::size_t at) {
          return Hermite(static_cast<double>(at) / static_cast<double>(parts_), gap_);
        };
        const Hermite in_middle = curve(part - 1);
        const AdjointRow r1 = backwards(row, from), row2 = moved(row, r1, step / 2), r2 = backwards(row2, middle),
                         row3 = moved(row, r2, step / 2), r3 = backwards(row3, middle), row4 = moved(row, r3, step),
                         r4 = backwards(row4, to);
        by.add(node, row, from, curve(part), step / 6), by.add(node, row2, middle, in_middle, step / 3);
        by.add(node, row3, middle, in_middle, step / 3), by.add(node, row4, to, curve(part - 2), step / 6);
        row = moved(moved(moved(moved(row, r1, step / 6), r2, step / 3), r3, step / 3), r4, step / 6);
      }
    return by;
  }

  // A node's value is part of the slopes of its neighbours that are not at an end.
  double of_node(const ByNodes& by, std::size_t channel, std::size_t node) const {
    double sum = by.values[channel][node];
    if (node > 1) sum += by.slopes[channel][node - 1] / (2 * gap_);
    if (node + 1 < nodes_) sum -= by.slopes[channel][node + 1] / (2 * gap_);
    return sum;
  }

  const ForceLaw& law_;
  const MissAt& miss_;
  double length_;
  std::size_t nodes_;
  double gap_;
  std::size_t parts_ = 0;               // between nodes, an even number
  std::vector<AdjointSample> samples_;  // from the start to the end
  ForceState last_;
  std::array<EndMiss, 3> at_end_{};  // by channel
};

}  // namespace

std::optional<std::vector<EndMiss>> end_slopes(const ForceLaw& law, double length, std::size_t nodes,
                                               const MissAt& miss) {
  return Adjoint(law, length, nodes, miss).run();
}

}  // namespace coaster::sim
