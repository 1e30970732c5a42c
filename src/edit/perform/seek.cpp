#include "edit/perform/seek.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "base/interrupted.h"
#include "edit/commands/codec.h"
#include "edit/perform/force_replan.h"
#include "edit/perform/hand_shaped.h"
#include "edit/perform/seek_numbers.h"
#include "sim/shape/roll.h"
#include "world/sections.h"
#include "world/topology.h"

namespace coaster::edit {
namespace {

using base::Status;
using Values = std::vector<double>;

// A copy of a session for trying values.
class Trial {
 public:
  Trial(const Session& session, const Seek& command, std::vector<SeekNumber> numbers)
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
    world::settle_joints(session_.document);
    free_hand_shaped(planned_, session_, change);
    edit::derive(session_);
    if (sim::set_automatic_spins(session_.derived, change.respun, session_.document)) edit::derive(session_);
    if (follow_speeds(session_, change)) edit::derive(session_);
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

base::Result<Sought> run(Trial& trial) {
  const base::Result<GoalState> before = trial.measure();
  if (!before) return before.status();
  const auto is_now = [&](double value) {
    return fmt::format("{} is {}", before->name, with_unit(value, before->unit));
  };
  if (before->met) return Sought{trial.start_values(), is_now(before->found) + " already."};

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
  return Sought{values, fmt::format("{}, was {}. {}", is_now(solution.value), with_unit(before->found, before->unit),
                                    changed_text(trial.by(), trial.numbers(), values))};
}

// Returns the sections whose parameters, or whose way home, the search has changed.
std::vector<world::Entity> planned_again(const world::Document& before, const world::Document& found) {
  std::vector<world::Entity> planned;
  for (const world::SectionRun& run : world::sections_of(found))
    if (const auto* const former = before.entities.find<world::Section>(run.section);
        former && !(*former == world::section(found, run.section)))
      planned.push_back(run.section);
  return planned;
}

base::Result<std::shared_ptr<Trial>> trial_for(const Session& session, const Seek& command) {
  if (!session.game.referee.measure) return refused("this program cannot measure goals");
  base::Result<std::vector<SeekNumber>> numbers = seek_numbers(session, command);
  if (!numbers) return numbers.status();
  return std::make_shared<Trial>(session, command, std::move(*numbers));
}

}  // namespace

Search search_for(const Session& session, const Seek& command) {
  return
      [trial = trial_for(session, command)]() { return trial ? run(**trial) : base::Result<Sought>(trial.status()); };
}

Status perform(Session& session, Change& change, const Seek& command) {
  if (session.history.in_gesture) return refused("a gesture is open");
  const std::optional<SoughtAhead> ahead = std::exchange(session.sought, std::nullopt);
  const bool fits = ahead && ahead->edits == session.edits && ahead->command == print(command);
  const base::Result<std::shared_ptr<Trial>> trial = trial_for(session, command);
  if (!trial) return trial.status();
  base::Result<Sought> found = fits ? base::Result<Sought>(ahead->found) : run(**trial);
  if (!found) return found.status();
  if (const Status set = (*trial)->set(found->values); !set) return set;
  world::Document document = (*trial)->document();
  change.planned = planned_again(session.document, document);
  change.planned.insert(change.planned.end(), (*trial)->replanned().begin(), (*trial)->replanned().end());
  session.document = std::move(document);
  change.note = found->note + ((*trial)->note().empty() ? "" : " ") + (*trial)->note();
  return {};
}

}  // namespace coaster::edit
