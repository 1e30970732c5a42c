// The state of one command in apply(): what each perform() reports besides its status. Private to this room.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_lab.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "edit/session/session.h"

namespace coaster::edit {

// How moving trains follow a change of the track's segments: they keep their positions on the rails.
struct MotionFollowUp {
  enum class Kind : std::uint8_t { none, split, merged, reversed } kind = Kind::none;
  world::Entity first, second;                 // the new halves, or survivor and removed
  double first_length = 0, second_length = 0;  // m, merged: before the change
};

struct Change {
  std::vector<std::string> clamped;  // one line for each clamped value
  std::string note;                  // result to show on success, if it is not obvious
  MotionFollowUp motion;
  std::optional<world::Entity> select;  // the selection on success
  std::vector<world::Entity> also;      // further selected knots
  bool remeasure = false;               // a setting with derived data has changed

  // Returns `value` clamped to [low,high]; adds a line about "WHAT" and the limit if that changed it. Finite values
  // only.
  double clamp(std::string_view what, double value, double low, double high, std::string_view unit = {});
  float clamp(std::string_view what, float value, float low, float high, std::string_view unit = {});
  int clamp(std::string_view what, int value, int low, int high, std::string_view unit = {});
  std::int64_t clamp(std::string_view what, std::int64_t value, std::int64_t low, std::int64_t high,
                     std::string_view unit = {});
  glm::vec3 clamp_position(std::string_view what, glm::vec3 position);
};

base::Status refused(std::string message);
bool finite(glm::vec3 v);
// Returns the living entity of a target, of the wanted kind; else an error that says what is missing.
base::Result<world::Entity> require(const Session& session, Target target, world::Kind kind);

// Refused if `segments` polylines of `steps` steps have more than `budget` vertices.
base::Status within_budget(std::size_t segments, int steps, std::int64_t budget);
// Refused if there is no room for that many knots and segments.
base::Status room_for(const Session& session, std::size_t knots, std::size_t segments);
// Lowers the resolution until the document fits the budget, with a warning notice.
void fit_budget(Session& session);

// perform() checks first and changes nothing on failure. Document commands change only the document.
base::Status perform(Session& session, Change& change, const MoveKnot& command);
base::Status perform(Session& session, Change& change, const MoveHandle& command);
base::Status perform(Session& session, Change& change, const SetDirection& command);
base::Status perform(Session& session, Change& change, const SetLengths& command);
base::Status perform(Session& session, Change& change, const SetRoll& command);
base::Status perform(Session& session, Change& change, const SetJoint& command);
base::Status perform(Session& session, Change& change, const SetTurns& command);
base::Status perform(Session& session, Change& change, const SplitSegment& command);
base::Status perform(Session& session, Change& change, const AddCurve& command);
base::Status perform(Session& session, Change& change, const AppendKnot& command);
base::Status perform(Session& session, Change& change, const RemoveKnot& command);
base::Status perform(Session& session, Change& change, const SetClosed& command);
base::Status perform(Session& session, Change& change, const AddCart& command);
base::Status perform(Session& session, Change& change, const SetName& command);
base::Status perform(Session& session, Change& change, const SetStartSpeed& command);
base::Status perform(Session& session, Change& change, const SetDatum& command);
base::Status perform(Session& session, Change& change, const SetEquipment& command);
base::Status perform(Session& session, Change& change, const RemoveEquipment& command);
base::Status perform(Session& session, Change& change, const SetTrain& command);
base::Status perform(Session& session, Change& change, const SetLosses& command);
base::Status perform(Session& session, Change& change, const SetHeartline& command);
base::Status perform(Session& session, Change& change, const SetRollbackFails& command);
base::Status perform(Session& session, Change& change, const AutoBank& command);
base::Status perform(Session& session, Change& change, const PlaceElement& command);
base::Status perform(Session& session, Change& change, const MakeG2& command);
base::Status perform(Session& session, Change& change, const MakeAllG2& command);
base::Status perform(Session& session, Change& change, const Translate& command);
base::Status perform(Session& session, Change& change, const Rotate& command);
base::Status perform(Session& session, Change& change, const Scale& command);
base::Status perform(Session& session, Change& change, const Mirror& command);
base::Status perform(Session& session, Change& change, const Align& command);
base::Status perform(Session& session, Change& change, const Smooth& command);
base::Status perform(Session& session, Change& change, const Equalise& command);
base::Status perform(Session& session, Change& change, const Straighten& command);
base::Status perform(Session& session, Change& change, const SetRadius& command);
base::Status perform(Session& session, Change& change, const DropToGround& command);
base::Status perform(Session& session, Change& change, const Reverse& command);
base::Status perform(Session& session, Change& change, const Duplicate& command);
base::Status perform(Session& session, Change& change, const CloseExactly& command);

// Settings.
base::Status perform(Session& session, Change& change, const SetCamera& command);
base::Status perform(Session& session, Change& change, const SetFly& command);
base::Status perform(Session& session, Change& change, const Select& command);
base::Status perform(Session& session, Change& change, const SelectKnots& command);
base::Status perform(Session& session, Change& change, const SetSnapping& command);
base::Status perform(Session& session, Change& change, const SetPolyline& command);
base::Status perform(Session& session, Change& change, const ShowLayer& command);
base::Status perform(Session& session, Change& change, const Measure& command);
base::Status perform(Session& session, Change& change, const StopMeasuring& command);
base::Status perform(Session& session, Change& change, const ChooseElement& command);
base::Status perform(Session& session, Change& change, const LeaveChallenge& command);
base::Status perform(Session& session, Change& change, const ShowHint& command);
base::Status perform(Session& session, Change& change, const CloseCard& command);

// Motion.
base::Status perform(Session& session, Change& change, const RideStart& command);
base::Status perform(Session& session, Change& change, const RidePause& command);
base::Status perform(Session& session, Change& change, const RideStop& command);
base::Status perform(Session& session, Change& change, const RideStep& command);
base::Status perform(Session& session, Change& change, const RideSeek& command);

}  // namespace coaster::edit
