#include "base/least_change_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace coaster::base {
namespace {

using Values = std::vector<double>;

constexpr int kTurns = 16;        // maximum number of gradients
constexpr int kHalvings = 8;      // of a step that does not come closer
constexpr int kLongWay = 4;       // values that come closer before the next gradient
constexpr double kLongest = 40;   // largest change of one unknown in one direction, in its steps
constexpr double kCoarsest = 64;  // largest difference in steps, if smaller ones have no effect
constexpr double kFinest = 1e-9;  // in steps: a smaller bracket contains a jump

class LeastChangeSearch {
 public:
  explicit LeastChangeSearch(const Equation& equation) : e_(equation) {}

  Solution run() {
    for (const Unknown& unknown : e_.unknowns) best_.unknowns.push_back(unknown.start);
    const std::optional<double> first = value(best_.unknowns);
    if (!first) return finished(SolutionEnd::no_value);
    best_.value = *first;
    for (int turn = 0; turn < kTurns && !ended_; ++turn) {
      if (met(best_.value)) return finished(SolutionEnd::met);
      const Values way = direction();
      if (ended_) break;
      if (way.empty()) return finished(turn == 0 ? SolutionEnd::no_effect : SolutionEnd::stuck);
      if (!follow(way) && !ended_) return finished(SolutionEnd::stuck);
    }
    return finished(met(best_.value) ? SolutionEnd::met : ended_.value_or(SolutionEnd::stuck));
  }

 private:
  bool met(double value) const { return std::abs(value - e_.wanted) <= e_.tolerance; }
  double missing(double value) const { return e_.wanted - value; }
  Solution finished(SolutionEnd end) {
    best_.end = end;
    return best_;
  }

  std::optional<double> value(const Values& at) {
    if (ended_) return std::nullopt;
    if (e_.goes_on && !e_.goes_on(static_cast<double>(best_.trials) / e_.trials)) ended_ = SolutionEnd::cancelled;
    else if (best_.trials >= e_.trials) ended_ = SolutionEnd::trials_used;
    if (ended_) return std::nullopt;
    ++best_.trials;
    const std::optional<double> found = e_.value(at);
    return found && std::isfinite(*found) ? found : std::nullopt;
  }

  // Returns the change of the value by that of one unknown of so many steps, per step, to the side within the limits.
  double difference(std::size_t i, double steps) {
    const Unknown& unknown = e_.unknowns[i];
    for (const double sign : {1.0, -1.0}) {
      Values at = best_.unknowns;
      at[i] = std::clamp(at[i] + sign * steps * unknown.step, unknown.low, unknown.high);
      const double moved = (at[i] - best_.unknowns[i]) / unknown.step;
      if (std::abs(moved) < 0.5 * steps) continue;
      if (const std::optional<double> there = value(at)) return (*there - best_.value) / moved;
    }
    return 0;
  }

  // Returns the change of the unknowns, in steps, that would lead to the wanted value if the function were linear;
  // empty if no unknown has an effect.
  Values direction() {
    for (double steps = 1; steps <= kCoarsest; steps *= 4) {
      Values gradient;
      for (std::size_t i = 0; i < e_.unknowns.size(); ++i) gradient.push_back(difference(i, steps));
      double square = 0;
      // An unknown at its limit stays there if the change would exceed it.
      for (std::size_t i = 0; i < gradient.size(); ++i) {
        const Unknown& unknown = e_.unknowns[i];
        const bool up = gradient[i] * missing(best_.value) > 0;
        if (best_.unknowns[i] == (up ? unknown.high : unknown.low)) gradient[i] = 0;
        square += gradient[i] * gradient[i];
      }
      if (!(square > 0)) continue;
      double most = 0;
      for (double& g : gradient) g *= missing(best_.value) / square, most = std::max(most, std::abs(g));
      if (most > kLongest)
        for (double& g : gradient) g *= kLongest / most;
      return gradient;
    }
    return {};
  }

  Values at(const Values& from, const Values& way, double part) const {
    Values there = from;
    for (std::size_t i = 0; i < there.size(); ++i)
      there[i] = std::clamp(from[i] + part * way[i] * e_.unknowns[i].step, e_.unknowns[i].low, e_.unknowns[i].high);
    return there;
  }

  // A position along the direction, as a fraction of it, and the remaining difference.
  struct LinePosition {
    double part, missing;
  };

  // Follows a direction until the value is met, no longer comes closer, or has come closer kLongWay times. Returns
  // false if it never came closer.
  bool follow(const Values& way) {
    const Values from = best_.unknowns;
    LinePosition near{0, missing(best_.value)};
    double part = 1;
    int closer = 0;
    for (int halving = 0; halving < kHalvings && closer < kLongWay && !ended_;) {
      const std::optional<double> there = value(at(from, way, part));
      if (there && met(*there)) return keep(from, way, part, *there);
      if (there && missing(*there) * near.missing < 0) return between(from, way, near, {part, missing(*there)});
      if (!there || std::abs(missing(*there)) >= std::abs(near.missing)) {
        part = (near.part + part) / 2, ++halving;
        continue;
      }
      ++closer;
      keep(from, way, part, *there);
      const LinePosition before = std::exchange(near, {part, missing(*there)});
      const double slope = (before.missing - near.missing) / (near.part - before.part);
      part = near.part + std::clamp(near.missing / slope, 0.1 * near.part, 4 * near.part);
    }
    return closer > 0;
  }

  bool keep(const Values& from, const Values& way, double part, double value) {
    best_.unknowns = at(from, way, part), best_.value = value;
    return true;
  }

  // Searches between two positions that enclose the wanted value.
  bool between(const Values& from, const Values& way, LinePosition near, LinePosition far) {
    int kept = 0;  // > 0: how often in a row the nearer one stayed; < 0: the farther one
    while (!ended_ && far.part - near.part > kFinest) {
      const double secant = (near.part * far.missing - far.part * near.missing) / (far.missing - near.missing);
      const double margin = 0.01 * (far.part - near.part);
      const double part =
          std::abs(kept) > 3 ? (near.part + far.part) / 2 : std::clamp(secant, near.part + margin, far.part - margin);
      const std::optional<double> there = value(at(from, way, part));
      if (!there) return false;
      if (std::abs(missing(*there)) < std::abs(missing(best_.value))) keep(from, way, part, *there);
      if (met(*there)) return true;
      if (missing(*there) * near.missing > 0) {
        near = {part, missing(*there)};
        if (kept < 0) far.missing /= 2;
        kept = std::min(kept, 0) - 1;
      } else {
        far = {part, missing(*there)};
        if (kept > 0) near.missing /= 2;
        kept = std::max(kept, 0) + 1;
      }
    }
    return false;
  }

  const Equation& e_;
  Solution best_;
  std::optional<SolutionEnd> ended_;
};

}  // namespace

Solution solve_by_least_change(const Equation& equation) { return LeastChangeSearch(equation).run(); }

}  // namespace coaster::base
