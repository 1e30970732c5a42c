// The commands of the ride's operation: equipment, trains, losses, banking. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "world/document.h"
#include "world/loss_presets.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Operation);

struct SetEquipment {
  Target segment;
  world::Equipment to;
  COASTER_COMMAND(SetEquipment, "equip",
                  "Put a station, lift, launch, brake or block on a segment (m/s, m/s^2, m/s, s).", Effect::document,
                  "Made {} a {as}");
  COASTER_FIELDS(visit("", self.segment); visit_equipment(self.to, visit))
};
struct RemoveEquipment {
  Target segment;
  COASTER_COMMAND(RemoveEquipment, "unequip", "Make a segment plain track again.", Effect::document,
                  "Removed the equipment of {}");
  COASTER_FIELDS(visit("", self.segment))
};
struct SetTrain {
  Target cart;
  int cars = 1;
  float spacing = 0, length = 0, mass = 0;  // 0: unchanged
  COASTER_COMMAND(SetTrain, "train",
                  "Set a train's number of cars, the distance of their centres (m), and the length (m) and mass (kg) "
                  "of each; values that are 0 or left out do not change.",
                  Effect::document, "Changed the train {}");
  COASTER_FIELDS(visit("", self.cart), visit("cars", self.cars), visit("spacing?", self.spacing),
                 visit("length?", self.length), visit("mass?", self.mass))
};
struct SetLosses {
  float rolling = 0, drag = 0;
  COASTER_COMMAND(SetLosses, "losses",
                  "Set rolling friction (of the weight) and drag (1/m); 0 0 is the frictionless circuit.",
                  Effect::document, "Set friction and drag");
  COASTER_FIELDS(visit("rolling", self.rolling), visit("drag", self.drag))
};
struct SetLossSet {
  world::LossSet to{};
  COASTER_COMMAND(SetLossSet, "losses.set", "Set rolling friction and drag to those of a named set.", Effect::document,
                  "Set friction and drag to {}");
  COASTER_FIELDS(visit("", self.to))
};
struct SetHeartline {
  double to = 1.1;
  COASTER_COMMAND(SetHeartline, "heartline",
                  "Set the height of the riders' hearts above the rails, for which forces are computed (m).",
                  Effect::document, "Set the heartline to {} m");
  COASTER_FIELDS(visit("", self.to))
};
enum class CurveSwitchKeeps : std::uint8_t { rails, numbers };
inline constexpr base::NameRow kKeeps[] = {
    {"rails", "Rails", "The rails stay within 1 cm, and the knots' numbers change."},
    {"numbers", "Numbers", "The knots' numbers stay, and the rails move by the heartline's height."}};
constexpr std::span<const base::NameRow> rows_of(CurveSwitchKeeps) { return kKeeps; }
struct SetCurve {
  world::TrackCurve to{};
  CurveSwitchKeeps keep{};
  COASTER_COMMAND(SetCurve, "curve",
                  "Make the track's curve the rails or the riders' heartline, with the rails below it; keeps the shape "
                  "of the rails, within 1 cm, or the knots' numbers.",
                  Effect::document, "Made the {} the curve");
  COASTER_FIELDS(visit("", self.to), visit("keep", self.keep))
};
struct SetRollbackFails {
  bool to = true;
  COASTER_COMMAND(SetRollbackFails, "rollback_fails", "Whether a train that rolls back ends the ride (on, off).",
                  Effect::document, "Rollbacks {?end|no longer end} the ride");
  COASTER_FIELDS(visit("", self.to))
};
struct SaveReport {
  std::string path;
  COASTER_COMMAND(SaveReport, "report",
                  "Write the report of the selected train's whole ride, else the first one's, to a file; one that ends "
                  "in .csv gets the ride by time.",
                  Effect::session, {}, kWritesFile);
  COASTER_FIELDS(visit("", self.path))
};
struct LoadForceLimits {
  std::string path;
  COASTER_COMMAND(LoadForceLimits, "envelope",
                  "Compare forces with the limits by duration in a file (.json): data to edit, not a compliance check.",
                  Effect::session, {}, {PathUse::opens, RecordedForm::nothing});
  COASTER_FIELDS(visit("", self.path))
};
struct AutoBank {
  COASTER_COMMAND(
      AutoBank, "auto_bank",
      "Roll every knot so that the riders of the selected train, else of the first, feel no lateral g there.",
      Effect::document, "Banked the track");
  COASTER_FIELDS()
};

COASTER_COMMAND_LIST(Operation, SetEquipment, RemoveEquipment, SetTrain, SetLosses, SetLossSet, SetHeartline, SetCurve,
                     SetRollbackFails, SaveReport, LoadForceLimits, AutoBank);

}  // namespace coaster::edit
