#include "sim/study/complete_circuit.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/check.h"
#include "base/text.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "sim/ride/train.h"
#include "sim/study/closing_replan.h"
#include "sim/study/jolt.h"
#include "world/motion.h"
#include "world/topology.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kRoughStep = 3, kRoughMargin = 0.3,
                 kMargin = 0.15;   // m: the chords differ from those of the final track
constexpr int kMostFailures = 30;  // of candidates that turn in the same way and reach the same level
constexpr int kMostRough = 120;    // ways found too rough before all others count as too rough
constexpr double kApart = 8;       // m between the middles of two proposals

// Where closing sections were rejected for other track, and came nearest to it.
struct Obstacles {
  struct Place {
    int count = 0;
    double sum = 0;  // m along the track
  };
  std::map<int, Place> places;  // by tens of metres along the track; below 0: the section itself
  int count = 0;
  void add(std::span<const LineConflict> parts) {
    const LineConflict& worst = *std::ranges::max_element(parts, {}, &LineConflict::missing);
    Place& place = places[worst.other < 0 ? -1 : static_cast<int>(worst.other / 10)];
    ++place.count, place.sum += worst.other, ++count;
  }
  std::string refusal() const {
    const auto& [tens, place] = *std::ranges::max_element(places, {}, [](const auto& at) { return at.second.count; });
    if (tens < 0) return "every closing section would cross itself";
    return fmt::format("other track is in the way: closing sections come too close to it, most often at {} m",
                       std::round(place.sum / place.count));
  }
};

std::vector<LinePoint> rough_points(const std::vector<ClosingPlace>& places, double after) {
  std::vector<LinePoint> line;
  for (const ClosingPlace& p : places) line.push_back({glm::vec3(p.rails), glm::vec3(p.up), static_cast<float>(p.s)});
  // The points left out after the last one still count as distance from the first knot.
  if (!line.empty()) line.push_back(line.back()), line.back().s += static_cast<float>(after);
  return line;
}

bool buried(const CircuitTask& task, const ElementCurve& curve) {
  const double floor = std::min(bottom(task) + kLowestRails,
                                std::min(task.from.position.y, task.home.position.y) + std::min(task.rails, 0.0)) -
                       0.05;
  return std::ranges::any_of(curve.points,
                             [&](const ElementPoint& p) { return (p.position + task.rails * p.up).y < floor; });
}

bool resembles(const ElementPlan& a, const ElementPlan& b) {
  for (const double share : {0.3, 0.5, 0.7}) {
    const auto at = [&](const ElementPlan& plan) {
      const auto& points = plan.ideal.points;
      return points[static_cast<std::size_t>(share * static_cast<double>(points.size() - 1))].position;
    };
    if (glm::distance(at(a), at(b)) > kApart) return false;
  }
  return true;
}

ElementPlan plan_of(ElementCurve curve) {
  ElementPlan plan;
  plan.ideal = std::move(curve);
  plan.length = plan.ideal.length();
  plan.lowest = plan.ideal.points.front().position.y;
  for (const ElementPoint& p : plan.ideal.points) plan.lowest = std::min(plan.lowest, p.position.y);
  return plan;
}

struct ProposalSearchOptions {
  const DerivedTrack& derived;
  const Conflicts& conflicts;
  std::size_t most_found;
  int most_tried;
  double side = kMostSide;               // g: rougher ways only if there are no others
  std::span<const double> lengths = {};  // of a former closing section's spans

  // Reports a part of the candidates. False once the search is cancelled.
  bool goes_on(int tried) const {
    base::report_progress(static_cast<double>(tried) / most_tried);
    return !base::interrupted();
  }
};

// One search: its proposals and the reasons for rejections.
struct ProposalSearch {
  const CircuitCandidates& candidates;
  const ProposalSearchOptions& terms;
  CircuitProposals found = {};
  std::vector<CircuitCandidate> rougher = {};
  int tried = 0, rough_ones = 0;
  Obstacles obstacles = {};
  int forced = 0, buried_ones = 0, unfit = 0;
  double least_g = 1e9;

  // Returns true if it has approximate clearance.
  bool has_room(const CircuitCandidate& candidate) {
    const ClosingCurve closing = candidates.rough(candidate);
    const std::vector<LineConflict> narrow = terms.conflicts.against(
        terms.derived, rough_points(rough_line(candidates.task, closing, kRoughStep), closing.out.length),
        {true, kRoughMargin});
    if (!narrow.empty()) obstacles.add(narrow);
    return narrow.empty();
  }

  // Adds the proposal of a candidate, unless it fails, resembles another or is too rough.
  void propose(const CircuitCandidate& candidate, double side) {
    const CircuitTask& task = candidates.task;
    const std::optional<ClosingCurve> closing = candidates.exact(candidate);
    if (!closing) return;
    CircuitProposal proposal{plan_of(ideal_closing(task, *closing)), {}, candidates.described(candidate, *closing)};
    ElementPlan& plan = proposal.plan;
    for (const CircuitProposal& other : found.list)
      if (resembles(plan, other.plan)) return;
    proposal.felt = felt_on(task, plan.ideal);
    if (!proposal.felt.within()) {
      ++forced, least_g = std::min(least_g, proposal.felt.most);
      return;
    }
    if (proposal.felt.side > side) {
      ++rough_ones, rougher.push_back(candidate);
      return;
    }
    if (buried(task, plan.ideal)) {
      ++buried_ones;
      return;
    }
    const std::vector<LineConflict> narrow =
        terms.conflicts.against(terms.derived, line_of(plan.ideal, task.rails), {true, kMargin});
    if (!narrow.empty()) return obstacles.add(narrow);
    plan.fit = terms.lengths.empty() ? fit_element(plan.ideal) : fit_element(plan.ideal, terms.lengths);
    if (!plan.fit.within) ++unfit;
    else found.list.push_back(std::move(proposal));
  }

  void run(std::span<const CircuitCandidate> list, double side) {
    std::map<std::array<int, 5>, int> failures;
    for (const CircuitCandidate& candidate : list) {
      if (found.list.size() == terms.most_found || tried == terms.most_tried || !terms.goes_on(tried)) break;
      if (rough_ones == kMostRough) {
        rougher.push_back(candidate);
        continue;
      }
      const TurnChoice& turns = candidates.turns[candidate.turns];
      int& failed = failures[{turns.first, turns.second, turns.more_first, turns.more_second, candidate.level}];
      if (failed >= kMostFailures) continue;
      ++tried;
      const std::size_t before = found.list.size();
      if (has_room(candidate)) propose(candidate, side);
      if (found.list.size() == before) ++failed;
    }
  }

  void run() {
    run(candidates.list, terms.side);
    rough_ones = 0;
    if (found.list.empty()) run(std::exchange(rougher, {}), kMostSide);
  }

  std::string why_not() const {
    const CircuitRejections& losses = candidates.losses;
    if (obstacles.count > 0) return obstacles.refusal();
    if (forced > 0 || losses.forced > 0) {
      const double least = std::min(least_g, losses.least_g);
      return fmt::format("the train is too fast for the room there: {} m/s at the open end, and at least {:.1f} g",
                         base::to_text(std::round(candidates.task.speed * 10) / 10), least);
    }
    if (buried_ones > 0 || losses.buried > 0)
      return fmt::format("the {} is in the way: every closing section runs below it", bottom_name(candidates.task));
    if (losses.slow > 0) return "the train is too slow: it stops on every closing section";
    if (unfit > 0) return "the ends are too sharp or too far from the origin for a fit within 1 cm";
    const double rise = candidates.task.home.position.y - candidates.task.from.position.y;
    if (std::abs(rise) < 0.05) return "the slope is too steep: there is no room to level out before the first knot";
    return fmt::format("the slope is too steep: the first knot is {:.1f} m {} than the open end, with no room to {}",
                       std::abs(rise), rise > 0 ? "higher" : "lower", rise > 0 ? "climb" : "descend");
  }
};

CircuitProposals searched(const CircuitCandidates& candidates, const ProposalSearchOptions& terms) {
  ProposalSearch search{candidates, terms};
  search.found.speed = candidates.task.speed, search.found.assumed = !candidates.task.coasts;
  if (candidates.refusal.empty()) search.run();
  if (search.found.list.empty())
    search.found.refusal = candidates.refusal.empty() ? search.why_not() : candidates.refusal;
  return std::move(search.found);
}

// Returns the square of the train's speed at the section's start, m^2/s^2; too little if it does not get there.
double square_at_start(const ClosingReplanTask& change) {
  const world::ClosingPlan& closing = change.former;
  return closing.speed * closing.speed - (closing.coasts ? 2 * world::kGravity * change.risen : 0.0);
}

std::string out_of_reach(double risen) {
  return fmt::format("the train does not reach the closing section, which would begin {} m higher",
                     risen < 0.05 ? fmt::format("{:.1g}", risen) : fmt::format("{:.1f}", risen));
}

}  // namespace

// --- Clearance of an element of the palette at the end of the track

std::vector<LinePoint> line_of(const ElementCurve& curve, double rails) {
  constexpr double kMostChords = 600;
  const double step = std::max(kConflictStep, curve.length() / kMostChords);
  std::vector<LinePoint> line;
  for (const ElementPoint& p : curve.points)
    if (line.empty() || p.s >= double{line.back().s} + step || &p == &curve.points.back())
      line.push_back({glm::vec3(p.position + rails * p.up), glm::vec3(p.up), static_cast<float>(p.s)});
  return line;
}

const std::vector<LineConflict>& ElementClearance::update(const ElementPlan& plan, const Conflicts& conflicts,
                                                          const DerivedTrack& derived, double rails) {
  if (plan_ == plan.serial && build_ == derived.last_build && order_ == derived.order && rails_ == rails) return found_;
  plan_ = plan.serial, build_ = derived.last_build, order_ = derived.order, rails_ = rails;
  found_.clear();
  if (plan.refusal.empty()) found_ = conflicts.against(derived, line_of(plan.ideal, rails));
  return found_;
}

std::optional<CircuitTask> circuit_task(const world::Document& document, const DerivedTrack& derived,
                                        const SimulatedRide* ride) {
  const std::optional<TrackEnd> end = open_end(document);
  if (!end || document.track.segments.empty()) return std::nullopt;
  CircuitTask task;
  task.from = *end;
  const world::Knot& first = world::knot(document, document.track.knots.front());
  task.home.position = dvec3(first.position);
  task.home.forward = glm::normalize(dvec3(first.tangent));
  task.home.up = curve::perpendicular(task.home.forward, dvec3(first.up));
  task.home.spin = first.spin;
  task.home.curvature = curve::across(
      curve::curvature_vector(world::cubic_of(document, document.track.segments.front()), 0.0), task.home.forward);
  if (glm::length(task.home.curvature) < kStraightEnd) task.home.curvature = dvec3(0);
  const Roll &before = derived.shape_at(derived.order.size() - 1).roll, &after = derived.shape_at(0).roll;
  task.from_slope = before.slope(before.length), task.home_slope = after.slope(0);
  task.rails = world::rails_height(document), task.riders = world::riders_height(document);
  if (!document.park.plain()) task.water = document.park.water;
  task.speed = kAssumedSpeed, task.coasts = false;
  if (ride != nullptr && ride->end == world::FailureKind::off_end && ride->samples.back().speed > 0) {
    task.speed = ride->samples.back().speed, task.coasts = true;
    task.losses = resistance_of(document, ride->start.mass);
  }
  return task;
}

CircuitProposals complete_again(const FormerClosing& former, const CircuitTask& task, const DerivedTrack& derived,
                                const Conflicts& conflicts) {
  return searched(candidates_like(former.closing, task),
                  {derived, conflicts, 1, kMostTriedAgain, kMostSide, former.lengths});
}

CircuitProposals complete_circuit(const CircuitTask& task, const DerivedTrack& derived, const Conflicts& conflicts) {
  CircuitProposals found =
      searched(circuit_candidates(task), {derived, conflicts, kMostProposals, kMostTried, kGentleSide, {}});
  std::ranges::stable_sort(found.list, {}, [](const CircuitProposal& p) { return cost_of(p.plan.length, p.felt); });
  return found;
}

std::optional<world::Entity> close_by(world::Document& document, const CircuitProposal& proposal) {
  const std::vector<world::Knot>& knots = proposal.plan.fit.knots;
  world::Knot& end = document.entities.get<world::Knot>(document.track.knots.back());
  end.joint = world::JointKind::aligned, end.out_length = knots.front().out_length;
  std::optional<world::Entity> added;
  for (std::size_t k = 1; k + 1 < knots.size(); ++k) added = world::append_knot(document, knots[k]);
  world::set_closed(document, true);
  world::make_section(document, document.track.segments.size() - proposal.plan.spans(), proposal.plan.spans(),
                      {{}, world::SectionKind::complete, {}, proposal.closing});
  world::Knot& first = document.entities.get<world::Knot>(document.track.knots.front());
  first.joint = world::JointKind::aligned, first.in_length = knots.back().in_length;
  return added;
}

void OpenedTrack::update(const world::Document& opened) {
  world::Settings settings;
  settings.evaluation->steps = 1;
  derive(opened, settings, {}, derived);
  conflicts.update(derived);
}

const CircuitProposals& ProposalCache::update(const world::Document& document, const DerivedTrack& derived,
                                              const Conflicts& conflicts, const SimulatedRide* ride) {
  const std::optional<CircuitTask> task = circuit_task(document, derived, ride);
  if (!task) {
    task_.reset();
    found_ = {};
    found_.refusal = document.track.closed ? world::kClosedTrack : "the track has no segment yet";
    return found_;
  }
  if (task_ == task && build_ == derived.last_build && order_ == derived.order) return found_;
  task_ = task, build_ = derived.last_build, order_ = derived.order;
  found_ = complete_circuit(*task, derived, conflicts);
  for (CircuitProposal& proposal : found_.list) proposal.plan.serial = ++serial_;
  return found_;
}

double ClosingJolts::worst(const CircuitProposals& found, std::size_t index, const world::Document& open,
                           std::uint64_t serial, world::Entity cart, double cutoff) {
  COASTER_CHECK(index < found.list.size(), "the jolt of a proposal that is not there");
  const CircuitProposal& proposal = found.list[index];
  return kept_[index].get({proposal.plan.serial, serial, cart, cutoff}, [&] {
    const std::size_t end = open.track.knots.size() - 1;
    world::Document document = open;
    close_by(document, proposal);
    world::Settings settings;
    settings.evaluation->steps = 1;
    derive(document, settings, {}, closed_);
    const SimulatedRide* const ride = rides_.ride(document, closed_, cart);
    if (ride == nullptr) return 0.0;
    const std::vector<Jolt> all = jolts(*ride, cutoff);
    double most = all.empty() ? 0.0 : all.front().total;
    for (std::size_t k = end; k < all.size(); ++k) most = std::max(most, all[k].total);
    return most;
  });
}

ClosingReplanResult changed_closing(const ClosingReplanTask& change, OpenedTrack& opened) {
  const double square = square_at_start(change), former_square = change.former.speed * change.former.speed;
  if (square < std::min(1.0, former_square)) return {.refusal = out_of_reach(change.risen)};
  opened.update(change.opened);
  CircuitTask task = *circuit_task(change.opened, opened.derived, nullptr);
  task.speed = std::sqrt(square), task.coasts = change.former.coasts, task.losses = change.losses;
  CircuitProposals found = complete_again({change.former, change.lengths}, task, opened.derived, opened.conflicts);
  const bool another = found.list.empty() && change.whole;
  if (another) found = complete_circuit(task, opened.derived, opened.conflicts);
  if (found.list.empty()) return {.refusal = "the closing section cannot take up the change: " + found.refusal};
  CircuitProposal& best = found.list.front();
  return {.fit = std::move(best.plan.fit), .closing = best.closing, .another = another};
}

}  // namespace coaster::sim
