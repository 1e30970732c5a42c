#include "edit/perform/seek_numbers.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/knot_runs.h"
#include "world/element.h"
#include "world/sections.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Unknown;
using Numbers = std::vector<SeekNumber>;

constexpr double kCoordinateStep = 0.25;  // m, of coordinates
constexpr double kSeekRollStep = 1;       // degrees
constexpr double kParameterStep = 0.01;   // fraction of the parameter's default value, or of its range if that is 0

struct ByRow {
  std::string_view name;
  std::vector<SeekKind> kinds;
};
// Returns the kinds of a knot's numbers with that name; none for other words.
std::vector<SeekKind> kinds_of(std::string_view by) {
  static const std::vector<ByRow> kRows{{"height", {SeekKind::height}},
                                        {"x", {SeekKind::x}},
                                        {"z", {SeekKind::z}},
                                        {"place", {SeekKind::x, SeekKind::height, SeekKind::z}},
                                        {"roll", {SeekKind::roll}}};
  const auto row = std::find_if(kRows.begin(), kRows.end(), [&](const ByRow& r) { return r.name == by; });
  return row == kRows.end() ? std::vector<SeekKind>() : row->kinds;
}

int axis_of(SeekKind kind) { return static_cast<int>(kind); }

bool names_sections(const Session& session, const Seek& command) {
  const Knots& of = command.of;
  if (of.which == Knots::Which::selected) return !world::selected_sections(session.document, session.settings).empty();
  if (of.which == Knots::Which::all) return kinds_of(command.by.text).empty();
  return !of.names.empty() && of.names.front().kind == world::Kind::section;
}

// Limits the unknown to the command's limits; false if it starts beyond them.
bool limit(const Seek& command, Unknown& unknown) {
  unknown.low = std::max(unknown.low, command.above), unknown.high = std::min(unknown.high, command.below);
  return unknown.low <= unknown.start && unknown.start <= unknown.high;
}

base::Status beyond_limits(const Session& session, world::Entity e, const Seek& command, double value) {
  return refused(fmt::format("the {} of @{} is {:.6g}, which is beyond the limits {:.6g} to {:.6g}", command.by.text,
                             world::label_of(session.document, e), value, command.above, command.below));
}

Unknown of_knot(const world::Knot& knot, SeekKind kind) {
  if (kind == SeekKind::roll) return {world::roll_deg(knot), kSeekRollStep, -360, 360};
  const double most = world::kMaxCoordinate, start = knot.position[axis_of(kind)];
  // Knots at or above the ground stay there.
  return {start, kCoordinateStep, kind == SeekKind::height && start >= 0 ? 0 : -most, most};
}

base::Result<Numbers> of_knots(const Session& session, const Seek& command) {
  const std::vector<SeekKind> kinds = kinds_of(command.by.text);
  if (kinds.empty())
    return refused(
        fmt::format("expected height, x, z, place or roll of knots, found {}", base::quoted(command.by.text)));
  const auto knots = knots_of(session, command.of);
  if (!knots) return knots.status();
  std::vector<world::Entity> stay;
  if (command.except.which != Knots::Which::named || !command.except.names.empty()) {
    const auto found = knots_of(session, command.except);
    if (!found) return found.status();
    stay = *found;
  }
  Numbers numbers;
  for (const world::Entity e : *knots) {
    if (std::find(stay.begin(), stay.end(), e) != stay.end()) continue;
    for (const SeekKind kind : kinds) {
      SeekNumber number{
          kind, e, {}, kind == SeekKind::roll ? "deg" : "m", of_knot(world::knot(session.document, e), kind)};
      if (!limit(command, number.unknown)) return beyond_limits(session, e, command, number.unknown.start);
      numbers.push_back(std::move(number));
    }
  }
  return numbers;
}

base::Result<Numbers> of_sections(const Session& session, const Seek& command) {
  Sections named;
  named.which = command.of.which, named.names = command.of.names;
  const auto sections = chosen_sections(session, named);
  if (!sections) return sections.status();
  Numbers numbers;
  for (const world::Entity e : *sections) {
    const world::Section& section = world::section(session.document, e);
    const auto rows = base::row_of(section.element.kind).parameters;
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const auto& r) { return r.name == command.by.text; });
    const bool planned = section.kind == world::SectionKind::element;
    if (!planned || row == rows.end() || !row->names.empty()) {
      if (command.of.which == Knots::Which::all) continue;
      const std::string label = world::label_of(session.document, e);
      if (!planned) return refused(fmt::format("@{} has no parameters: name its knots", label));
      return refused(fmt::format("{} @{} has no number {}", base::row_of(section.element.kind).label, label,
                                 base::quoted(command.by.text)));
    }
    const double usual = row->usual != 0 ? std::abs(row->usual) : row->high - row->low;
    SeekNumber number{SeekKind::parameter,
                      e,
                      std::string(row->name),
                      row->unit,
                      {*world::found_value(section.element, row->name), kParameterStep * usual, row->low, row->high}};
    if (!limit(command, number.unknown)) return beyond_limits(session, e, command, number.unknown.start);
    numbers.push_back(std::move(number));
  }
  return numbers;
}

}  // namespace

base::Result<Numbers> seek_numbers(const Session& session, const Seek& command) {
  if (!std::isfinite(command.above) || !std::isfinite(command.below) || command.above > command.below)
    return refused("expected limits with above <= below");
  base::Result<Numbers> numbers =
      names_sections(session, command) ? of_sections(session, command) : of_knots(session, command);
  if (!numbers) return numbers;
  if (numbers->empty()) return refused("there is nothing to change");
  if (numbers->size() > kMaxSeekNumbers)
    return refused(fmt::format("these are {} numbers, over the limit of {}", numbers->size(), kMaxSeekNumbers));
  return numbers;
}

base::Status give(Session& session, Change& change, const SeekNumber& number, double value) {
  const world::Name name = world::name_of(session.document, number.entity);
  if (number.kind == SeekKind::roll) return perform(session, change, SetRoll{name, value});
  if (number.kind == SeekKind::parameter) {
    world::Element element = world::section(session.document, number.entity).element;
    world::set_value(element, number.parameter, value);
    ChangeSection command;
    command.section = {name}, command.to = element;
    return perform(session, change, command);
  }
  glm::vec3 position = world::knot(session.document, number.entity).position;
  position[axis_of(number.kind)] = static_cast<float>(value);
  return perform(session, change, MoveKnot{{name}, position});
}

std::string changed_text(std::string by, const Numbers& numbers, const std::vector<double>& values) {
  by = base::sentence(std::move(by)), by.pop_back();
  by = base::sentence(std::move(by)), by.pop_back();
  const std::string_view unit = numbers.front().unit;
  const std::string after = unit.empty() ? "" : fmt::format(" {}", unit);
  if (numbers.size() == 1)
    return fmt::format("{}: from {:.6g} to {:.6g}{}.", by, numbers.front().unknown.start, values.front(), after);
  std::size_t count = 0;
  double most = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double change = std::abs(values[i] - numbers[i].unknown.start);
    if (change > 0) ++count;
    most = std::max(most, change);
  }
  return fmt::format("{}: {} of {} changed, by up to {:.3g}{}.", by, count, numbers.size(), most, after);
}

}  // namespace coaster::edit
