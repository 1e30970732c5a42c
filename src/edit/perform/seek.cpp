#include "edit/perform/seek.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "base/cancellable_job.h"
#include "base/text.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_sections.h"
#include "edit/perform/change_propagation.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/replan.h"
#include "world/element.h"
#include "world/element_rows.h"
#include "world/force_program.h"
#include "world/sections.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using Values = std::vector<double>;

// A copy of a session for trying values.
class SeekTrial {
 public:
  SeekTrial(const Session& session, const SeekGoal& command, std::vector<SeekNumber> numbers)
      : start_(session.document),
        planned_(planned_sections(session.document)),
        goal_(command.goal.text),
        together_(command.together),
        numbers_(std::move(numbers)),
        by_(words_of(command, numbers_)) {
    session_.document = session.document, session_.settings = session.settings, session_.limits = session.limits;
    session_.derived = session.derived, session_.game.referee = session.game.referee;
    force_plans_of(session_) = force_plans_of(session);
    // As inside a drag: a section that completes the circuit keeps its way instead of searching all.
    session_.history.in_gesture = true, session_.history.gesture_start = session.document;
  }

  const std::vector<SeekNumber>& numbers() const { return numbers_; }
  const std::string& by() const { return by_; }  // what the numbers are
  base::Result<GoalState> measure() { return session_.game.referee.measure(session_, goal_); }
  world::Document document() const { return session_.document; }
  Values start_values() const {
    Values values;
    for (const SeekNumber& number : numbers_) values.push_back(number.unknown.start);
    return values;
  }

  // One unknown for each number, or one for the amount by which all change.
  std::vector<base::Unknown> unknowns() const {
    std::vector<base::Unknown> all;
    for (const SeekNumber& number : numbers_) all.push_back(number.unknown);
    if (!together_) return all;
    base::Unknown amount{0, all.front().step, -HUGE_VAL, HUGE_VAL};
    for (const base::Unknown& one : all)
      amount.low = std::max(amount.low, one.low - one.start), amount.high = std::min(amount.high, one.high - one.start);
    return {amount};
  }
  Values values_of(const Values& unknowns) const {
    if (!together_) return unknowns;
    Values values;
    for (const SeekNumber& number : numbers_) values.push_back(number.unknown.start + unknowns.front());
    return values;
  }

  // Sets the numbers, and updates what depends on them as after a command. On failure some have other values.
  Status set(const Values& values) {
    session_.document = start_;
    edit::derive(session_);
    Change change{files_};
    if (const Status given = give(session_, change, numbers_, values); !given) return given;
    follow_change(session_, change, planned_);
    session_.motion = {};  // goals are measured on whole rides
    ++session_.edits;
    replanned_ = std::move(change.planned), note_ = std::move(change.note);
    return {};
  }
  const std::vector<world::Entity>& replanned() const { return replanned_; }  // other sections that set() planned again
  const std::string& note() const { return note_; }                           // of set()

 private:
  const world::Document start_;
  std::vector<PlannedSection> planned_;
  std::string goal_;
  bool together_;
  std::vector<SeekNumber> numbers_;
  std::string by_;
  std::vector<world::Entity> replanned_;
  std::string note_;
  Session session_ = make_session({});
  base::Files files_;
};

std::string with_unit(double value, const std::string& unit) {
  return fmt::format("{:.4g}{}{}", value, unit.empty() ? "" : " ", unit);
}

// Returns why a search has failed.
std::string failure(const std::string& by, const base::Solution& solution, const GoalState& goal) {
  switch (solution.end) {
    case base::SolutionEnd::no_effect: return fmt::format("{} does not depend on the {}", goal.name, by);
    case base::SolutionEnd::cancelled: return "cancelled";
    default:
      return fmt::format("{} comes no closer to {} than {} by changing the {}", goal.name,
                         with_unit(goal.wanted, goal.unit), with_unit(solution.value, goal.unit), by);
  }
}

base::Result<SeekResult> run(SeekTrial& trial) {
  const base::Result<GoalState> before = trial.measure();
  if (!before) return before.status();
  const auto is_now = [&](double value) {
    return fmt::format("{} is {}", before->name, with_unit(value, before->unit));
  };
  if (before->met) return SeekResult{trial.start_values(), is_now(before->found) + " already."};

  base::Equation equation{.unknowns = trial.unknowns(),
                          .wanted = before->wanted,
                          .tolerance = before->tolerance,
                          .trials = 400 + 10 * static_cast<int>(trial.unknowns().size())};
  equation.value = [&](const Values& unknowns) -> std::optional<double> {
    if (!trial.set(trial.values_of(unknowns))) return std::nullopt;
    const base::Result<GoalState> state = trial.measure();
    return state ? std::optional(state->found) : std::nullopt;
  };
  equation.goes_on = [&](double done) {
    base::report_progress(done);
    return !base::interrupted();
  };
  const base::Solution solution = base::solve_by_least_change(equation);
  if (solution.end != base::SolutionEnd::met) return refused(failure(trial.by(), solution, *before));
  const Values values = trial.values_of(solution.unknowns);
  return SeekResult{values,
                    fmt::format("{}, was {}. {}", is_now(solution.value), with_unit(before->found, before->unit),
                                changed_text(trial.by(), trial.numbers(), values))};
}

// Returns the sections whose parameters, or whose closing section, the search has changed.
std::vector<world::Entity> planned_again(const world::Document& before, const world::Document& found) {
  std::vector<world::Entity> planned;
  for (const world::SectionRun& run : world::sections_of(found))
    if (const auto* const former = before.entities.find<world::Section>(run.section);
        former && !(*former == world::section(found, run.section)))
      planned.push_back(run.section);
  return planned;
}

base::Result<std::shared_ptr<SeekTrial>> trial_for(const Session& session, const SeekGoal& command) {
  if (!session.game.referee.measure) return refused("this program cannot measure goals");
  base::Result<std::vector<SeekNumber>> numbers = seek_numbers(session, command);
  if (!numbers) return numbers.status();
  return std::make_shared<SeekTrial>(session, command, std::move(*numbers));
}

using base::Unknown;
using world::Entity;
using Numbers = std::vector<SeekNumber>;

constexpr double kCoordinateStep = 0.25;  // m, of coordinates
constexpr double kSeekRollStep = 1;       // degrees
constexpr double kParameterStep = 0.01;   // fraction of the parameter's default value, or of its range if that is 0

struct SeekWordRow {
  std::string_view name;
  std::vector<SeekKind> kinds;
};
const std::vector<SeekWordRow>& knot_rows() {
  static const std::vector<SeekWordRow> kRows{{"height", {SeekKind::height}},
                                              {"x", {SeekKind::x}},
                                              {"z", {SeekKind::z}},
                                              {"place", {SeekKind::x, SeekKind::height, SeekKind::z}},
                                              {"roll", {SeekKind::roll}}};
  return kRows;
}
// Returns the kinds of a knot's numbers with that name; none for other words.
std::vector<SeekKind> kinds_of(std::string_view by) {
  const auto row = std::ranges::find(knot_rows(), by, &SeekWordRow::name);
  return row == knot_rows().end() ? std::vector<SeekKind>() : row->kinds;
}

int axis_of(SeekKind kind) { return static_cast<int>(kind); }

bool names_sections(const Session& session, const SeekGoal& command) {
  const Knots& of = command.of;
  if (of.which == Knots::Which::selected) return !world::selected_sections(session.document, session.settings).empty();
  if (of.which == Knots::Which::all) return kinds_of(command.by.text).empty();
  return !of.names.empty() && of.names.front().kind == world::EntityKind::section;
}

// Limits the unknown to the command's limits; false if it starts beyond them.
bool limit(const SeekGoal& command, Unknown& unknown) {
  unknown.low = std::max(unknown.low, command.above), unknown.high = std::min(unknown.high, command.below);
  return unknown.low <= unknown.start && unknown.start <= unknown.high;
}

base::Status beyond_limits(const Session& session, world::Entity e, const SeekGoal& command, double value) {
  return refused(fmt::format("the {} of @{} is {:.6g}, which is beyond the limits {:.6g} to {:.6g}", command.by.text,
                             world::label_of(session.document, e), value, command.above, command.below));
}

Unknown of_knot(const world::Knot& knot, SeekKind kind, bool plain) {
  if (kind == SeekKind::roll) return {world::roll_deg(knot), kSeekRollStep, -360, 360};
  const double most = world::kMaxCoordinate, start = knot.position[axis_of(kind)];
  // Knots at or above the ground stay there; a land is dug.
  return {start, kCoordinateStep, plain && kind == SeekKind::height && start >= 0 ? 0 : -most, most};
}

base::Result<Numbers> of_knots(const Session& session, const SeekGoal& command) {
  const std::vector<SeekKind> kinds = kinds_of(command.by.text);
  if (kinds.empty())
    return refused(
        fmt::format("expected height, x, z, place or roll of knots, found {}", base::quoted_start(command.by.text)));
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
      SeekNumber number{kind,
                        e,
                        {},
                        kind == SeekKind::roll ? "deg" : "m",
                        of_knot(world::knot(session.document, e), kind, session.document.park.plain())};
      if (!limit(command, number.unknown)) return beyond_limits(session, e, command, number.unknown.start);
      numbers.push_back(std::move(number));
    }
  }
  return numbers;
}

// The numbers of a force section that a word names: "length", "vertical", or "vertical at 40" for a single key.
struct ForceSeekTarget {
  std::optional<world::ForceChannel> channel;  // nothing: the length
  std::optional<double> at;                    // m or s
};
std::optional<ForceSeekTarget> force_by(std::string_view by) {
  if (by == "length") return ForceSeekTarget{};
  constexpr std::string_view kAt = " at ";
  const std::size_t end = by.find(kAt);
  const auto channel = base::value_named<world::ForceChannel>(by.substr(0, end));
  if (!channel) return std::nullopt;
  if (end == std::string_view::npos) return ForceSeekTarget{channel, {}};
  const auto at = base::parse_double(by.substr(end + kAt.size()));
  return at ? std::optional(ForceSeekTarget{channel, at}) : std::nullopt;
}

// Returns the length or the keys of a force section that the command names; empty if it has none of them.
Numbers of_forces(const world::ForceProgram& program, Entity section, std::string_view by) {
  const std::optional<ForceSeekTarget> named = force_by(by);
  if (!named) return {};
  if (!named->channel) {
    const Unknown length{program.length, kParameterStep * program.length, world::shortest_of(program.over),
                         world::longest_of(program.over)};
    return {{SeekKind::force_length, section, {}, world::unit_of(program.over), length}};
  }
  Numbers numbers;
  const world::ForceChannel channel = *named->channel;
  const double step = world::steps_of(program, channel).value, limit = world::channel_of(program.of, channel).limit;
  const std::vector<world::ForceKey>& keys = program.keys(channel);
  for (std::size_t i = 0; i < keys.size(); ++i)
    if (constexpr double kSame = 1e-6; !named->at || std::abs(keys[i].at - *named->at) <= kSame * (1 + keys[i].at))
      numbers.push_back({SeekKind::force_key,
                         section,
                         {},
                         world::unit_of(program, channel),
                         {keys[i].value, step, -limit, limit},
                         channel,
                         i});
  return numbers;
}

// Returns the parameter of a planned section that the command names; empty if it has none.
Numbers of_element(const world::Element& element, Entity section, std::string_view by) {
  const auto rows = base::row_of(element.kind).parameters;
  const auto row = std::ranges::find(rows, by, &world::ElementParameter::name);
  if (row == rows.end() || !row->names.empty()) return {};
  const double usual = row->usual != 0 ? std::abs(row->usual) : row->high - row->low;
  return {{SeekKind::parameter,
           section,
           std::string(row->name),
           row->unit,
           {*world::found_value(element, row->name), kParameterStep * usual, row->low, row->high}}};
}

base::Result<Numbers> of_sections(const Session& session, const SeekGoal& command) {
  Sections named;
  named.which = command.of.which, named.names = command.of.names;
  const auto sections = chosen_sections(session, named);
  if (!sections) return sections.status();
  Numbers numbers;
  for (const Entity e : *sections) {
    const world::Section& section = world::section(session.document, e);
    const std::string_view by = command.by.text;
    const Numbers own = section.kind == world::SectionKind::force     ? of_forces(section.force, e, by)
                        : section.kind == world::SectionKind::element ? of_element(section.element, e, by)
                                                                      : Numbers{};
    if (own.empty() && command.of.which != Knots::Which::all) {
      const std::string label = world::label_of(session.document, e);
      if (section.kind != world::SectionKind::element && section.kind != world::SectionKind::force)
        return refused(fmt::format("@{} has no parameters: name its knots", label));
      return refused(fmt::format("{} @{} has no number {}", world::words_of(section), label, base::quoted_start(by)));
    }
    for (SeekNumber number : own) {
      if (!limit(command, number.unknown)) return beyond_limits(session, e, command, number.unknown.start);
      numbers.push_back(std::move(number));
    }
  }
  return numbers;
}

Status give_one(Session& session, Change& change, const SeekNumber& number, double value) {
  const world::EntityName name = world::name_of(session.document, number.entity);
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

bool of_program(SeekKind kind) { return kind == SeekKind::force_length || kind == SeekKind::force_key; }

// Returns the names of all numbers of sections.
std::vector<std::string> section_numbers() {
  std::vector<std::string> names = base::names_of<world::ForceChannel>();
  names.insert(names.begin(), "length");
  for (const world::ElementRow& row : world::elements())
    for (const world::ElementParameter& p : row.parameters)
      if (p.names.empty() && std::find(names.begin(), names.end(), p.name) == names.end()) names.emplace_back(p.name);
  return names;
}

}  // namespace

std::function<base::Result<SeekResult>()> search_for(const Session& session, const SeekGoal& command) {
  return [trial = trial_for(session, command)]() {
    return trial ? run(**trial) : base::Result<SeekResult>(trial.status());
  };
}

Status perform(Session& session, Change& change, const SeekGoal& command) {
  if (session.history.in_gesture) return refused("a gesture is open");
  const auto* const sought =
      change.search && change.search->found ? std::get_if<SeekResult>(&*change.search->found) : nullptr;
  const base::Result<std::shared_ptr<SeekTrial>> trial = trial_for(session, command);
  if (!trial) return trial.status();
  base::Result<SeekResult> found = sought ? base::Result<SeekResult>(*sought) : run(**trial);
  if (!found) return found.status();
  if (const Status set = (*trial)->set(found->values); !set) return set;
  world::Document document = (*trial)->document();
  change.planned = planned_again(session.document, document);
  change.planned.insert(change.planned.end(), (*trial)->replanned().begin(), (*trial)->replanned().end());
  session.document = std::move(document);
  change.note = found->note + ((*trial)->note().empty() ? "" : " ") + (*trial)->note();
  return {};
}

std::optional<std::string> wrong_by(const SeekGoal& command) {
  const std::vector<world::EntityName>& of = command.of.names;
  const bool knots = of.empty() || of.front().kind != world::EntityKind::section, sections = of.empty() || !knots;
  std::vector<std::string> names = knots ? base::names_in(knot_rows()) : std::vector<std::string>();
  if (sections) {
    if (force_by(command.by.text)) return std::nullopt;
    for (std::string& name : section_numbers())
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  const std::string& by = command.by.text;
  if (std::find(names.begin(), names.end(), by) != names.end()) return std::nullopt;
  return fmt::format("expected {} of {}, found {}{}", base::alternatives(names),
                     !sections ? "knots"
                     : knots   ? "knots or sections"
                               : "sections",
                     base::quoted_start(by), base::suggestion(by, names));
}

base::Result<Numbers> seek_numbers(const Session& session, const SeekGoal& command) {
  if (command.above > command.below) return refused("expected limits with above <= below");
  base::Result<Numbers> numbers =
      names_sections(session, command) ? of_sections(session, command) : of_knots(session, command);
  if (!numbers) return numbers;
  if (numbers->empty()) return refused("there is nothing to change");
  if (numbers->size() > kMaxSeekNumbers)
    return refused(fmt::format("these are {} numbers, over the limit of {}", numbers->size(), kMaxSeekNumbers));
  return numbers;
}

Status give(Session& session, Change& change, const Numbers& numbers, const std::vector<double>& values) {
  for (std::size_t i = 0; i < numbers.size();) {
    const SeekNumber& number = numbers[i];
    if (!of_program(number.kind)) {
      if (values[i] != number.unknown.start)
        if (const Status given = give_one(session, change, number, values[i]); !given) return given;
      ++i;
      continue;
    }
    // All of a force section at once: it is planned a single time.
    world::ForceProgram program = world::section(session.document, number.entity).force;
    for (const Entity section = number.entity; i < numbers.size() && numbers[i].entity == section; ++i) {
      if (numbers[i].kind == SeekKind::force_length) program.length = values[i];
      else program.keys(numbers[i].channel)[numbers[i].key].value = values[i];
    }
    if (const Status given = change_forces(session, change, number.entity, program); !given) return given;
  }
  return {};
}

std::string words_of(const SeekGoal& command, const Numbers& numbers) {
  if (numbers.empty() || numbers.front().kind != SeekKind::force_key) return command.by.text;
  const std::string channel(base::name_of(numbers.front().channel));
  const std::size_t at = command.by.text.find(" at ");
  return channel + (at == std::string::npos ? " keys" : " key" + command.by.text.substr(at));
}

std::string changed_text(std::string by, const Numbers& numbers, const std::vector<double>& values) {
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
