// Commands that divide the track into sections, name them and equip them.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "base/units.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/perform_context.h"
#include "edit/perform/replan.h"
#include "exchange/formats.h"
#include "exchange/own/track_file.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using glm::dvec3;
using world::Document;
using world::Entity;
using world::Knot;
using world::SectionRun;

// --- Commands of the palette: place an element at the open end, select and preview one

// Reports what was placed, or else its warnings.
void report(const sim::ElementPlan& plan, double missing, const world::Document& document, Change& change) {
  change.clamped.insert(change.clamped.end(), plan.lines.begin(), plan.lines.end());
  if (const double depth = sim::depth_of(plan, sim::Land(document.park)); depth > 0)
    change.clamped.push_back(depth_text("element", depth, document));
  if (missing > 0)
    change.clamped.push_back(
        fmt::format("The element is {:.1f} m too close to other track for a train to pass.", missing));
  if (!plan.forces && !plan.fit.within)
    change.clamped.push_back(fmt::format("The fit error is {} m because the element is far from the origin.",
                                         base::to_text(static_cast<float>(plan.fit.error))));
  if (plan.forces || !change.clamped.empty()) return;  // the warning should be the newest notice
  change.note = fmt::format("Placed {}: {:.1f} m, fit error {:.1f} mm.", world::words_of(plan.element.kind),
                            plan.length, plan.fit.error * 1000);
}

// Stores the present equipment in the parameters of a planned section, so that it keeps it when it is planned again.
void name_equipment(world::Section& section, const world::Equipment* equipment) {
  if (section.kind != world::SectionKind::element || !world::found_value(section.element, "equipment")) return;
  world::set_value(section.element, "equipment", equipment ? world::equipment_choice(equipment->kind) : 0);
  if (!equipment) return;
  world::set_value(section.element, "speed", equipment->speed);
  world::set_value(section.element, "acceleration", equipment->acceleration);
}

// Returns the element with left and right swapped.
world::Element mirrored(world::Element element) {
  const world::ElementRow& row = base::row_of(element.kind);
  if (row.sided) element.right = !element.right;
  world::set_value(element, "roll", 0.0 - world::found_value(element, "roll").value_or(0));
  return element;
}

// Returns the program with left and right swapped.
world::ForceProgram mirrored(world::ForceProgram program) {
  program.hold = false;  // its end moves to the other side
  for (const auto channel : {world::ForceChannel::lateral, world::ForceChannel::roll})
    for (world::ForceKey& key : program.keys(channel)) key.value = 0.0 - key.value, key.slope = 0.0 - key.slope;
  return program;
}

// Mirrors a hand-shaped section across the vertical plane of its first knot's direction, and moves the track that
// follows.
Status mirror_knots(Document& document, const SectionRun& run) {
  constexpr double kUpright = 1e-4, kSteep = 0.1;  // of unit vectors
  const Knot start = nth_knot(document, run.first), end = nth_knot(document, run.end());
  const dvec3 level(start.tangent.x, 0, start.tangent.z);
  if (!(glm::length(level) > kSteep)) return refused("the section begins too steep to have a left and a right");
  const dvec3 side = glm::normalize(glm::cross(level, dvec3(0, 1, 0)));
  if (!(std::abs(glm::dot(dvec3(start.up), side)) <= kUpright))
    return refused("the section begins rolled, and would have to begin rolled to the other side");
  const auto across = [&](dvec3 v) { return v - 2.0 * glm::dot(v, side) * side; };
  const auto reflect = [&](Knot knot) {
    knot.position = glm::vec3(dvec3(start.position) + across(dvec3(knot.position) - dvec3(start.position)));
    knot.tangent = glm::vec3(across(dvec3(knot.tangent)));
    knot.up = glm::vec3(across(dvec3(knot.up)));
    knot.spin = 0.0f - knot.spin;
    world::orthonormalise(knot);
    return knot;
  };
  if (is_followed(document, run)) {
    const base::Result<sim::UprightMove> carry = sim::move_between(end, reflect(end));
    if (!carry) return carry.status();
    if (const Status carried = carry_after(document, run.end(), *carry); !carried) return carried;
  }
  for (std::size_t i = 1; i <= run.count; ++i) {
    Knot& knot = nth_knot(document, run.first + i);
    knot = reflect(knot);
  }
  for (std::size_t i = run.first; i < run.end(); ++i) {
    world::Segment& segment = document.entities.get<world::Segment>(document.track.segments[i]);
    segment.turns = -segment.turns;
  }
  return {};
}

// Swaps the sections of two neighbouring runs; each begins in the frame in which the other one began or ended.
Status swap_runs(Document& document, const SectionRun& run, const SectionRun& next) {
  const Knot a = nth_knot(document, run.first), b = nth_knot(document, run.end()), c = nth_knot(document, next.end());
  const bool follows = next.end() < document.track.segments.size();
  const auto second = sim::move_between(b, a);
  if (!second) return second.status();
  const auto first = sim::move_between(a, second->knot(c));
  if (!first) return first.status();
  const auto rest = sim::move_between(c, first->knot(b));
  if (follows && !rest) return rest.status();
  if (follows)
    if (const Status carried = carry_after(document, next.end(), *rest); !carried) return carried;
  for (std::size_t i = run.first + 1; i <= next.end(); ++i) {
    Knot& knot = nth_knot(document, i);
    knot = (i <= run.end() ? *first : *second).knot(knot);
  }
  begin_there(nth_knot(document, run.first), b.out_length);
  begin_there(nth_knot(document, next.end()), a.out_length);
  begin_there(nth_knot(document, run.end()), follows ? c.out_length : b.in_length);
  world::swap_sections(document, run.section);
  return {};
}

// Returns the section as it is without the track around it: a closing section becomes free.
world::Section alone(world::Section section) {
  if (section.kind != world::SectionKind::complete) return section;
  section.title = world::title_of(section);
  return world::without_plan(section);
}

// Returns a track of only this section.
Document track_of(const Document& document, const SectionRun& run) {
  Document track = stretch_of(document, run.first, run.count);
  const world::Section& section = world::section(document, run.section);
  track.name = world::title_of(section);
  world::make_section(track, 0, run.count, alone(section));
  return track;
}

// Adds a hand-shaped section at the open end, turned so that it continues the track.
Status append_run(const Document& from, const SectionRun& run, Document& document) {
  const auto knot = [&](std::size_t i) {
    Knot copy = nth_knot(from, run.first + i);
    shaped_by_hand(copy);
    return copy;
  };
  sim::UprightMove carry;
  if (!document.track.knots.empty()) {
    const auto found = sim::move_between(knot(0), world::knot(document, document.track.knots.back()));
    if (!found) return found.status();
    carry = *found;
  }
  open_out(document, knot(0));
  for (std::size_t i = 1; i <= run.count; ++i) {
    world::append_knot(document, carry.knot(knot(i)));
    const world::Segment& segment = world::segment(from, from.track.segments[run.first + i - 1]);
    document.entities.get<world::Segment>(document.track.segments.back()).turns = segment.turns;
  }
  const std::size_t first = document.track.segments.size() - run.count;
  world::make_section(document, first, run.count, alone(world::section(from, run.section)));
  return {};
}

// Copies name and look of a section, but not its plan.
void take_name(const world::Section& from, world::Section& section) {
  section.title = from.title;
  world::take_look(from, section);
}

// Adds a section at the open end, planned again from there if it was planned. Its segments get the fittings of those of
// the original; additional ones get those of the last.
Status paste(Change& change, const Document& from, const SectionRun& run, Document& document) {
  const world::Section& value = world::section(from, run.section);
  const std::size_t before = document.track.segments.size();
  if (value.kind == world::SectionKind::element) {
    const sim::ElementPlan plan = sim::plan_element(value.element, document);
    if (!plan.refusal.empty()) return refused(plan.refusal);
    take_name(value, document.entities.get<world::Section>(place(document, plan)));
    change.clamped.insert(change.clamped.end(), plan.lines.begin(), plan.lines.end());
  } else if (const auto end = sim::open_end(document); end && value.kind == world::SectionKind::force) {
    const sim::ForcePlan plan = sim::plan_force(sim::force_task(document, *end, value.force));
    if (!plan.refusal.empty()) return refused(plan.refusal);
    take_name(value, document.entities.get<world::Section>(place_force(document, plan)));
  } else if (const Status appended = append_run(from, run, document); !appended) {
    return appended;
  }
  for (std::size_t i = before; i < document.track.segments.size(); ++i)
    world::copy_fittings(from, from.track.segments[run.first + std::min(i - before, run.count - 1)], document,
                         document.track.segments[i]);
  return {};
}

// Adds all sections before the one that completes the circuit. That one gets a new start and is not shaped yet. Returns
// the last section added; kNone if there is none.
base::Result<Entity> paste_before(Change& change, const Document& from, const SectionRun& home, Document& document) {
  const std::size_t count = document.track.segments.size();
  const Entity last = document.track.segments[(home.first + count - 1) % count];
  const SectionRun before = world::run_of(document, world::segment(document, last).section);
  Document open = stretch_of(document, home.end() % count, count - home.count);
  const std::size_t old = open.track.segments.size();
  for (const SectionRun& run : world::sections_of(from))
    if (const Status pasted = paste(change, from, run, open); !pasted) return pasted;
  const std::size_t added = open.track.segments.size() - old;
  world::resize_section(document, before.section, before.count + added);
  for (std::size_t i = 0; i <= added; ++i)
    nth_knot(document, before.end() + i) = world::knot(open, open.track.knots[old + i]);
  for (std::size_t i = 0; i < added; ++i) {
    const Entity own = open.track.segments[old + i], into = document.track.segments[before.end() + i];
    document.entities.get<world::Segment>(into).turns = world::segment(open, own).turns;
    document.entities.pool<world::Equipment>().erase(into);
    world::copy_fittings(open, own, document, into);
  }
  Entity made;
  for (const SectionRun& run : world::sections_of(open))
    if (run.first >= old)
      made =
          world::make_section(document, before.end() + run.first - old, run.count, world::section(open, run.section));
  return made;
}

base::Result<Document> sections_alone(const Session& session, Change& change, const Sections& named) {
  const auto sections = chosen_sections(session, named);
  if (!sections) return sections.status();
  const Document& document = session.document;
  const auto run = [&](std::size_t i) { return world::run_of(document, (*sections)[i]); };
  Document alone = track_of(document, run(0));
  for (std::size_t i = 1; i < sections->size(); ++i)
    if (const Status joined = paste(change, document, run(i), alone); !joined) return joined;
  return alone;
}

// Returns the only section of a track in words, or "3 sections".
std::string words_of_all(const Document& track) {
  const std::vector<SectionRun> all = world::sections_of(track);
  return all.size() == 1 ? world::words_of(world::section(track, all[0].section))
                         : fmt::format("{} sections", all.size());
}

// Adds the sections of a track at the open end, or before the one that completes the circuit. `done` is "Pasted" or
// "Added".
Status add_sections(Session& session, Change& change, const Document& from, std::string_view done) {
  Document next = session.document;
  change.note = fmt::format("{} {}.", done, words_of_all(from));
  if (const auto home = world::completing(next, 0)) {
    const base::Result<Entity> last = paste_before(change, from, *home, next);
    if (!last) return last.status();
    change.select = *last;
  } else {
    for (const SectionRun& run : world::sections_of(from))
      if (const Status pasted = paste(change, from, run, next); !pasted) return pasted;
    if (!next.track.segments.empty()) change.select = world::segment(next, next.track.segments.back()).section;
  }
  if (next.track.segments.size() == session.document.track.segments.size()) return refused("the track has no sections");
  if (const Status room = room_for(session, next.track.knots.size(), next.track.segments.size()); !room) return room;
  if (session.document.track.segments.empty()) add_first_train(next);
  return adopt(session, change, session.document, std::move(next));
}

}  // namespace

Status perform(Session& session, Change& change, const MakeSection& command) {
  const auto knots = knots_of(session, command.knots);
  if (!knots) return knots.status();
  world::Document& document = session.document;
  const std::vector<KnotRun> runs = runs_of(document, *knots);
  const std::size_t first = runs.front().places.front(), count = knots->size() - (runs.front().whole ? 0 : 1);
  if (runs.size() != 1 || count == 0) return refused("expected two or more neighbouring knots");
  if (first + count > document.track.segments.size())
    return refused("a section cannot continue beyond the first knot of a closed track");
  world::Section made;
  world::take_look(world::section(document, world::segment(document, document.track.segments[first]).section), made);
  change.select = world::make_section(document, first, count, std::move(made));
  return {};
}

Status perform(Session& session, Change& change, const SplitSection& command) {
  const world::Entity knot = entity_of(session, command.knot);
  world::Document& document = session.document;
  const std::size_t at = *world::index_of(document.track.knots, knot);
  const auto section_at = [&](std::size_t i) {
    return i < document.track.segments.size() ? world::segment(document, document.track.segments[i]).section
                                              : world::kNone;
  };
  const Entity section = section_at(at);
  if (at == 0 || !section.valid() || section_at(at - 1) != section)
    return refused(fmt::format("@{} is not inside a section", world::label_of(document, knot)));
  const SectionRun run = world::run_of(document, section);
  world::Section rest;
  world::take_look(world::section(document, section), rest);
  change.select = world::make_section(document, at, run.end() - at, std::move(rest));
  return {};
}

Status perform(Session& session, Change& change, const JoinSections& command) {
  const world::Entity section = entity_of(session, command.section);
  world::Document& document = session.document;
  const std::vector<SectionRun> runs = world::sections_of(document);
  const SectionRun run = world::run_of(document, section);
  if (run.end() == document.track.segments.size())
    return refused("there is no section after " + world::words_of(world::section(document, section)));
  const SectionRun next = world::run_of(document, world::segment(document, document.track.segments[run.end()]).section);
  world::Section joined = world::without_plan(world::section(document, section));
  if (joined.title.empty()) joined.title = world::section(document, next.section).title;
  change.select = world::make_section(document, run.first, run.count + next.count, std::move(joined));
  return {};
}

Status perform(Session& session, Change&, const SetSectionTitle& command) {
  const world::Entity section = entity_of(session, command.section);
  if (const Status may = may_be_called(command.to, "title"); !may) return may;
  session.document.entities.get<world::Section>(section).title = command.to;
  return {};
}

Status perform(Session& session, Change& change, const EquipSection& command) {
  const world::Entity section = entity_of(session, command.section);
  const world::Equipment equipment = equipment_of(command.to, change);
  const SectionRun run = world::run_of(session.document, section);
  auto& kept = session.document.entities.get<world::Section>(section);
  const std::span<const Entity> segments = session.document.track.segments;
  equip(session.document, change, segments.subspan(run.first, run.count), equipment, world::words_of(kept));
  name_equipment(kept, &equipment);
  return {};
}

Status perform(Session& session, Change& change, const UnequipSection& command) {
  const world::Entity section = entity_of(session, command.section);
  const SectionRun run = world::run_of(session.document, section);
  auto& equipment = session.document.entities.pool<world::Equipment>();
  const std::size_t before = equipment.size();
  for (std::size_t i = run.first; i < run.end(); ++i) equipment.erase(session.document.track.segments[i]);
  if (equipment.size() == before)
    return refused("there is no equipment on " + world::words_of(world::section(session.document, section)));
  auto& kept = session.document.entities.get<world::Section>(section);
  name_equipment(kept, nullptr);
  change.note = fmt::format("Removed the equipment of {}.", world::words_of(kept));
  return {};
}

Status perform(Session& session, Change& change, const DeleteSection& command) {
  const world::Entity section = entity_of(session, command.section);
  Document next = session.document;
  const SectionRun run = world::run_of(next, section);
  if (const Status may = may_move(next, run.end()); !may) return may;
  const bool closes_gap = run.first > 0 && run.end() < next.track.segments.size();
  const std::string title = world::words_of(world::section(next, section));
  if (closes_gap) {
    const Knot start = nth_knot(next, run.first), end = nth_knot(next, run.end());
    const auto carry = sim::move_between(end, start);
    if (!carry) return carry.status();
    if (const Status carried = carry_after(next, run.end(), *carry); !carried) return carried;
    begin_there(nth_knot(next, run.first), end.out_length);
  }
  world::remove_section(next, section);
  const auto trains = [](const Document& document) { return document.entities.pool<world::Train>().size(); };
  const std::size_t lost = trains(session.document) - trains(next);
  change.note = fmt::format("Deleted {}{}.{}", title,
                            lost == 0   ? ""
                            : lost == 1 ? " and the train on it"
                                        : " and the trains on it",
                            closes_gap ? " The track behind it closes the gap." : "");
  return adopt(session, change, session.document, std::move(next));
}

Status perform(Session& session, Change& change, const MirrorSection& command) {
  const world::Entity section = entity_of(session, command.section);
  Document next = session.document;
  world::Section& value = next.entities.get<world::Section>(section);
  const bool same = value.kind == world::SectionKind::element && mirrored(value.element) == value.element;
  if (value.kind == world::SectionKind::force) value.force = mirrored(value.force);
  const Status done = value.kind == world::SectionKind::element
                          ? replan_element(session, change, next, section, mirrored(value.element))
                      : value.kind == world::SectionKind::force ? replan_force(session, change, next, section)
                                                                : mirror_knots(next, world::run_of(next, section));
  if (!done) return done;
  const std::string title = world::words_of(world::section(next, section));
  change.note = same ? base::sentence(title + " is the same to both sides") : fmt::format("Mirrored {}.", title);
  return adopt(session, change, session.document, std::move(next));
}

Status perform(Session& session, Change& change, const MoveSection& command) {
  const world::Entity section = entity_of(session, command.section);
  Document next = session.document;
  const std::vector<SectionRun> runs = world::sections_of(next);
  const auto at = std::find(runs.begin(), runs.end(), world::run_of(next, section));
  const bool earlier = command.to == Neighbour::before;
  const auto title = [&](const SectionRun& run) { return world::words_of(world::section(next, run.section)); };
  if (earlier ? at == runs.begin() : at + 1 == runs.end())
    return refused(fmt::format("there is no section {} {}", earlier ? "before" : "after", title(*at)));
  const auto first = earlier ? at - 1 : at;
  if (const Status may = may_move(next, (first + 1)->end()); !may) return may;
  change.note =
      fmt::format("Moved {} {} {}.", title(*at), earlier ? "before" : "after", title(earlier ? *first : *(at + 1)));
  if (const Status swapped = swap_runs(next, *first, *(first + 1)); !swapped) return swapped;
  return adopt(session, change, session.document, std::move(next));
}

Document stretch_of(const Document& document, std::size_t first, std::size_t count) {
  Document stretch;
  stretch.curve = document.curve, stretch.heartline = document.heartline;
  const auto& segments = document.track.segments;
  for (std::size_t i = 0; i <= count; ++i) world::append_knot(stretch, nth_knot(document, first + i));
  for (std::size_t i = 0; i < count; ++i) {
    const Entity from = segments[(first + i) % segments.size()], to = stretch.track.segments[i];
    stretch.entities.get<world::Segment>(to).turns = world::segment(document, from).turns;
    world::copy_fittings(document, from, stretch, to);
  }
  for (Knot& knot : stretch.entities.pool<Knot>().items()) shaped_by_hand(knot);
  return stretch;
}

Status perform(Session& session, Change& change, const CopySection& command) {
  const auto alone = sections_alone(session, change, command.sections);
  if (!alone) return alone.status();
  session.copied = exchange::print_track(*alone);
  change.note = fmt::format("Copied {}.", words_of_all(*alone));
  return {};
}

Status perform(Session& session, Change& change, const PasteSections& command) {
  const std::string& text = command.text.empty() ? session.copied : command.text;
  if (text.empty()) return refused("nothing was copied: copy sections first");
  if (const Status may = may_move(session.document, 0); !may) return may;
  const auto loaded = exchange::parse_track(text, "clipboard");
  if (!loaded) return refused(loaded.status().message);
  return add_sections(session, change, loaded->document, "Pasted");
}

Status perform(Session& session, Change& change, const SaveSections& command) {
  if (command.path.empty()) return refused("expected a file to save to");
  if (is_own_file(session, command.path)) return refused("this is the file of the track: choose another name");
  const auto alone = sections_alone(session, change, command.sections);
  if (!alone) return alone.status();
  const Status saved = exchange::save_track(change.files, command.path, *alone);
  if (saved) change.note = fmt::format("Saved the sections to {}", command.path);
  return saved;
}

Status perform(Session& session, Change& change, const OpenSections& command) {
  if (const Status may = may_move(session.document, 0); !may) return may;
  const auto loaded = exchange::load_track(change.files, command.path);
  if (!loaded) return loaded.status();
  return add_sections(session, change, loaded->document, "Added");
}

void open_out(world::Document& document, const world::Knot& start) {
  if (document.track.knots.empty()) {
    world::append_knot(document, start);
    return;
  }
  world::Knot& last = document.entities.get<world::Knot>(document.track.knots.back());
  last.joint = world::JointKind::aligned;
  last.out_length = start.out_length;
}

world::Entity append_section(world::Document& document, const std::vector<world::Knot>& knots, world::Section section) {
  open_out(document, knots.front());
  for (std::size_t k = 1; k < knots.size(); ++k) world::append_knot(document, knots[k]);
  const std::size_t spans = knots.size() - 1;
  return world::make_section(document, document.track.segments.size() - spans, spans, std::move(section));
}

world::Entity place(world::Document& document, const sim::ElementPlan& plan) {
  world::Section section{{}, world::SectionKind::element, world::limited(plan.element)};
  if (plan.forces)
    section = {std::string(base::row_of(plan.element.kind).label), world::SectionKind::force, {}, {}, *plan.forces};
  const std::size_t first = document.track.segments.size();
  const world::Entity placed = append_section(document, plan.fit.knots, std::move(section));
  equip(document, plan, first);
  return placed;
}

void equip(world::Document& document, const sim::ElementPlan& plan, std::size_t first) {
  for (const sim::EquippedSpans& part : plan.equipment)
    for (std::size_t i = 0; i < part.spans; ++i)
      document.entities.put(document.track.segments[first++], part.equipment);
}

void add_first_train(world::Document& document) {
  if (document.entities.pool<world::Train>().size() == 0)
    world::add_cart(document, document.track.segments.front(), 0.0);
}

Status perform(Session& session, Change& change, const PlaceElement& command) {
  if (const Status good = well_formed(command.what); !good) return good;
  world::Document& document = session.document;
  const sim::ElementPlan& plan = SessionFindings(session).element(command.what);
  if (!plan.refusal.empty()) return refused(plan.refusal);
  const std::size_t knots = std::max<std::size_t>(document.track.knots.size(), 1) + plan.spans();
  if (const Status room = room_for(session, knots, knots - 1); !room) return room;
  const double missing = sim::worst(SessionFindings(session).room(command.what));
  const world::Entity section = place(document, plan);
  change.select = plan.forces ? section : document.track.knots.back();
  if (document.track.segments.size() == plan.spans()) add_first_train(document);
  if (plan.forces) report_forces(*SessionFindings(session).force(section), change);
  report(plan, missing, document, change);
  return {};
}

Status perform(Session& session, Change& change, const CompleteCircuit& command) {
  if (command.proposal < 1 || command.proposal > static_cast<int>(sim::kMostProposals))
    return refused(fmt::format("expected a proposal from 1 to {}", sim::kMostProposals));
  const sim::CircuitProposals& found = SessionFindings(session).circuit();
  if (!found.refusal.empty()) return refused(found.refusal);
  if (static_cast<std::size_t>(command.proposal) > found.list.size())
    return refused(fmt::format("there {} {} proposal{}", found.list.size() == 1 ? "is" : "are", found.list.size(),
                               found.list.size() == 1 ? "" : "s"));
  const sim::CircuitProposal& proposal = found.list[static_cast<std::size_t>(command.proposal) - 1];
  const std::vector<world::Knot>& knots = proposal.plan.fit.knots;
  if (const Status room = room_for(session, knots.size() - 2, knots.size() - 1); !room) return room;
  const double jolt = SessionFindings(session).closing_jolt(static_cast<std::size_t>(command.proposal) - 1);
  change.select = sim::close_by(session.document, proposal);
  if (jolt > sim::kJoltLimit)
    change.clamped.push_back(fmt::format("A joint of the closing section jolts riders by {} g. Worst jolt finds it.",
                                         base::figure_text(jolt, 1, "g")));
  change.note = fmt::format(
      "Completed the circuit: {:.1f} m, {} {}, at most {:.1f} g.{}", proposal.plan.length, proposal.plan.spans(),
      proposal.plan.spans() == 1 ? "span" : "spans", proposal.felt.most,
      found.assumed ? fmt::format(" No train reaches the open end: planned for {} m/s.", base::to_text(found.speed))
                    : "");
  return {};
}

Status perform(Session& session, Change&, const ChooseElement& command) {
  if (const Status good = well_formed(command.what); !good) return good;
  session.settings.element = command.what;
  session.settings.aids->show_element = true;
  return {};
}

}  // namespace coaster::edit
