// Operation: equipment on the selected segment, the train, losses, the track's curve, and what ends the ride.
#include <fmt/format.h>

#include "edit/commands/commands_operation.h"
#include "ui/panels/element_equipment_fields.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

// Returns the selected segment, those between neighbouring selected knots, or else the one that starts at the active
// knot.
std::vector<world::Entity> chosen_segments(const edit::Session& session) {
  const world::Document& document = session.document;
  const world::Entity selected = session.settings.selected;
  if (document.entities.find<world::Segment>(selected)) return {selected};
  if (!document.entities.find<world::Knot>(selected)) return {};
  std::vector<world::Entity> between;
  if (!session.settings.also.empty()) {
    std::vector<bool> chosen;  // by index
    for (const world::Entity e : world::selected_knots(document, session.settings)) {
      if (e.index >= chosen.size()) chosen.resize(e.index + std::size_t{1});
      chosen[e.index] = true;
    }
    const auto is_chosen = [&](world::Entity knot) { return knot.index < chosen.size() && chosen[knot.index]; };
    for (const world::Entity e : document.track.segments)
      if (const world::Segment& s = world::segment(document, e); is_chosen(s.from) && is_chosen(s.to))
        between.push_back(e);
  }
  if (!between.empty()) return between;
  const world::Entity after = world::neighbours(document, selected).after;
  return after.valid() ? std::vector{after} : between;
}

void equipment(Ui& ui) {
  const world::Document& document = ui.session().document;
  const std::vector<world::Entity> segments = chosen_segments(ui.session());
  heading(ui, "Equipment",
          segments.empty() ? "Select a segment to place a station, lift, launch, brake or block."
                           : "Equipment on the selected segments.");
  equipment_form(ui, segments, edit::SetEquipment::kInfo.name, [&](const std::optional<world::Equipment>& to) {
    ui.emit_each(segments, [&](world::Entity e) {
      const world::EntityName name = world::name_of(document, e);
      if (to) ui.emit(edit::SetEquipment{{name}, *to});
      else if (document.entities.find<world::Equipment>(e)) ui.emit(edit::RemoveEquipment{{name}});
    });
  });
}

void train(Ui& ui) {
  const edit::Session& session = ui.session();
  const world::Entity cart = edit::chosen_cart(session);
  const world::Train* const design = session.document.entities.find<world::Train>(cart);
  if (!design) return;
  const world::EntityName name = world::name_of(session.document, cart);
  const Number cars{.value = static_cast<double>(design->cars),
                    .decimals = 0,
                    .low = 1,
                    .high = world::kMaxCars,
                    .largest = 1e9,
                    .whole = true};
  if (const auto to = number(ui, "Cars", cars, "Number of cars. They move as one."))
    ui.emit(edit::SetTrain{{name}, static_cast<int>(*to)});
  const auto field = [&](const char* label, const Number& value, float edit::SetTrain::*part, const char* tooltip) {
    const auto to = number(ui, label, value, tooltip);
    if (!to) return;
    edit::SetTrain set{{name}, design->cars};
    set.*part = static_cast<float>(*to);
    ui.emit(set);
  };
  field("Spacing",
        {.value = design->spacing, .unit = "m", .step = 0.02, .low = world::kMinSpacing, .high = world::kMaxSpacing},
        &edit::SetTrain::spacing, "Distance between the centres of neighbouring cars.");
  field("Car length",
        {.value = design->length, .unit = "m", .step = 0.02, .low = world::kMinCarLength, .high = world::kMaxCarLength},
        &edit::SetTrain::length, "Length of a car's body. Trains collide where bodies touch. At most the spacing.");
  field("Car mass",
        {.value = design->mass,
         .unit = "kg",
         .decimals = 0,
         .step = 0.5,
         .low = world::kMinCarMass,
         .high = world::kMaxCarMass,
         .largest = 1e6},
        &edit::SetTrain::mass, "Mass including riders. Drag is given for 500 kg; heavier cars slow down less.");
}

void loss_set(Ui& ui) {
  std::vector<Choice> sets = choices_of<world::LossSet>();
  const auto now = world::loss_set_of(ui.session().document.resistance);
  const int shown = now ? static_cast<int>(*now) : static_cast<int>(sets.size());
  if (!now) sets.push_back({"Own", "The numbers below."});
  const LockedWidgets locked(ui, edit::SetLossSet::kInfo.name);
  if (const auto to = combo(ui, "Losses", sets, shown, "Sets rolling friction and drag together."))
    ui.emit(edit::SetLossSet{static_cast<world::LossSet>(*to)});
}

void track_curve(Ui& ui) {
  const world::Document& document = ui.session().document;
  const bool rails = document.curve == world::TrackCurve::rails;
  read_out(ui, "Curve", std::string(base::row_of(document.curve).label), "",
           std::string(base::row_of(document.curve).help));
  const std::string_view other = rails ? "heartline" : "rails";
  const auto offer = [&](std::string_view label, edit::CurveSwitchKeeps keep, std::string_view effect) {
    if (wide_button(ui, label, fmt::format("Make the curve the {}. {}", other, effect)))
      ui.emit(edit::SetCurve{rails ? world::TrackCurve::heartline : world::TrackCurve::rails, keep});
  };
  offer("Switch, keep rails", edit::CurveSwitchKeeps::rails, "The rails keep their shape within 1 cm.");
  offer("Switch, keep numbers", edit::CurveSwitchKeeps::numbers, "The knots keep their numbers, and the rails move.");
}

void loss_numbers(Ui& ui) {
  const world::Losses& now = ui.session().document.resistance;
  const LockedWidgets locked(ui, edit::SetLosses::kInfo.name);
  if (const auto to = number(
          ui, "Rolling", {.value = now.rolling, .decimals = 4, .step = 0.0002, .low = 0, .high = world::kMaxRolling},
          "Rolling friction coefficient. Steel coasters: 0.02 to 0.03. 0: none."))
    ui.emit(edit::SetLosses{static_cast<float>(*to), now.drag});
  if (const auto to =
          number(ui, "Drag",
                 {.value = now.drag, .unit = "1/m", .decimals = 6, .step = 0.000002, .low = 0, .high = world::kMaxDrag},
                 "Drag coefficient: deceleration divided by v\u00B2. About 0.00002."))
    ui.emit(edit::SetLosses{now.rolling, static_cast<float>(*to)});
}

void losses(Ui& ui) {
  const world::Document& document = ui.session().document;
  loss_set(ui);
  loss_numbers(ui);
  const Number heartline{.value = document.heartline,
                         .unit = "m",
                         .step = 0.01,
                         .low = -world::kMaxHeartline,
                         .high = world::kMaxHeartline};
  if (const auto to = number(ui, "Heartline", heartline,
                             "Height of the riders' hearts above the rails. Forces are computed there."))
    ui.emit(edit::SetHeartline{*to});
  track_curve(ui);
  if (const auto on = checkbox(ui, "Rollback ends the ride", document.rollback_fails,
                               "The ride fails when a train rolls back 2 m."))
    ui.emit(edit::SetRollbackFails{*on});
}

}  // namespace

void operation_panel(Ui& ui) {
  equipment(ui);
  train(ui);
  losses(ui);
}

}  // namespace coaster::ui
