// Goal: changes numbers of the selection until the ride reaches a goal.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_seek.h"
#include "query/goal.h"
#include "query/query.h"
#include "ui/context/rows.h"
#include "ui/widgets/theme.h"
#include "world/element_rows.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

struct RelationRow {
  std::string_view sign, label;
};
constexpr std::array kRelations{RelationRow{"==", "Equal to"}, RelationRow{"<=", "At most"},
                                RelationRow{">=", "At least"}};

template <class Rows, class Text>
std::vector<Choice> choices(const Rows& rows, Text text) {
  std::vector<Choice> all;
  for (const auto& row : rows) all.push_back(text(row));
  return all;
}

struct Numbers {
  std::vector<Choice> choices;
  std::vector<std::string> words;  // words of the command
  void add(std::string word, std::string_view label, std::string_view help) {
    words.push_back(std::move(word)), choices.push_back({std::string(label), std::string(help)});
  }
};

// The length of a force section, all keys of a channel, and each key.
void add_forces(const world::ForceProgram& program, bool alone, Numbers& numbers) {
  numbers.add("length", "Length", "How long the section is, in metres or seconds.");
  for (const world::ForceChannelRow& row : world::channels_of(program.of)) {
    const world::ForceChannel channel = *base::value_named<world::ForceChannel>(row.name);
    const std::vector<world::ForceKey>& keys = program.keys(channel);
    if (keys.empty()) continue;
    numbers.add(std::string(row.name), fmt::format("{} keys", row.label), "The values of all these keys.");
    if (!alone) continue;
    const std::string unit(world::unit_of(program, channel)), place(world::unit_of(program.over));
    for (const world::ForceKey& key : keys)
      numbers.add(fmt::format("{} at {}", row.name, base::to_text(key.at)),
                  fmt::format("{} key at {} {}", row.label, base::to_text(std::round(key.at * 100) / 100), place),
                  fmt::format("The value of this key: {:.4g} {}.", key.value, unit));
  }
}

// Returns what can be changed: positions and roll of knots, or the numbers of the selected section.
Numbers numbers_of(const edit::Session& session) {
  Numbers numbers;
  if (const auto chosen = world::selected_sections(session.document, session.settings); !chosen.empty()) {
    const world::Section& section = world::section(session.document, session.settings.selected);
    if (section.kind == world::SectionKind::force) add_forces(section.force, chosen.size() == 1, numbers);
    if (section.kind == world::SectionKind::element)
      for (const world::ElementParameter& row : base::row_of(section.element.kind).parameters)
        if (row.names.empty() && world::counts(section.element, row))
          numbers.add(std::string(row.name), row.label, row.help);
  } else if (!world::selected_knots(session.document, session.settings).empty()) {
    numbers.add("height", "Height", "The heights of the selected knots.");
    numbers.add("place", "Place", "The heights of the selected knots, and their places on the plan.");
    numbers.add("roll", "Roll", "The roll of the selected knots.");
  }
  return numbers;
}

edit::KnotsOrSections selected(const edit::Session& session) {
  edit::KnotsOrSections of;
  std::vector<world::Entity> entities = world::selected_sections(session.document, session.settings);
  if (entities.empty()) entities = world::selected_knots(session.document, session.settings);
  for (const world::Entity e : entities) of.names.push_back(world::name_of(session.document, e));
  return of;
}

void choose_goal(Ui& ui) {
  GoalInputs& in = ui.inputs.goal;
  const auto labels = choices(query::goals(), [](const query::GoalRow& row) {
    return Choice{std::string(row.label), std::string(query::find_query(row.query)->text)};
  });
  if (const auto to =
          combo(ui, "Make", labels, in.goal, "The value to reach, such as the lap time.", ComboPlace::beside))
    in.goal = *to, in.value.reset();
  const query::GoalRow& row = query::goals()[static_cast<std::size_t>(in.goal)];
  read_query(ui, "Now", row.query, query::find_query(row.query)->text, {.decimals = row.decimals});
  const auto relations = choices(kRelations, [](const RelationRow& r) { return Choice{std::string(r.label), ""}; });
  if (const auto to = combo(ui, "Relation", relations, in.relation, "How the value compares with the number."))
    in.relation = *to;
  if (!in.value) in.value = number_of(ui, row.query).value_or(0);
  const std::string unit(query::find_query(row.query)->unit);
  if (const auto to = number(
          ui, "Value",
          {.value = *in.value, .unit = unit.c_str(), .decimals = row.decimals, .step = 0.1, .low = -1e5, .high = 1e5},
          "The number to reach."))
    in.value = *to;
}

}  // namespace

void goal_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  const Numbers numbers = numbers_of(session);
  choose_goal(ui);
  GoalInputs& in = ui.inputs.goal;
  if (numbers.words.empty())
    return tinted("Select knots or planned sections: the search changes their numbers.", palette().dim);
  in.by = std::min(in.by, static_cast<int>(numbers.words.size()) - 1);
  if (const auto to = combo(ui, "By changing", numbers.choices, in.by, "The numbers that the search may change.",
                            ComboPlace::beside))
    in.by = *to;
  if (const auto to = checkbox(ui, "All by the same amount", in.together,
                               "Change all of these numbers by the same amount, so that they stay as they are relative "
                               "to each other."))
    in.together = *to;
  if (!button(ui, "Search", "Change these numbers as little as possible until the value is reached. One undo step.",
              true, -1))
    return;
  edit::Seek seek;
  seek.goal.text = fmt::format("{} {} {}", query::goals()[static_cast<std::size_t>(in.goal)].query,
                               kRelations[static_cast<std::size_t>(in.relation)].sign, base::to_text(*in.value));
  seek.by.text = numbers.words[static_cast<std::size_t>(in.by)];
  seek.of = selected(session), seek.together = in.together;
  ui.emit(seek);
}

}  // namespace coaster::ui
