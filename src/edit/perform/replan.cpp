#include "edit/perform/replan.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "base/text.h"
#include "curve/arc_length.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/force_replan.h"
#include "edit/perform/placing.h"
#include "edit/perform/take_up.h"
#include "sim/plan/force_plan.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Cart;
using world::Document;
using world::Entity;
using world::Knot;
using world::SectionRun;

// The start positions of a section's trains, as fractions of its length.
struct Starts {
  std::vector<std::pair<Entity, double>> carts;
};

std::vector<double> lengths_of(const Document& document, const SectionRun& run) {
  std::vector<double> ends{0};
  for (std::size_t i = run.first; i < run.end(); ++i)
    ends.push_back(ends.back() + curve::arc_length(world::cubic_of(document, document.track.segments[i])));
  return ends;
}

Starts starts_on(const Document& document, const SectionRun& run) {
  Starts starts;
  const auto& carts = document.entities.pool<Cart>();
  std::vector<double> ends;
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const Cart& cart = carts.items()[i];
    const std::size_t at = *world::index_of(document.track.segments, cart.segment);
    if (at < run.first || at >= run.end()) continue;
    if (ends.empty()) ends = lengths_of(document, run);
    const std::size_t k = at - run.first;
    const double s = ends[k] + cart.fraction * (ends[k + 1] - ends[k]);
    starts.carts.emplace_back(carts.entities()[i], ends.back() > 0 ? s / ends.back() : 0.0);
  }
  return starts;
}

void put_back(const Starts& starts, const SectionRun& run, Document& document) {
  if (starts.carts.empty()) return;
  const std::vector<double> ends = lengths_of(document, run);
  for (const auto& [e, fraction] : starts.carts) {
    const double s = fraction * ends.back();
    std::size_t k = 0;
    while (k + 1 < run.count && s >= ends[k + 1]) ++k;
    const double length = ends[k + 1] - ends[k];
    Cart& cart = document.entities.get<Cart>(e);
    cart.segment = document.track.segments[run.first + k];
    cart.fraction = length > 0 ? std::clamp((s - ends[k]) / length, 0.0, std::nextafter(1.0, 0.0)) : 0.0;
  }
}

// True if the carry moves no knot by a visible or palpable amount: its joint stays G2.
bool stays(const sim::Carry& carry) {
  constexpr double kDistance = 1e-4, kAngle = 1e-6;  // m, rad
  return glm::distance(carry.from, carry.to) <= kDistance && carry.cos > 0 && std::abs(carry.sin) <= kAngle;
}

// Gives the section's knots the plan's shape. Its last knot keeps the values that belong to the track after it.
void shape_knots(const sim::ElementFit& fit, const SectionRun& run, bool follows, Document& document) {
  const std::vector<Entity>& knots = document.track.knots;
  const auto knot = [&](std::size_t i) -> Knot& { return document.entities.get<Knot>(knots[i % knots.size()]); };
  Knot& start = knot(run.first);
  start.joint = world::JointKind::aligned;
  start.out_length = fit.knots.front().out_length;
  for (std::size_t i = 1; i <= run.count; ++i) {
    Knot planned = fit.knots[i];
    Knot& into = knot(run.first + i);
    if (i == run.count && follows)
      planned.out_length = into.out_length, planned.spin = into.spin, planned.spin_kind = into.spin_kind;
    into = planned;
  }
  for (std::size_t i = run.first; i < run.end(); ++i)
    document.entities.get<world::Segment>(document.track.segments[i]).turns = 0;
}

// True if both name the same equipment, or none, among their parameters.
bool same_equipment(const world::Element& a, const world::Element& b) {
  constexpr std::string_view kNames[] = {"equipment", "speed", "acceleration"};
  return a.kind == b.kind && world::found_value(a, kNames[0]) &&
         std::all_of(std::begin(kNames), std::end(kNames),
                     [&](std::string_view name) { return world::found_value(a, name) == world::found_value(b, name); });
}

// Applies the plan's equipment; if it is the same as before, the present equipment stays.
void equip_again(Document& document, const sim::ElementPlan& plan, const SectionRun& run) {
  const world::Section& before = world::section(document, run.section);
  const world::Element now = world::limited(plan.element);
  const bool planned = before.kind == world::SectionKind::element;
  if (planned && same_equipment(before.element, now)) return;
  if (planned && before.element.kind == now.kind && world::found_value(now, "equipment") == 0.0)
    for (std::size_t i = run.first; i < run.end(); ++i)
      document.entities.pool<world::Equipment>().erase(document.track.segments[i]);
  equip(document, plan, run.first);
}

// Returns the height of the lowest knot, at most 0, m.
float lowest_below_ground(const Document& document) {
  float lowest = 0;
  for (const Entity knot : document.track.knots) lowest = std::min(lowest, world::knot(document, knot).position.y);
  return lowest;
}

}  // namespace

Status adopt(Session& session, Change& change, const Document& former, Document&& next) {
  if (const Status taken = take_up(session, change, former, next); !taken) return taken;
  if (const auto broken = world::broken_invariant(next)) return refused("the track would leave the world: " + *broken);
  if (const float lowest = lowest_below_ground(next);
      change.clamped.empty() && lowest < lowest_below_ground(former) - 0.05f)
    change.clamped.push_back(fmt::format("The track goes {:.1f} m below the ground.", -lowest));
  session.document = std::move(next);
  return {};
}

Status may_move(const Document& document, std::size_t knot) {
  if (!document.track.closed || world::completing(document, knot)) return {};
  return refused("the track is closed, and no closing section follows that can take up the change. Open it first");
}

Status carry_after(Document& document, std::size_t knot, const sim::Carry& carry) {
  if (const Status may = may_move(document, knot); !may) return may;
  const world::Track& track = document.track;
  const std::size_t end = track.closed ? world::completing(document, knot)->first + 1 : track.knots.size();
  for (std::size_t i = knot + 1; i < end; ++i) {
    Knot& moved = document.entities.get<Knot>(track.knots[i]);
    moved = carry.knot(moved);
    for (int axis = 0; axis < 3; ++axis)
      if (!(std::abs(moved.position[axis]) <= world::kMaxCoordinate))
        return refused(fmt::format("what follows would go beyond the limit of coordinates, {} m",
                                   base::to_text(double{world::kMaxCoordinate})));
  }
  return {};
}

void reshape(Document& document, Entity section, const sim::ElementFit& fit, SectionEnd end) {
  const std::size_t spans = fit.knots.size() - 1;
  SectionRun run = world::run_of(document, section);
  const auto last = [&]() -> Knot& {
    return document.entities.get<Knot>(document.track.knots[run.end() % document.track.knots.size()]);
  };
  const Starts starts = spans == run.count ? Starts{} : starts_on(document, run);
  const Knot held = last();
  world::resize_section(document, section, spans);
  run.count = spans;
  shape_knots(fit, run, end != SectionEnd::open, document);
  if (end == SectionEnd::stays) {
    const Knot shaped = last();
    last() = held;
    last().in_length = shaped.in_length, last().joint = shaped.joint;
  }
  put_back(starts, run, document);
}

Status room_for_spans(const Session& session, const Document& document, const SectionRun& run, std::size_t spans) {
  return room_for(session, document.track.knots.size() + spans - run.count,
                  document.track.segments.size() + spans - run.count);
}

Status put_in_place(Document& document, const SectionRun& run, const sim::ElementFit& fit) {
  const bool follows = document.track.closed || run.end() < document.track.segments.size();
  sim::Carry carry;
  if (follows) {
    const base::Result<sim::Carry> found = sim::carry_between(nth_knot(document, run.end()), fit.knots.back());
    if (!found) return found.status();
    carry = *found;
  }
  const bool moves = follows && !stays(carry);
  if (moves)
    if (const Status carried = carry_after(document, run.end(), carry); !carried) return carried;
  reshape(document, run.section, fit, moves ? SectionEnd::moves : follows ? SectionEnd::stays : SectionEnd::open);
  return {};
}

Status replan(Session& session, Change& change, Document& document, Entity section, const world::Element& as,
              Following following) {
  const SectionRun run = world::run_of(document, section);
  const sim::ElementPlan plan = sim::plan_element(as, sim::start_of(document, run));
  if (!plan.refusal.empty()) return refused(plan.refusal);
  if (const Status room = room_for_spans(session, document, run, plan.spans()); !room) return room;
  const Status put = following == Following::moves ? put_in_place(document, run, plan.fit)
                                                   : put_and_follow(session, change, document, run, plan.fit);
  if (!put) return put;
  equip_again(document, plan, world::run_of(document, section));
  world::Section& value = document.entities.get<world::Section>(section);
  value = {value.title, world::SectionKind::element, world::limited(plan.element)};
  change.clamped.insert(change.clamped.end(), plan.lines.begin(), plan.lines.end());
  if (plan.lowest < 0)
    change.clamped.push_back(fmt::format("The section goes {:.1f} m below the ground.", -plan.lowest));
  return {};
}

Status perform(Session& session, Change& change, const ChangeSection& command) {
  const auto section = require(session, command.section, world::Kind::section);
  if (!section) return section.status();
  if (const Status good = well_formed(command.to); !good) return good;
  const Document& start = session.history.gesture_start;
  const bool from_start =
      command.from_start && session.history.in_gesture && start.entities.find<world::Section>(*section);
  const Document& former = from_start ? start : session.document;
  Document next = former;
  if (const Status planned = replan(session, change, next, *section, command.to); !planned) return planned;
  return adopt(session, change, former, std::move(next));
}

}  // namespace coaster::edit
