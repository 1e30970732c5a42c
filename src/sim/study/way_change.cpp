#include "sim/study/way_change.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "world/motion.h"

namespace coaster::sim {
namespace {

// Returns the square of the train's speed at the way's start, m^2/s^2; too little if it does not get there.
double square_at_start(const WayChange& change) {
  const world::WayHome& way = change.former;
  return way.speed * way.speed - (way.coasts ? 2 * world::kGravity * change.risen : 0.0);
}

std::string out_of_reach(double risen) {
  return fmt::format("the train does not reach the closing section, which would begin {} m higher",
                     risen < 0.05 ? fmt::format("{:.1g}", risen) : fmt::format("{:.1f}", risen));
}

}  // namespace

ChangedWay changed_way(const WayChange& change, OpenedTrack& opened) {
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
  return {.fit = std::move(best.plan.fit), .way = best.way, .another = another};
}

}  // namespace coaster::sim
