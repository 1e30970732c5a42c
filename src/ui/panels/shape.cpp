// Shape: operations on the selected knots or on all knots, and snapping. Goal: changes numbers of the selection until
// the ride reaches a goal.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "query/condition.h"
#include "query/query.h"
#include "ui/context/query_widgets.h"
#include "ui/context/ui.h"
#include "ui/tools/selecting.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"
#include "world/element_rows.h"
#include "world/sections.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

// The selected knots (both of a selected segment), or all of them.
edit::Knots shaped_knots(const edit::Session& session) {
  const world::Document& document = session.document;
  edit::Knots knots(names_of(document, world::selected_knots(document, session.settings)));
  if (const world::Segment* const segment = document.entities.find<world::Segment>(session.settings.selected))
    knots.names = {world::name_of(document, segment->from), world::name_of(document, segment->to)};
  if (knots.names.empty() || knots.names.size() == document.track.knots.size()) return edit::Knots::Which::all;
  return knots;
}

glm::vec3 middle_of(const edit::Session& session, const edit::Knots& knots) {
  std::vector<world::Entity> entities = session.document.track.knots;
  if (knots.which == edit::Knots::Which::named)
    std::erase_if(entities, [&](world::Entity e) {
      return std::ranges::count(knots.names, world::name_of(session.document, e)) == 0;
    });
  return entities.empty() ? glm::vec3(0) : world::middle_of(session.document, entities);
}

// Buttons for commands that a challenge may lock.
struct Buttons {
  Ui& ui;
  ButtonRows rows;
  Buttons(Ui& of, int columns, std::string_view widest) : ui(of), rows{of, columns, widest} {}
  bool operator()(std::string_view label, std::string_view tooltip, bool enabled = true,
                  std::string_view command = {}) {
    const LockedWidgets locked(ui, command);
    return rows(label, tooltip, enabled);
  }
};

void snapping(Ui& ui) {
  const world::Snapping& now = ui.session().settings.snapping;
  if (const auto to = combo_of(ui, "Snap to", now.to,
                               fmt::format("Dragged knots snap to this. {} selects the next. Hold Ctrl while dragging "
                                           "to invert snapping.",
                                           ui.keys.shown("Next snapping"))))
    ui.emit(edit::SetSnapping{*to, now.step, now.angle});
  if (const auto to =
          number(ui, "Step", {.value = now.step, .unit = "m", .decimals = 3, .step = 0.01, .low = 0.001, .high = 1000},
                 "Step of the grid."))
    ui.emit(edit::SetSnapping{now.to, *to, now.angle});
  if (const auto to = number(
          ui, "Angle", {.value = now.angle, .unit = "\u00B0", .decimals = 1, .step = 0.1, .low = 0.1, .high = 180},
          "Rotations snap to multiples of this angle."))
    ui.emit(edit::SetSnapping{now.to, now.step, *to});
}

void whole_track(Ui& ui) {
  const edit::Session& session = ui.session();
  const world::Track& track = session.document.track;
  const std::size_t chosen = world::selected_knots(session.document, session.settings).size();
  Buttons next{ui, 3, "Duplicate"};
  if (next("Reverse", "Reverse the direction of travel. The shape is unchanged.", !track.segments.empty()))
    ui.emit(edit::Reverse{});
  if (next("Duplicate",
           "Copy the track between the selected neighbouring knots to the open end, rotated to continue from there.",
           !track.closed && chosen >= 2))
    ui.emit(edit::Duplicate{shaped_knots(session)});
  if (next("Close", "Close the track exactly: ends nearer than 2 m become one knot, others get a segment between them.",
           !track.closed && track.knots.size() >= 2))
    ui.emit(edit::CloseExactly{});
}

constexpr base::NameRow kRelations[] = {{"==", "Equal to"}, {"<=", "At most"}, {">=", "At least"}};

struct SeekNumberChoices {
  std::vector<Choice> choices;
  std::vector<std::string> words;  // words of the command
  void add(std::string word, std::string_view label, std::string_view help) {
    words.push_back(std::move(word)), choices.push_back({std::string(label), std::string(help)});
  }
};

// The length of a force section, all keys of a channel, and each key.
void add_forces(const world::ForceProgram& program, bool alone, SeekNumberChoices& numbers) {
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
SeekNumberChoices numbers_of(const edit::Session& session) {
  SeekNumberChoices numbers;
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
  std::vector<world::Entity> entities = world::selected_sections(session.document, session.settings);
  if (entities.empty()) entities = world::selected_knots(session.document, session.settings);
  edit::KnotsOrSections of;
  of.names = names_of(session.document, entities);
  return of;
}

void choose_goal(Ui& ui) {
  GoalInputs& in = ui.inputs.goal;
  std::vector<Choice> labels;
  for (const query::GoalRow& row : query::goals())
    labels.push_back({std::string(row.label), std::string(query::find_query(row.query)->text)});
  if (const auto to =
          combo(ui, "Make", labels, in.goal, "The value to reach, such as the lap time.", ComboPlace::beside))
    in.goal = *to, in.value.reset();
  const query::GoalRow& row = query::goals()[static_cast<std::size_t>(in.goal)];
  read_query(ui, "Now", row.query, query::find_query(row.query)->text, {.decimals = row.decimals});
  if (const auto to =
          combo(ui, "Relation", choices_in(kRelations), in.relation, "How the value compares with the number."))
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

void shape_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  const edit::Knots knots = shaped_knots(session);
  const std::size_t on_track = session.document.track.knots.size();
  const bool any = on_track > 0, all = knots.which == edit::Knots::Which::all;
  const std::size_t count = all ? on_track : knots.names.size();
  read_out(ui, "Acts on", fmt::format("{}{} {}", all ? "all " : "", count, count == 1 ? "knot" : "knots"), "",
           fmt::format("The selected knots, or all when none is selected. Shift+click adds a knot, Ctrl+click adds all "
                       "up to it, {} draws a box, {} selects all.",
                       ui.keys.shown("Box select"), ui.keys.shown("Select all")));
  Buttons next{ui, 2, "Equalise handles"};
  if (next("Smooth", "Fit the natural C2 spline through the knots: curvature is continuous at every joint.",
           on_track > 1, edit::Smooth::kInfo.name))
    ui.emit(edit::Smooth{knots});
  if (next("Equalise handles", "Set both handles to their average length (C1).", any, edit::Equalise::kInfo.name))
    ui.emit(edit::Equalise{knots});
  if (next("Straighten", "Move neighbouring knots onto the line from the first to the last.", any && count > 1))
    ui.emit(edit::Straighten{knots});
  if (next("Drop to ground", "Move the knots to the ground and level them.", any)) ui.emit(edit::DropToGround{knots});
  constexpr std::array<std::string_view, 3> kMirrors{"Mirror X", "Mirror Y", "Mirror Z"};
  Buttons mirrors{ui, 3, kMirrors[1]};
  for (int i = 0; i < 3; ++i)
    if (mirrors(kMirrors[static_cast<std::size_t>(i)],
                "Mirror across the plane through the centre of the knots, normal to the axis.", any)) {
      glm::vec3 across(0);
      across[i] = 1;
      ui.emit(edit::Mirror{knots, across, middle_of(session, knots)});
    }
  if (const auto to =
          number(ui, "Radius", {.value = ui.inputs.radius, .unit = "m", .step = 0.1, .low = 0.1, .high = 1e5},
                 "Radius of curvature for Set radius."))
    ui.inputs.radius = *to;
  if (button(ui, "Set radius", "Give the knots this radius of curvature by changing their handle lengths.",
             any && count < on_track, -1))
    ui.emit(edit::SetRadius{knots, ui.inputs.radius});
  whole_track(ui);
  snapping(ui);
}

void goal_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  const SeekNumberChoices numbers = numbers_of(session);
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
  edit::SeekGoal seek;
  seek.goal.text = fmt::format("{} {} {}", query::goals()[static_cast<std::size_t>(in.goal)].query,
                               kRelations[static_cast<std::size_t>(in.relation)].name, base::to_text(*in.value));
  seek.by.text = numbers.words[static_cast<std::size_t>(in.by)];
  seek.of = selected(session), seek.together = in.together;
  ui.emit(seek);
}

}  // namespace coaster::ui
