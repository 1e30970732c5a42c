// Plans sections again in their place, with what follows them, and keeps circuits closed.
#include "edit/perform/replan.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "curve/arc_length.h"
#include "curve/continuity.h"
#include "curve/frames.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/job_result.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Document;
using world::Entity;
using world::Knot;
using world::SectionRun;
using world::Train;

// The start positions of a section's trains, as fractions of its length.
using TrainFractions = std::vector<std::pair<Entity, double>>;

std::vector<double> lengths_of(const Document& document, const SectionRun& run) {
  std::vector<double> ends{0};
  for (std::size_t i = run.first; i < run.end(); ++i)
    ends.push_back(ends.back() + curve::arc_length(world::cubic_of(document, document.track.segments[i])));
  return ends;
}

TrainFractions starts_on(const Document& document, const SectionRun& run) {
  TrainFractions starts;
  const auto& carts = document.entities.pool<Train>();
  std::vector<double> ends;
  for (std::size_t i = 0; i < carts.size(); ++i) {
    const Train& cart = carts.items()[i];
    const std::size_t at = *world::index_of(document.track.segments, cart.segment);
    if (at < run.first || at >= run.end()) continue;
    if (ends.empty()) ends = lengths_of(document, run);
    const std::size_t k = at - run.first;
    const double s = ends[k] + cart.fraction * (ends[k + 1] - ends[k]);
    starts.emplace_back(carts.entities()[i], ends.back() > 0 ? s / ends.back() : 0.0);
  }
  return starts;
}

void put_back(const TrainFractions& starts, const SectionRun& run, Document& document) {
  if (starts.empty()) return;
  const std::vector<double> ends = lengths_of(document, run);
  for (const auto& [e, fraction] : starts) {
    const double s = fraction * ends.back();
    std::size_t k = 0;
    while (k + 1 < run.count && s >= ends[k + 1]) ++k;
    const double length = ends[k + 1] - ends[k];
    Train& cart = document.entities.get<Train>(e);
    cart.segment = document.track.segments[run.first + k];
    cart.fraction = length > 0 ? std::clamp((s - ends[k]) / length, 0.0, std::nextafter(1.0, 0.0)) : 0.0;
  }
}

// True if the carry moves no knot by a visible or palpable amount: its joint stays G2.
bool stays(const sim::UprightMove& carry) {
  constexpr double kDistance = 1e-4, kAngle = 1e-6;  // m, rad
  return glm::distance(carry.from, carry.to) <= kDistance && carry.cos > 0 && std::abs(carry.sin) <= kAngle;
}

// Gives the section's knots the plan's shape. Its last knot keeps the values that belong to the track after it.
void shape_knots(const sim::ElementFit& fit, const SectionRun& run, bool follows, Document& document) {
  Knot& start = nth_knot(document, run.first);
  start.joint = world::JointKind::aligned;
  start.out_length = fit.knots.front().out_length;
  for (std::size_t i = 1; i <= run.count; ++i) {
    Knot planned = fit.knots[i];
    Knot& into = nth_knot(document, run.first + i);
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
         std::ranges::all_of(
             kNames, [&](std::string_view name) { return world::found_value(a, name) == world::found_value(b, name); });
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

// Returns how deep the deepest knot is below the ground, or under a land's water, m; 0 if none is.
float depth_of_knots(const Document& document) {
  const sim::Land land(document.park);
  float deepest = 0;
  for (const Entity knot : document.track.knots)
    deepest = std::max(deepest, static_cast<float>(land.depth(glm::dvec3(world::knot(document, knot).position))));
  return deepest;
}

using glm::dvec3;
using world::SectionKind;

// Properties of a section's end that the following track shares, besides the knot's frame.
struct BendAndSpin {
  dvec3 curvature;  // 1/m
  double spin;      // rad/m
};
BendAndSpin bend_and_spin(const Document& document, const SectionRun& run) {
  const Knot& knot = nth_knot(document, run.end());
  const curve::Cubic cubic = world::cubic_of(document, document.track.segments[run.end() - 1]);
  return {curve::across(curve::curvature_vector(cubic, 1.0), glm::normalize(dvec3(knot.tangent))), knot.spin};
}

bool alike(const BendAndSpin& a, const BendAndSpin& b, const sim::UprightMove& carry) {
  constexpr double kBend = 5e-5, kSpin = 1e-4;  // 1/m, rad/m
  return glm::distance(carry.direction(a.curvature), b.curvature) <= kBend && std::abs(a.spin - b.spin) <= kSpin;
}

// Returns the section that begins where a run ends; none at the end of an open track.
Entity section_after(const Document& document, const SectionRun& run) {
  const std::vector<Entity>& segments = document.track.segments;
  if (!is_followed(document, run)) return world::kNone;
  return world::segment(document, segments[run.end() % segments.size()]).section;
}

// Changes of speed up to this leave a section as it is.
constexpr double kSameSpeed = 0.002;  // m/s

// Returns the energy with which the train comes to a force section of the document, m^2/s^2: twice that of a kilogram.
// Nothing for other sections, and where the document has none of that name.
std::optional<double> energy_at(const Document& document, Entity section) {
  const auto* const value = document.entities.find<world::Section>(section);
  if (value == nullptr || value->kind != SectionKind::force) return std::nullopt;
  const double height = nth_knot(document, world::run_of(document, section).first).position.y;
  return value->force.speed * value->force.speed + 2 * world::kGravity * height;
}

// Gives a force section the speed at which the train comes with what it has gained.
void put_speed(const Session& session, const Change& change, Document& document, Entity section) {
  const std::optional<double> former = energy_at(session.document, section);
  if (!change.gained || !former) return;
  double& speed = document.entities.get<world::Section>(section).force.speed;
  const double square = speed * speed + *former + *change.gained - *energy_at(document, section);
  if (square < world::kSlowestForce * world::kSlowestForce) return;
  if (const double now = std::sqrt(square); std::abs(now - speed) > kSameSpeed) speed = now;
}

// True if one of the segments from `first` to before `end` has equipment.
bool has_equipment(const Document& document, std::size_t first, std::size_t end) {
  for (std::size_t i = first; i < end; ++i)
    if (document.entities.find<world::Equipment>(document.track.segments[i]) != nullptr) return true;
  return false;
}

// How a section of each kind is planned again from its start when planned track before it ends in another way. Null: it
// is moved along; the one that closes a circuit adapts at the end (keep_closed).
using PlanAgain = Status (*)(Session& session, Change& change, Document& document, Entity section);
PlanAgain planner_of(SectionKind kind) {
  switch (kind) {
    case SectionKind::element:
      return [](Session& session, Change& change, Document& document, Entity section) {
        const world::Element as = world::section(document, section).element;
        return replan_element(session, change, document, section, as, FollowingTrack::planned);
      };
    case SectionKind::force: return replan_force;
    case SectionKind::free:
    case SectionKind::complete: return nullptr;
  }
  return nullptr;
}

// Gives the section the fit's shape and its last knot the fit's spin; the following track does not move.
void put_end(Document& document, const SectionRun& run, const sim::ElementFit& fit) {
  reshape(document, run.section, fit, SectionEnd::moves);
  nth_knot(document, world::run_of(document, run.section).end()).spin = fit.knots.back().spin;
}

// The conditions that the track imposes on a section's ends.
struct SectionEndConditions {
  Knot start, end;
  glm::dvec3 before, after;  // 1/m, the curvature of the track beside them
};
bool alike(const SectionEndConditions& a, const SectionEndConditions& b) {
  return a.start == b.start && a.end == b.end && glm::distance(a.before, b.before) <= sim::kElementJump &&
         glm::distance(a.after, b.after) <= sim::kElementJump;
}
SectionEndConditions ends_of(const Document& document, const SectionRun& run) {
  const auto& segments = document.track.segments;
  const auto cubic = [&](std::size_t i) { return world::cubic_of(document, segments[i % segments.size()]); };
  SectionEndConditions ends{nth_knot(document, run.first), nth_knot(document, run.end()),
                            curve::curvature_vector(cubic(run.first + segments.size() - 1), 1.0),
                            curve::curvature_vector(cubic(run.end()), 0.0)};
  // These belong to the section or follow from the curvatures of the track beside it.
  ends.start.out_length = ends.end.in_length = ends.start.in_length = ends.end.out_length = 0;
  ends.start.joint = ends.end.joint = world::JointKind::aligned;
  return ends;
}

// True if equipment between the first changed knot and the section gives trains a speed.
bool driven_between(const Document& former, const SectionRun& was, const Document& next, const SectionRun& run) {
  std::size_t same = 0;
  while (same < std::min(was.first, run.first) && nth_knot(former, same).position == nth_knot(next, same).position)
    ++same;
  const std::size_t first = same > 0 ? same - 1 : 0;
  return has_equipment(former, first, was.first) || has_equipment(next, first, run.first);
}

// Returns what the change asks of the section that completes the circuit.
sim::ClosingReplanTask change_of(const Session& session, const Document& former, const SectionRun& was,
                                 const Document& next, const SectionRun& run) {
  const std::size_t count = next.track.segments.size();
  sim::ClosingReplanTask change{.opened = stretch_of(next, run.end() % count, count - run.count),
                                .former = world::section(next, run.section).closing,
                                .losses = session.document.resistance,
                                .whole = !session.history.in_gesture};
  for (std::size_t i = was.first; i < was.end(); ++i)
    change.lengths.push_back(curve::arc_length(world::cubic_of(former, former.track.segments[i])));
  if (!driven_between(former, was, next, run))
    change.risen = double{nth_knot(next, run.first).position.y} - double{nth_knot(former, was.first).position.y};
  if (const world::Train* const cart = session.document.entities.find<world::Train>(chosen_cart(session)))
    change.losses.drag *= world::kCarMass / cart->mass;
  return change;
}

// Returns the closing section: the one that was found for this change, else searches for it. Nothing if another thread
// is to find it.
std::optional<sim::ClosingReplanResult> closing_for(Session& session, ClosingSearch* search,
                                                    sim::ClosingReplanTask change) {
  if (search && search->found && search->asked == change)
    return std::get<sim::ClosingReplanResult>(*std::exchange(search->found, std::nullopt));
  if (!search || !search->leaves) return sim::changed_closing(change, opened_track_of(session));
  search->wanted = std::move(change);
  return std::nullopt;
}

}  // namespace

std::string depth_text(std::string_view what, double depth, const Document& document) {
  return fmt::format("The {} goes {:.1f} m {}.", what, depth,
                     document.park.plain() ? "below the ground" : "under water");
}

Status adopt(Session& session, Change& change, const Document& former, Document&& next) {
  if (const Status taken = keep_closed(session, change, former, next); !taken) return taken;
  if (const auto broken = world::broken_invariant(next)) return refused("the track would leave the world: " + *broken);
  if (const float depth = depth_of_knots(next); change.clamped.empty() && depth > depth_of_knots(former) + 0.05f)
    change.clamped.push_back(depth_text("track", double{depth}, next));
  session.document = std::move(next);
  return {};
}

Status may_move(const Document& document, std::size_t knot) {
  if (!document.track.closed || world::completing(document, knot)) return {};
  return refused("the track is closed, and no closing section follows that can take up the change. Open it first");
}

Status carry_after(Document& document, std::size_t knot, const sim::UprightMove& carry) {
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
  const auto last = [&]() -> Knot& { return nth_knot(document, run.end()); };
  const TrainFractions starts = spans == run.count ? TrainFractions{} : starts_on(document, run);
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
  const bool follows = is_followed(document, run);
  sim::UprightMove carry;
  if (follows) {
    const base::Result<sim::UprightMove> found = sim::move_between(nth_knot(document, run.end()), fit.knots.back());
    if (!found) return found.status();
    carry = *found;
  }
  const bool moves = follows && !stays(carry);
  if (moves)
    if (const Status carried = carry_after(document, run.end(), carry); !carried) return carried;
  reshape(document, run.section, fit, moves ? SectionEnd::moves : follows ? SectionEnd::stays : SectionEnd::open);
  return {};
}

Status replan_element(Session& session, Change& change, Document& document, Entity section, const world::Element& as,
                      FollowingTrack following) {
  const SectionRun run = world::run_of(document, section);
  const sim::ElementPlan plan = sim::plan_element(as, sim::start_of(document, run));
  if (!plan.refusal.empty()) return refused(plan.refusal);
  if (const Status room = room_for_spans(session, document, run, plan.spans()); !room) return room;
  const Status put = following == FollowingTrack::moves ? put_in_place(document, run, plan.fit)
                                                        : put_and_follow(session, change, document, run, plan.fit);
  if (!put) return put;
  equip_again(document, plan, world::run_of(document, section));
  world::Section& value = document.entities.get<world::Section>(section);
  value = world::without_plan(value);
  value.kind = world::SectionKind::element, value.element = world::limited(plan.element);
  change.clamped.insert(change.clamped.end(), plan.lines.begin(), plan.lines.end());
  if (const double depth = sim::depth_of(plan, sim::Land(document.park)); depth > 0)
    change.clamped.push_back(depth_text("section", depth, document));
  return {};
}

Status perform(Session& session, Change& change, const ChangeSection& command) {
  const world::Entity section = entity_of(session, command.section);
  if (const Status good = well_formed(command.to); !good) return good;
  const Document& former = former_document(session, command.from_start, section);
  Document next = former;
  if (const Status planned = replan_element(session, change, next, section, command.to); !planned) return planned;
  return adopt(session, change, former, std::move(next));
}

Status put_and_follow(Session& session, Change& change, Document& document, const SectionRun& run,
                      const sim::ElementFit& fit) {
  const Entity next = section_after(document, run);
  const auto home = world::completing(document, run.end());
  if (home && home->first == run.end()) return put_end(document, run, fit), Status{};
  const SectionKind kind = next.valid() ? world::section(document, next).kind : SectionKind::free;
  const PlanAgain plan_again = planner_of(kind);
  if (plan_again == nullptr) return put_in_place(document, run, fit);
  const BendAndSpin before = bend_and_spin(document, run);
  const base::Result<sim::UprightMove> carry = sim::move_between(nth_knot(document, run.end()), fit.knots.back());
  Document moved = document;
  put_end(document, run, fit);
  if (carry && alike(before, bend_and_spin(document, world::run_of(document, run.section)), *carry)) {
    document = std::move(moved);
    return put_in_place(document, run, fit);
  }
  change.planned.push_back(next);
  if (has_equipment(document, run.first, run.end())) change.gained.reset();
  return plan_again(session, change, document, next);
}

Status replan_force(Session& session, Change& change, Document& document, Entity section) {
  const SectionRun run = world::run_of(document, section);
  put_speed(session, change, document, section);
  if (const std::optional<double> former = energy_at(session.document, section))
    change.gained = *energy_at(document, section) - *former;
  const sim::ForceTask task = sim::force_task(document, run, world::section(document, section).force);
  const sim::ForcePlan& plan = force_plans_of(session).plan(task);
  if (!plan.refusal.empty()) return refused(plan.refusal);
  if (const Status room = room_for_spans(session, document, run, plan.spans()); !room) return room;
  change.warn_of(sim::stop_text(plan));
  if (!session.history.in_gesture) change.warn_of(sim::missed_text(plan));
  if (task.held) {
    if (const std::string unmet = sim::unmet_text(plan); !unmet.empty() && !session.history.in_gesture)
      change.clamped.push_back(unmet);
    return reshape(document, section, plan.fit.spans, SectionEnd::stays), Status{};
  }
  const sim::ElementFit fit = plan.fit.spans;  // the memory may move while what follows is planned
  return put_and_follow(session, change, document, run, fit);
}

bool follow_speeds(Session& session, Change& change) {
  std::vector<Entity> sections;
  const auto& all = session.document.entities.pool<world::Section>().items();
  const auto count = std::count_if(all.begin(), all.end(), [](const auto& s) { return s.kind == SectionKind::force; });
  if (count == 0) return false;
  force_plans_of(session).make_room(static_cast<std::size_t>(count));
  for (const SectionRun& run : world::sections_of(session.document)) sections.push_back(run.section);
  bool changed = false;
  for (const Entity section : sections) {
    const world::Section& value = world::section(session.document, section);
    if (value.kind != SectionKind::force) continue;
    const SectionRun run = world::run_of(session.document, section);
    world::ForceProgram program = value.force;
    const std::optional<double> speed = SessionFindings(session).speed_at(session.derived.starts[run.first]);
    if (speed && !(std::abs(*speed - program.speed) <= kSameSpeed)) program.speed = *speed;
    const sim::ForceTask task = sim::force_task(session.document, run, program);
    if (force_plans_of(session).has(task)) continue;
    Document next = session.document;
    next.entities.get<world::Section>(section).force = program;
    change.gained.reset();
    Status status = replan_force(session, change, next, section);
    const bool differs = !(next == session.document);
    if (status && differs) status = adopt(session, change, session.document, std::move(next));
    if (!status) {
      change.warn_of(fmt::format("{} keeps its shape: {}", world::words_of(value), status.message));
    } else if (differs) {
      changed = true;
      change.planned.push_back(section);
      world::settle_joints(session.document);
      derive(session);
    }
  }
  return changed;
}

Status keep_closed(Session& session, Change& change, const Document& former, Document& next) {
  const std::optional<SectionRun> run = world::completing(next, 0);
  const std::size_t count = next.track.segments.size();
  if (!run || !former.entities.find<world::Section>(run->section)) return {};
  if (run->count == count) return refused("a circuit needs a section besides the one that completes it");
  const SectionRun was = world::run_of(former, run->section);
  if (alike(ends_of(former, was), ends_of(next, *run))) return {};
  const std::optional<sim::ClosingReplanResult> found =
      closing_for(session, change.search, change_of(session, former, was, next, *run));
  if (!found) return refused("the closing section is not found yet");
  if (!found->refusal.empty()) return refused(found->refusal);
  if (found->another) change.note = "The closing section takes another route.";
  if (const Status room = room_for_spans(session, next, *run, found->fit.knots.size() - 1); !room) return room;
  reshape(next, run->section, found->fit, SectionEnd::stays);
  next.entities.get<world::Section>(run->section).closing = found->closing;
  change.planned.push_back(run->section);
  return {};
}

}  // namespace coaster::edit
