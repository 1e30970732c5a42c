// One pass after each command that changes the document: follow_change() at the end lists its steps.
#include "edit/perform/change_propagation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/portable_math.h"
#include "base/text.h"
#include "edit/perform/replan.h"
#include "sim/plan/upright_move.h"
#include "sim/shape/roll.h"
#include "world/sections.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

// A split keeps the shape, so distances stay; they are scaled only by the rounding of the lengths.
void follow_split(const MotionFollowUp& change, const sim::DerivedTrack& derived, world::TrainMotion& cart) {
  const double left = derived.shape(change.first).arc.length(), right = derived.shape(change.second).arc.length();
  const double s = cart.segment_length > 0 ? cart.s * ((left + right) / cart.segment_length) : 0;
  const bool beyond = s > left;
  cart.segment = beyond ? change.second : change.first;
  cart.s = beyond ? s - left : s;
  cart.segment_length = beyond ? right : left;
}

// The length stays that of both old segments: reconcile scales it to the survivor's.
void follow_merge(const MotionFollowUp& change, world::TrainMotion& cart) {
  if (cart.segment == change.second) cart.s += change.first_length;
  cart.segment = change.first;
  cart.segment_length = change.first_length + change.second_length;
}

// The rails stay and their direction is reversed: the rear of a train becomes its front, and it keeps moving the same
// way in space.
void follow_reversal(const world::Document& document, const sim::DerivedTrack& derived, world::Motion& motion) {
  for (std::size_t i = 0; i < motion.carts.size(); ++i) {
    world::TrainMotion& cart = motion.carts.items()[i];
    const auto index = world::index_of(derived.order, cart.segment);
    const world::Train* const design = document.entities.find<world::Train>(motion.carts.entities()[i]);
    if (!index || !design) continue;
    // `s` was measured from the present end of the segment.
    const double front = derived.starts[*index + 1] - cart.s, behind = design->behind();
    cart.track_distance = front + behind;
    if (derived.closed && derived.length > 0 && cart.track_distance >= derived.length)
      cart.track_distance -= derived.length;
    cart.segment = world::kNone;
    cart.speed = -cart.speed, cart.travelled = -cart.travelled, cart.laps = -cart.laps, cart.furthest = cart.travelled;
    cart.timetable = {};
  }
}

// Keeps moving trains at their positions on the rails while segments are added and removed. Only positions:
// sim::reconcile, which runs afterwards, handles energies and the rest.
void follow_on_rails(const MotionFollowUp& change, const world::Document& document, const sim::DerivedTrack& derived,
                     world::Motion& motion) {
  if (change.kind == MotionFollowUp::Kind::none) return;
  if (change.kind == MotionFollowUp::Kind::reversed) return follow_reversal(document, derived, motion);
  for (world::TrainMotion& cart : motion.carts.items()) {
    if (cart.segment != change.first && cart.segment != change.second) continue;
    if (change.kind == MotionFollowUp::Kind::split) follow_split(change, derived, cart);
    else follow_merge(change, cart);
  }
}

using glm::dvec3;
using world::Knot;

double largest(glm::vec3 v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The values of a knot that belong to a section.
struct SectionKnotHandles {
  bool in, out;  // the handles within the section; inside a section the spin also counts
};

bool same(const Knot& before, const Knot& now, SectionKnotHandles side) {
  return before.position == now.position && before.tangent == now.tangent && before.up == now.up &&
         (!side.in || before.in_length == now.in_length) && (!side.out || before.out_length == now.out_length) &&
         (!(side.in && side.out) || before.spin == now.spin);
}

bool near(float a, float b) { return std::abs(a - b) <= 1e-6f * (1 + std::abs(b)); }

// True if the values are the same after the carry, except for rounding to float.
bool moved(const sim::UprightMove& carry, const Knot& before, const Knot& now, SectionKnotHandles side) {
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

class SectionShapeComparison {
 public:
  SectionShapeComparison(const Session& session, const Change& change) : session_(session), respun_(change.respun) {
    std::sort(respun_.begin(), respun_.end());
  }

  bool keeps_its_plan(const world::SectionRun& before, const world::SectionRun& now) const {
    if (before.count != now.count) return false;
    const auto& segments = session_.document.track.segments;
    for (std::size_t i = 0; i < now.count; ++i)
      if (made().turns[before.first + i] != world::segment(session_.document, segments[now.first + i]).turns)
        return false;
    bool stays = true, moves = true;
    const sim::UprightMove carry = carry_of(before, now);
    for (std::size_t i = 0; i <= now.count && (stays || moves); ++i) {
      const SectionKnotHandles side{i > 0, i < now.count};
      if (side.in && side.out && std::binary_search(respun_.begin(), respun_.end(), entity(now, i))) return false;
      stays = stays && same(former(before, i), present(now, i), side);
      moves = moves && moved(carry, former(before, i), present(now, i), side);
    }
    return stays || moves;
  }

 private:
  // Uses the headings from its first knot to the one that was farthest from it in plan, where rounding has the least
  // effect.
  sim::UprightMove carry_of(const world::SectionRun& before, const world::SectionRun& now) const {
    const auto way = [](const Knot& from, const Knot& to) { return dvec3(to.position) - dvec3(from.position); };
    std::size_t farthest = 0;
    double most = 0;
    for (std::size_t i = 1; i <= now.count; ++i) {
      const dvec3 d = way(former(before, 0), former(before, i));
      if (const double square = d.x * d.x + d.z * d.z; square > most) most = square, farthest = i;
    }
    return sim::move_between(dvec3(former(before, 0).position), way(former(before, 0), former(before, farthest)),
                             dvec3(present(now, 0).position), way(present(now, 0), present(now, farthest)));
  }
  const sim::DerivedTrack::BuiltInputs& made() const { return session_.derived.made; }
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

// Makes those planned sections free whose shape differs from that before the command, unless the command planned them
// again.
void free_hand_shaped(const std::vector<PlannedSection>& before, Session& session, Change& change) {
  if (before.empty()) return;
  world::Document& document = session.document;
  const SectionShapeComparison comparison(session, change);
  std::vector<std::string> freed;
  for (const world::SectionRun& run : world::sections_of(document)) {
    const auto was =
        std::ranges::find(before, run.section, [](const PlannedSection& planned) { return planned.run.section; });
    world::Section& section = document.entities.get<world::Section>(run.section);
    if (was == before.end() || !(was->value == section) || comparison.keeps_its_plan(was->run, run)) continue;
    if (std::find(change.planned.begin(), change.planned.end(), run.section) != change.planned.end()) continue;
    freed.push_back(world::words_of(section));
    section = world::without_plan(section);
  }
  if (freed.empty()) return;
  if (!change.note.empty()) change.note += ' ';
  change.note += freed.size() == 1 ? base::sentence(freed.front() + " is now hand-shaped")
                                   : fmt::format("{} sections are now hand-shaped.", freed.size());
}

// A split only knows `up` at the new knot, which determines the twist of both halves except for whole turns: those
// follow from the segment's roll before it.
void share_turns(const MotionFollowUp& split, const sim::Roll& before, world::Document& document) {
  const sim::Roll left = sim::roll_of(document, split.first), right = sim::roll_of(document, split.second);
  if (!(left.length + right.length > 0)) return;
  const double angle = before.angle(before.length * (left.length / (left.length + right.length)));
  for (const auto& [e, missing] :
       {std::pair{split.first, angle - left.twist}, std::pair{split.second, before.twist - angle - right.twist}}) {
    std::int32_t& turns = document.entities.get<world::Segment>(e).turns;
    turns = std::clamp(turns + static_cast<std::int32_t>(std::lround(missing / (2 * base::kPi))), -world::kMaxTurns,
                       world::kMaxTurns);
  }
}

}  // namespace

std::vector<PlannedSection> planned_sections(const world::Document& document) {
  std::vector<PlannedSection> planned;
  const auto& sections = document.entities.pool<world::Section>().items();
  if (std::ranges::all_of(sections, [](const auto& s) { return s.kind == world::SectionKind::free; })) return planned;
  for (const world::SectionRun& run : world::sections_of(document))
    if (const world::Section& value = world::section(document, run.section); value.kind != world::SectionKind::free)
      planned.push_back({run, value});
  return planned;
}

void follow_by_distance(const world::Document& present, const world::Document& next, const sim::DerivedTrack& derived,
                        world::Motion& motion) {
  for (world::TrainMotion& cart : motion.carts.items()) {
    const auto* const now = present.entities.find<world::Segment>(cart.segment);
    const auto* const then = next.entities.find<world::Segment>(cart.segment);
    if (now && then && now->from == then->from && now->to == then->to) continue;
    if (const auto index = world::index_of(derived.order, cart.segment))
      cart.track_distance = derived.starts[*index] + cart.s;
    cart.segment = world::kNone;
  }
}

void settle_trains(Session& session) {
  if (base::interrupted()) return;
  // A ride that has not started (or has no trains) puts the trains at their start; any other keeps their positions.
  if (session.motion.state == world::RideState::stopped || session.document.entities.pool<world::Train>().size() == 0)
    sim::reset(session.document, session.derived, session.motion);
  else sim::reconcile(session.document, session.derived, session.motion);
  world::drop_dead(session.document, session.settings);
}

void follow_change(Session& session, Change& change, const std::vector<PlannedSection>& before) {
  world::Document& document = session.document;
  // Automatic joints follow their neighbours, which may have moved.
  world::settle_joints(document);
  // Sections that the command shaped by hand lose their plan; `derived` still holds the shapes before the command.
  free_hand_shaped(before, session, change);
  // Whole turns and automatic spins follow from the twists between the knots, and shapes depend on both.
  const sim::SegmentShape* const split = session.derived.segments.find(change.motion.first);
  if (change.motion.kind == MotionFollowUp::Kind::split && split) share_turns(change.motion, split->roll, document);
  sim::set_automatic_spins(document, change.respun);
  // Each changed segment once.
  derive(session);
  if (base::interrupted()) return;
  // Trains stay where they are on the rails, and the selection is the command's.
  follow_on_rails(change.motion, document, session.derived, session.motion);
  if (change.select) session.settings.selected = *change.select, session.settings.also = change.also;
  settle_trains(session);
  // Trains may now come to force sections at another speed, so these are planned again, from the front. Each that
  // changes is derived at once, because the speed after it depends on its shape.
  if (follow_speeds(session, change)) settle_trains(session);
}

}  // namespace coaster::edit
