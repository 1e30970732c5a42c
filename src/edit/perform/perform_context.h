// The context of perform() for every kind of command, which its COASTER_COMMAND declares. Private to this room.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/session/session.h"
#include "world/equipment_rows.h"

namespace coaster::edit {

// How moving trains follow a change of the track's segments: they keep their positions on the rails.
struct MotionFollowUp {
  enum class Kind : std::uint8_t { none, split, merged, reversed } kind = Kind::none;
  world::Entity first, second;                 // the new halves, or survivor and removed
  double first_length = 0, second_length = 0;  // m, merged: before the change
};

struct ClosingSearch;  // edit/perform/job_result.h

// The files that a command may use, and its report besides the status.
struct Change {
  base::Files& files;
  ClosingSearch* search = nullptr;     // what another thread has found, or may search for
  std::vector<std::string> clamped{};  // one sentence for each clamped value or other warning
  std::string note{};                  // result to show on success, if it is not obvious
  MotionFollowUp motion{};
  std::vector<world::Entity> respun{};    // knots whose automatic spins follow from new twists
  std::optional<world::Entity> select{};  // the selection on success
  std::vector<world::Entity> also{};      // further selected knots
  std::vector<world::Entity> planned{};   // sections that the command planned again, besides its own
  // m^2/s^2: twice the energy of a kilogram that the train has more than before where sections are planned again
  std::optional<double> gained{};
  bool remeasure = false;  // a setting that derived data depends on has changed

  // Returns `value` clamped to [low,high]; adds a sentence about WHAT and the limit if that changed it. Finite values
  // only: double, float, int and std::int64_t.
  template <class T>
  T clamp(std::string_view what, T value, std::type_identity_t<T> low, std::type_identity_t<T> high,
          std::string_view unit = {});
  glm::vec3 clamp_position(std::string_view what, glm::vec3 position);
  // Adds a warning as a sentence; nothing for an empty text.
  void warn_of(std::string text);
};

base::Status refused(std::string message);
// Returns the living entity of a target, of the wanted kind; else an error that says what is missing.
base::Result<world::Entity> require(const Session& session, Target target, world::EntityKind kind);

// Returns the document that a command changes: with `from_start` in an open gesture the one that the gesture began
// with, if it has the entity; else the present one.
const world::Document& former_document(const Session& session, bool from_start, world::Entity entity);

// Returns the entity of a command's field segment, knot, cart or section: apply() has refused the command otherwise,
// and if one of its numbers is not finite.
world::Entity entity_of(const Session& session, Target target);

// Returns the knot with that index; after the last one of a closed track comes the first.
inline const world::Knot& nth_knot(const world::Document& document, std::size_t index) {
  const auto& knots = document.track.knots;
  return world::knot(document, knots[index % knots.size()]);
}
inline world::Knot& nth_knot(world::Document& document, std::size_t index) {
  const auto& knots = document.track.knots;
  return document.entities.get<world::Knot>(knots[index % knots.size()]);
}

// Refused if a name or title is too long or cannot be printed.
base::Status may_be_called(std::string_view name, std::string_view what);
// Makes an automatic joint aligned, because it would undo a change made by hand.
void shaped_by_hand(world::Knot& knot);
// Starts track with another first handle at a knot.
void begin_there(world::Knot& knot, float out_length);

// Refused if an element's kind is invalid.
base::Status well_formed(const world::Element& element);

// Refused unless `value`, a place on a curve, is in [low,high], with the range in the message: such numbers are not
// clamped, because an end of the curve is another place than the one that was meant.
base::Status within(std::string_view what, double value, double low, double high, std::string_view unit = {});
// Refused if `segments` polylines of `steps` steps have more than `budget` vertices.
base::Status within_budget(std::size_t segments, int steps, std::int64_t budget);
// Refused if that many more knots and segments would exceed the limits.
base::Status room_for(const Session& session, std::size_t knots, std::size_t segments);
// Lowers the resolution until the document fits the budget, with a warning notice.
void fit_budget(Session& session);

// Derives the document's shapes again.
void derive(Session& session);
// Shows the warnings of a file that was read.
void warn(Session& session, const std::vector<std::string>& warnings);
// Starts with another document: discards everything that belongs to the old one, except settings.
void start_over(Session& session, world::Document document, std::filesystem::path path);

// --- The equipment that a command describes

// Returns it with its numbers clamped to their limits.
inline world::Equipment equipment_of(world::Equipment equipment, Change& change) {
  const auto fastest = static_cast<float>(world::kMaxSpeed);
  equipment.speed = change.clamp("speed", equipment.speed, 0.0f, fastest, "m/s");
  equipment.acceleration =
      change.clamp("acceleration", equipment.acceleration, world::kMinAcceleration, world::kMaxAcceleration, "m/s^2");
  equipment.hysteresis = change.clamp("hysteresis", equipment.hysteresis, 0.0f, fastest, "m/s");
  equipment.seconds = change.clamp("seconds", equipment.seconds, 0.0f, world::kMaxDwell, "s");
  return equipment;
}

// Puts equipment on segments. A notice names what they became, unless all of them were that already or another notice
// names a limit.
inline void equip(world::Document& document, Change& change, std::span<const world::Entity> segments,
                  const world::Equipment& equipment, const std::string& title) {
  bool new_kind = false;
  for (const world::Entity segment : segments) {
    const auto* const before = document.entities.find<world::Equipment>(segment);
    new_kind = new_kind || before == nullptr || before->kind != equipment.kind;
    document.entities.put(segment, equipment);
  }
  if (new_kind && change.clamped.empty())
    change.note = fmt::format("Made {} a {}.", title, base::name_of(equipment.kind));
}

}  // namespace coaster::edit
