#include "edit/perform/hand_shaped.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/text.h"
#include "sim/plan/carry.h"
#include "world/sections.h"

namespace coaster::edit {
namespace {

using glm::dvec3;
using world::Knot;

double largest(glm::vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The values of a knot that belong to a section.
struct Side {
  bool in, out;  // the handles within the section; inside a section the spin also counts
};

bool same(const Knot& before, const Knot& now, Side side) {
  return before.position == now.position && before.tangent == now.tangent && before.up == now.up &&
         (!side.in || before.in_length == now.in_length) && (!side.out || before.out_length == now.out_length) &&
         (!(side.in && side.out) || before.spin == now.spin);
}

bool near(float a, float b) { return std::abs(a - b) <= 1e-6f * (1 + std::abs(b)); }

// True if the values are the same after the carry, except for rounding to float.
bool moved(const sim::Carry& carry, const Knot& before, const Knot& now, Side side) {
  constexpr double kTurned = 1e-5;  // rad
  const double rounding =
      4.0 * std::numeric_limits<float>::epsilon() * (1.0 + std::max(largest(before.position), largest(now.position)));
  return (!side.in || near(before.in_length, now.in_length)) &&
         (!side.out || near(before.out_length, now.out_length)) &&
         (!(side.in && side.out) || near(before.spin, now.spin)) &&
         glm::distance(carry.point(dvec3(before.position)), dvec3(now.position)) <= rounding &&
         glm::distance(carry.direction(dvec3(before.tangent)), dvec3(now.tangent)) <= kTurned &&
         glm::distance(carry.direction(dvec3(before.up)), dvec3(now.up)) <= kTurned;
}

class Comparison {
 public:
  Comparison(const Session& session, const Change& change) : session_(session), respun_(change.respun) {
    std::sort(respun_.begin(), respun_.end());
  }

  bool keeps_its_plan(const world::SectionRun& before, const world::SectionRun& now) const {
    if (before.count != now.count) return false;
    const auto& segments = session_.document.track.segments;
    for (std::size_t i = 0; i < now.count; ++i)
      if (made().turns[before.first + i] != world::segment(session_.document, segments[now.first + i]).turns)
        return false;
    bool stays = true, moves = true;
    const sim::Carry carry = carry_of(before, now);
    for (std::size_t i = 0; i <= now.count && (stays || moves); ++i) {
      const Side side{i > 0, i < now.count};
      if (side.in && side.out && std::binary_search(respun_.begin(), respun_.end(), entity(now, i))) return false;
      stays = stays && same(former(before, i), present(now, i), side);
      moves = moves && moved(carry, former(before, i), present(now, i), side);
    }
    return stays || moves;
  }

 private:
  // Uses the headings from its first knot to the one that was farthest from it in plan, where rounding has the least
  // effect.
  sim::Carry carry_of(const world::SectionRun& before, const world::SectionRun& now) const {
    const auto way = [](const Knot& from, const Knot& to) { return dvec3(to.position) - dvec3(from.position); };
    std::size_t farthest = 0;
    double most = 0;
    for (std::size_t i = 1; i <= now.count; ++i) {
      const dvec3 d = way(former(before, 0), former(before, i));
      if (const double square = d.x * d.x + d.z * d.z; square > most) most = square, farthest = i;
    }
    return sim::carry_between(dvec3(former(before, 0).position), way(former(before, 0), former(before, farthest)),
                              dvec3(present(now, 0).position), way(present(now, 0), present(now, farthest)));
  }
  const sim::Derived::Made& made() const { return session_.derived.made; }
  const Knot& former(const world::SectionRun& run, std::size_t i) const {
    return made().knots[(run.first + i) % made().knots.size()];
  }
  world::Entity entity(const world::SectionRun& run, std::size_t i) const {
    const auto& knots = session_.document.track.knots;
    return knots[(run.first + i) % knots.size()];
  }
  const Knot& present(const world::SectionRun& run, std::size_t i) const {
    return world::knot(session_.document, entity(run, i));
  }

  const Session& session_;
  std::vector<world::Entity> respun_;
};

}  // namespace

std::vector<PlannedSection> planned_sections(const world::Document& document) {
  std::vector<PlannedSection> planned;
  const auto& sections = document.entities.pool<world::Section>().items();
  if (std::all_of(sections.begin(), sections.end(), [](const auto& s) { return s.kind == world::SectionKind::free; }))
    return planned;
  for (const world::SectionRun& run : world::sections_of(document))
    if (const world::Section& value = world::section(document, run.section); value.kind != world::SectionKind::free)
      planned.push_back({run, value});
  return planned;
}

void free_hand_shaped(const std::vector<PlannedSection>& before, Session& session, Change& change) {
  if (before.empty()) return;
  world::Document& document = session.document;
  const Comparison comparison(session, change);
  std::vector<std::string> freed;
  for (const world::SectionRun& run : world::sections_of(document)) {
    const auto was = std::find_if(before.begin(), before.end(),
                                  [&](const PlannedSection& planned) { return planned.run.section == run.section; });
    world::Section& section = document.entities.get<world::Section>(run.section);
    if (was == before.end() || !(was->value == section) || comparison.keeps_its_plan(was->run, run)) continue;
    if (std::find(change.planned.begin(), change.planned.end(), run.section) != change.planned.end()) continue;
    freed.push_back(world::words_of(section));
    section = {section.title};
  }
  if (freed.empty()) return;
  if (!change.note.empty()) change.note += ' ';
  change.note += freed.size() == 1 ? base::sentence(freed.front() + " is now hand-shaped")
                                   : fmt::format("{} sections are now hand-shaped.", freed.size());
}

}  // namespace coaster::edit
