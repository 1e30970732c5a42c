#include "sim/study/way_jolt.h"

#include <algorithm>

#include "base/check.h"
#include "sim/study/jolt.h"

namespace coaster::sim {

double WayJolts::worst(const CircuitProposals& found, std::size_t index, const world::Document& open,
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
    const Ghost* const ride = rides_.ride(document, closed_, cart);
    if (ride == nullptr) return 0.0;
    const std::vector<Jolt> all = jolts(*ride, cutoff);
    double most = all.empty() ? 0.0 : all.front().total;
    for (std::size_t k = end; k < all.size(); ++k) most = std::max(most, all[k].total);
    return most;
  });
}

}  // namespace coaster::sim
