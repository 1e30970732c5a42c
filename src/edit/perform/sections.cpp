// Commands that divide the track into sections, name them and equip them.
#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/equipping.h"
#include "edit/perform/knot_runs.h"
#include "world/element_rows.h"
#include "world/section_words.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {

using base::Status;
using world::Entity;
using world::Kind;
using world::SectionRun;

namespace {

// Stores the present equipment in the parameters of a planned section, so that it keeps it when it is planned again.
void name_equipment(world::Section& section, const world::Equipment* equipment) {
  if (section.kind != world::SectionKind::element || !world::found_value(section.element, "equipment")) return;
  world::set_value(section.element, "equipment", equipment ? world::equipment_choice(equipment->kind) : 0);
  if (!equipment) return;
  world::set_value(section.element, "speed", equipment->speed);
  world::set_value(section.element, "acceleration", equipment->acceleration);
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
  change.select = world::make_section(document, first, count, {});
  return {};
}

Status perform(Session& session, Change& change, const SplitSection& command) {
  const auto knot = require(session, command.knot, Kind::knot);
  if (!knot) return knot.status();
  world::Document& document = session.document;
  const std::size_t at = *world::index_of(document.track.knots, *knot);
  const auto section_at = [&](std::size_t i) {
    return i < document.track.segments.size() ? world::segment(document, document.track.segments[i]).section
                                              : world::kNone;
  };
  const Entity section = section_at(at);
  if (at == 0 || !section.valid() || section_at(at - 1) != section)
    return refused(fmt::format("@{} is not inside a section", world::label_of(document, *knot)));
  const SectionRun run = world::run_of(document, section);
  change.select = world::make_section(document, at, run.end() - at, {});
  return {};
}

Status perform(Session& session, Change& change, const JoinSections& command) {
  const auto section = require(session, command.section, Kind::section);
  if (!section) return section.status();
  world::Document& document = session.document;
  const std::vector<SectionRun> runs = world::sections_of(document);
  const SectionRun run = world::run_of(document, *section);
  if (run.end() == document.track.segments.size())
    return refused("there is no section after " + world::words_of(world::section(document, *section)));
  const SectionRun next = world::run_of(document, world::segment(document, document.track.segments[run.end()]).section);
  std::string title = world::section(document, *section).title;
  if (title.empty()) title = world::section(document, next.section).title;
  change.select = world::make_section(document, run.first, run.count + next.count, {std::move(title), {}, {}});
  return {};
}

Status perform(Session& session, Change&, const SetSectionTitle& command) {
  const auto section = require(session, command.section, Kind::section);
  if (!section) return section.status();
  if (command.to.size() > world::kMaxNameBytes)
    return refused(fmt::format("the title is over the limit of {} bytes", world::kMaxNameBytes));
  if (!base::is_printable_utf8(command.to)) return refused("expected a title in UTF-8 without control characters");
  session.document.entities.get<world::Section>(*section).title = command.to;
  return {};
}

Status perform(Session& session, Change& change, const EquipSection& command) {
  const auto section = require(session, command.section, Kind::section);
  if (!section) return section.status();
  base::Result<world::Equipment> equipment = equipment_of(command.to, change);
  if (!equipment) return equipment.status();
  const SectionRun run = world::run_of(session.document, *section);
  auto& kept = session.document.entities.get<world::Section>(*section);
  const std::span<const Entity> segments = session.document.track.segments;
  equip(session.document, change, segments.subspan(run.first, run.count), *equipment, world::words_of(kept));
  name_equipment(kept, &*equipment);
  return {};
}

Status perform(Session& session, Change& change, const UnequipSection& command) {
  const auto section = require(session, command.section, Kind::section);
  if (!section) return section.status();
  const SectionRun run = world::run_of(session.document, *section);
  auto& equipment = session.document.entities.pool<world::Equipment>();
  const std::size_t before = equipment.size();
  for (std::size_t i = run.first; i < run.end(); ++i) equipment.erase(session.document.track.segments[i]);
  if (equipment.size() == before)
    return refused("there is no equipment on " + world::words_of(world::section(session.document, *section)));
  auto& kept = session.document.entities.get<world::Section>(*section);
  name_equipment(kept, nullptr);
  change.note = fmt::format("Removed the equipment of {}.", world::words_of(kept));
  return {};
}

}  // namespace coaster::edit
