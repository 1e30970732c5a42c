// Commands of force sections.
#include <algorithm>
#include <cmath>
#include <type_traits>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/replan.h"
#include "exchange/own/track_file.h"
#include "sim/plan/force_keys_from_track.h"
#include "sim/plan/force_plan.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using world::Document;
using world::Entity;
using world::ForceKey;
using world::ForceProgram;

base::Result<Entity> force_section(const Session& session, Target target) {
  const auto section = require(session, target, world::EntityKind::section);
  if (!section) return section.status();
  if (world::section(session.document, *section).kind == world::SectionKind::force) return *section;
  return refused(world::words_of(world::section(session.document, *section)) + " is not a force section");
}

// Changes a section's program by `edit`, which may return an error, and plans it again. `from_start`: from the one that
// the section had when the open gesture began.
template <class Edit>
Status with_program(Session& session, Change& change, Target target, bool from_start, Edit edit) {
  const auto section = force_section(session, target);
  if (!section) return section.status();
  const Document& former = former_document(session, from_start, *section);
  Document next = former;
  ForceProgram& program = next.entities.get<world::Section>(*section).force;
  if constexpr (std::is_void_v<decltype(edit(program))>) edit(program);
  else if (const Status edited = edit(program); !edited) return edited;
  if (const auto wrong = world::broken(program)) return refused(*wrong);
  if (next == former) return &former == &session.document ? Status{} : adopt(session, change, former, std::move(next));
  if (const Status planned = replan_force(session, change, next, *section); !planned) return planned;
  return adopt(session, change, former, std::move(next));
}

// The same for a command, with its member from_start if it has one.
template <class Command, class Edit>
Status with_program_of(Session& session, Change& change, const Command& command, Edit edit) {
  bool from_start = false;
  if constexpr (requires { command.from_start; }) from_start = command.from_start;
  return with_program(session, change, command.section, from_start, edit);
}

constexpr double kSamePlace = 1e-6;  // m or s

// Returns the key at a position; null if there is none.
ForceKey* key_at(ForceProgram& program, world::ForceChannel channel, double at) {
  std::vector<ForceKey>& keys = program.keys(channel);
  const auto found = std::ranges::find_if(
      keys, [&](const ForceKey& key) { return std::abs(key.at - at) <= kSamePlace * (1 + std::abs(at)); });
  return found == keys.end() ? nullptr : &*found;
}

void put_key(ForceProgram& program, world::ForceChannel channel, const ForceKey& key) {
  std::vector<ForceKey>& keys = program.keys(channel);
  keys.insert(std::ranges::upper_bound(keys, key.at, {}, &ForceKey::at), key);
}

// Takes the key of a command out of its channel and calls edit(program, key), which may put it back; refused without
// one.
template <class Command, class Edit>
Status with_key(Session& session, Change& change, const Command& command, Edit edit) {
  return with_program_of(session, change, command, [&](ForceProgram& program) -> Status {
    ForceKey* const found = key_at(program, command.channel, command.at);
    if (found == nullptr)
      return refused(fmt::format("{} has no key at {:.6g} {}", base::name_of(command.channel), command.at,
                                 world::unit_of(program.over)));
    ForceKey key = *found;
    std::vector<ForceKey>& keys = program.keys(command.channel);
    keys.erase(keys.begin() + (found - keys.data()));
    edit(program, key);
    return {};
  });
}

// Returns the plan of a section's program; refused if there is none.
base::Result<sim::ForcePlan> present_plan(Session& session, Target section, const ForceProgram& program) {
  const world::SectionRun run = world::run_of(session.document, world::find(session.document, section.name));
  const sim::ForcePlan& plan = force_plans_of(session).plan(sim::force_task(session.document, run, program));
  return plan.refusal.empty() ? base::Result<sim::ForcePlan>(plan) : refused(plan.refusal);
}

// Returns the run of neighbouring sections, under the name of the first; refused where others lie between them.
base::Result<world::SectionRun> run_of_all(const Document& document, const std::vector<Entity>& in_track_order) {
  world::SectionRun run = world::run_of(document, in_track_order.front());
  for (std::size_t i = 1; i < in_track_order.size(); ++i) {
    const world::SectionRun next = world::run_of(document, in_track_order[i]);
    if (next.first != run.end())
      return refused(fmt::format("{} does not follow {}: expected neighbouring sections",
                                 world::words_of(world::section(document, next.section)),
                                 world::words_of(world::section(document, in_track_order[i - 1]))));
    run.count += next.count;
  }
  return run;
}

// Refused where equipment differs along a run: it would not stay in its place.
Status same_equipment(const Document& document, const world::SectionRun& run) {
  const auto of = [&](std::size_t i) {
    const auto* const found = document.entities.find<world::Equipment>(document.track.segments[i]);
    return found != nullptr ? std::optional(*found) : std::nullopt;
  };
  for (std::size_t i = run.first + 1; i < run.end(); ++i)
    if (of(i) != of(run.first))
      return refused("part of it has equipment that the rest lacks: remove it, or read the parts one by one");
  return {};
}

}  // namespace

Status change_forces(Session& session, Change& change, Entity section, const ForceProgram& to) {
  const Target target{world::name_of(session.document, section)};
  return with_program(session, change, target, false, [&](ForceProgram& program) { program = to; });
}

void report_forces(const sim::ForcePlan& plan, Change& change) {
  change.warn_of(sim::stop_text(plan));
  change.warn_of(sim::missed_text(plan));
  if (change.clamped.empty())
    change.note =
        fmt::format("Placed a force section: {:.1f} m, {} {}, felt g{} within {:.2f} g.", plan.length, plan.spans(),
                    plan.spans() == 1 ? "span" : "spans", sim::judged_text(plan.task.program), plan.fit.felt_error);
}

Status add_force(Session& session, Change& change, ForceProgram program) {
  Document& document = session.document;
  const std::optional<sim::TrackEnd> end = sim::open_end(document);
  if (!end) return refused(std::string(world::kClosedTrack));
  const std::optional<double> speed = SessionFindings(session).speed_at(session.derived.length);
  program.speed = speed.value_or(sim::kAssumedSpeed);
  const sim::ForcePlan& plan = force_plans_of(session).plan(sim::force_task(document, *end, program));
  if (!plan.refusal.empty()) return refused(plan.refusal);
  const std::size_t knots = std::max<std::size_t>(document.track.knots.size(), 1) + plan.spans();
  if (const Status room = room_for(session, knots, knots - 1); !room) return room;
  const bool first = document.track.segments.empty();
  change.select = place_force(document, plan);
  if (first) add_first_train(document);
  if (!speed) change.clamped.push_back(sim::assumed_text());
  report_forces(plan, change);
  return {};
}

Entity place_force(Document& document, const sim::ForcePlan& plan) {
  return append_section(document, plan.fit.spans.knots, {{}, world::SectionKind::force, {}, {}, plan.task.program});
}

Status perform(Session& session, Change& change, const AddForceSection& command) {
  ForceProgram program;
  program.over = command.over, program.of = command.of;
  program.length = command.length, program.tolerance = command.tolerance;
  return add_force(session, change, std::move(program));
}

Status perform(Session& session, Change& change, const SetForceKey& command) {
  return with_program_of(session, change, command, [&](ForceProgram& program) {
    if (ForceKey* const key = key_at(program, command.channel, command.at)) key->value = command.value;
    else put_key(program, command.channel, {command.at, command.value});
  });
}

Status perform(Session& session, Change& change, const InsertForceKey& command) {
  return with_program_of(session, change, command,
                         [&](ForceProgram& program) { sim::insert_on_curve(program, command.channel, command.at); });
}

Status perform(Session& session, Change& change, const MoveForceKey& command) {
  return with_key(session, change, command, [&](ForceProgram& program, ForceKey key) {
    key.at = command.to, key.value = command.value;
    put_key(program, command.channel, key);
  });
}

Status perform(Session& session, Change& change, const RemoveForceKey& command) {
  return with_key(session, change, command, [](const ForceProgram&, const ForceKey&) {});
}

Status perform(Session& session, Change& change, const ShapeForceKey& command) {
  return with_key(session, change, command, [&](ForceProgram& program, ForceKey key) {
    key.slope = command.slope, key.before = command.before, key.after = command.after;
    put_key(program, command.channel, key);
  });
}

Status perform(Session& session, Change& change, const CopyForceKeys& command) {
  const auto section = force_section(session, command.section);
  if (!section) return section.status();
  const ForceProgram& program = world::section(session.document, *section).force;
  exchange::CopiedForceKeys copied{program.over, {}, program.of};
  for (const ForceKey& key : program.keys(command.channel))
    if (key.at >= command.from - kSamePlace && key.at <= command.to + kSamePlace) copied.keys.push_back(key);
  if (copied.keys.empty()) return refused(fmt::format("{} has no keys there", base::name_of(command.channel)));
  session.copied = exchange::print_keys(copied);
  change.note = fmt::format("Copied {} {}.", copied.keys.size(), copied.keys.size() == 1 ? "key" : "keys");
  return {};
}

Status perform(Session& session, Change& change, const PasteForceKeys& command) {
  auto copied = exchange::parse_keys(command.text.empty() ? session.copied : command.text);
  if (!copied)
    return refused((command.text + session.copied).empty() ? "nothing was copied: copy keys first"
                                                           : copied.status().message);
  return with_program_of(session, change, command, [&](ForceProgram& program) -> Status {
    if (program.over != copied->over)
      return refused(fmt::format("the copied keys count in {}, those of the section in {}",
                                 world::unit_of(copied->over), world::unit_of(program.over)));
    if (program.of != copied->of)
      return refused(fmt::format("the copied keys are of {}, those of the section of {}", base::name_of(copied->of),
                                 base::name_of(program.of)));
    const double by = command.at - copied->keys.front().at, gap = world::key_gap_of(program.over) - kSamePlace;
    for (ForceKey& key : copied->keys) key.at += by;
    std::vector<ForceKey>& keys = program.keys(command.channel);
    std::erase_if(keys, [&](const ForceKey& key) {
      return key.at > copied->keys.front().at - gap && key.at < copied->keys.back().at + gap;
    });
    for (const ForceKey& key : copied->keys) put_key(program, command.channel, key);
    return {};
  });
}

Status perform(Session& session, Change& change, const SetForceLength& command) {
  return with_program_of(session, change, command, [&](ForceProgram& program) { program.length = command.to; });
}

Status perform(Session& session, Change& change, const SetForceTolerance& command) {
  return with_program_of(session, change, command, [&](ForceProgram& program) { program.tolerance = command.to; });
}

Status perform(Session& session, Change& change, const SetForceDomain& command) {
  return with_program_of(session, change, command, [&](ForceProgram& program) -> Status {
    if (program.over == command.to) return {};
    const base::Result<sim::ForcePlan> plan = present_plan(session, command.section, program);
    if (!plan) return plan.status();
    program = sim::over_other_axis(*plan);
    return {};
  });
}

Status perform(Session& session, Change& change, const SetForceQuantity& command) {
  return with_program_of(session, change, command, [&](ForceProgram& program) -> Status {
    if (program.of == command.to) return {};
    const base::Result<sim::ForcePlan> plan = present_plan(session, command.section, program);
    if (!plan) return plan.status();
    if (const std::string stopped = sim::stop_text(*plan); !stopped.empty()) return refused(stopped);
    program = sim::of_other_quantity(*plan);
    return {};
  });
}

Status perform(Session& session, Change& change, const HoldForceSectionEnds& command) {
  return with_program_of(session, change, command, [&](ForceProgram& program) { program.hold = command.on; });
}

Status perform(Session& session, Change&, const FreeForceSection& command) {
  const auto section = force_section(session, command.section);
  if (!section) return section.status();
  world::Section& value = session.document.entities.get<world::Section>(*section);
  value = world::without_plan(value);
  return {};
}

Status perform(Session& session, Change& change, const MakeForceSection& command) {
  const auto sections = chosen_sections(session, command.sections);
  if (!sections) return sections.status();
  const Document& document = session.document;
  const std::string label = world::label_of(document, sections->front());
  if (sections->size() == 1 && world::section(document, sections->front()).kind == world::SectionKind::force)
    return refused(fmt::format("@{} is a force section", label));
  const auto all = run_of_all(document, *sections);
  if (!all) return all.status();
  const world::SectionRun& run = *all;
  if (const Status same = same_equipment(document, run); !same) return same;
  const std::optional<double> speed = SessionFindings(session).speed_at(session.derived.starts[run.first]);
  world::ForceProgram program;
  program.tolerance = command.tolerance, program.speed = speed.value_or(sim::kAssumedSpeed);
  const sim::RunForcePlan reading =
      sim::read_forces({session.derived, run.first, run.count}, sim::force_task(document, run, program));
  if (!reading.refusal.empty()) return refused(fmt::format("@{}: {}", label, reading.refusal));
  const sim::ForcePlan& plan = force_plans_of(session).plan(reading.plan.task);
  if (const Status room = room_for_spans(session, document, run, plan.spans()); !room) return room;
  Document next = document;
  world::Section made = world::without_plan(world::section(document, run.section));
  made.kind = world::SectionKind::force, made.force = plan.task.program;
  const Entity section = world::make_section(next, run.first, run.count, std::move(made));
  reshape(next, section, plan.fit.spans, is_followed(document, run) ? SectionEnd::stays : SectionEnd::open);
  change.select = section;
  if (!speed) change.clamped.push_back(sim::assumed_text());
  std::size_t keys = 0;
  for (const auto& channel : plan.task.program.channels) keys += channel.size();
  change.note =
      fmt::format("{} keys keep the shape within {:.1f} mm, in {} spans.", keys, 1000 * reading.error, plan.spans());
  return adopt(session, change, session.document, std::move(next));
}

}  // namespace coaster::edit
