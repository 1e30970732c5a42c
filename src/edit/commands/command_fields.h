// The parts of commands: their targets, their effect, their name, help and list of fields; lists of kinds.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/glm.hpp>

#include "base/status.h"
#include "world/entity.h"

namespace coaster::edit {

struct Knots;

// An entity of any kind, written "@k3"; number 0 is "none".
struct Target {
  world::EntityName name;
  operator Knots() const;  // a command for several knots accepts one
  friend bool operator==(const Target&, const Target&) = default;
};

// Several knots: "@k1,@k2,@k7"; "@k3..@k9", which also names those between them on the track; "all"; or "selected": the
// selection at the time of the command. Order matters only for a range on a closed track: "@k9..@k3" leads across the
// first knot.
struct Knots {
  enum class Which : std::uint8_t { named, range, all, selected } which = Which::named;
  std::vector<world::EntityName> names;  // of a range: the first and the last
  Knots() = default;
  Knots(world::EntityName one) : names{one} {}
  Knots(Which all_or_selected) : which(all_or_selected) {}
  explicit Knots(std::vector<world::EntityName> several) : names(std::move(several)) {}
  friend bool operator==(const Knots&, const Knots&) = default;
};
inline Target::operator Knots() const { return Knots(name); }

// Several sections, written as knots are: "@q1,@q3", "all" or "selected". Order does not matter.
struct Sections {
  Knots::Which which = Knots::Which::named;
  std::vector<world::EntityName> names;
  Sections() = default;
  Sections(world::EntityName one) : names{one} {}
  explicit Sections(std::vector<world::EntityName> several) : names(std::move(several)) {}
  friend bool operator==(const Sections&, const Sections&) = default;
};

// Knots or sections, not both, written as either. "all" is all knots, "selected" the selected ones of either kind.
struct KnotsOrSections : Knots {
  using Knots::Knots;
  friend bool operator==(const KnotsOrSections&, const KnotsOrSections&) = default;
};

// Words up to the next "by" or "of", or to the end of the line: "ride.lap_time == 40".
struct Phrase {
  std::string text;
  friend bool operator==(const Phrase&, const Phrase&) = default;
};

// A word that may end a line: "save FILE overwrite".
struct Flag {
  bool set = false;
  explicit operator bool() const { return set; }
  friend bool operator==(const Flag&, const Flag&) = default;
};

// The values of the orbit camera that a command changes, in any order: "target 1 2 3 distance 40". At least one.
struct CameraChange {
  std::optional<glm::vec3> target;                    // m
  std::optional<float> yaw_deg, pitch_deg, distance;  // distance in m
  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    visit("target", self.target), visit("yaw", self.yaw_deg), visit("pitch", self.pitch_deg);
    visit("distance", self.distance);
  }
  friend bool operator==(const CameraChange&, const CameraChange&) = default;
};

enum class HandleEnd : std::uint8_t { in, out };
// A knot's handle, written "@k3.in" or "@k3.out".
struct HandleTarget {
  world::EntityName knot;
  HandleEnd end = HandleEnd::out;
  friend bool operator==(const HandleTarget&, const HandleTarget&) = default;
};

// What a command changes, for undo and recording.
enum class Effect : std::uint8_t { document, settings, motion, history, session };

// What a command does with the file that its member `path` names. Scripts may write only below $OUT.
enum class PathUse : std::uint8_t { none, opens, writes };
// What a recording keeps of a command: its line; the line with the whole path; a copy of the track as the command left
// it, which the recording loads; or nothing, because neither document nor motion depends on it.
enum class RecordedForm : std::uint8_t { line, whole_path, track, nothing };
struct CommandTraits {
  PathUse path = PathUse::none;
  RecordedForm recorded = RecordedForm::line;
  bool replaces = false;  // the whole track, by another: windows ask about unsaved changes, then frame the new track
};
inline constexpr CommandTraits kWritesFile{PathUse::writes, RecordedForm::nothing};
inline constexpr CommandTraits kOpensTrack{PathUse::opens, RecordedForm::track, true};

struct CommandInfo {
  std::string_view name;  // the first word of its line
  std::string_view help;
  Effect effect;
  // The sentence in the history for a command that changes the document: "Set the roll of {} to {to}°". Braces contain
  // a field's keyword (empty for the first field); "{to?Closed|Opened}" gives one word for each state of a switch.
  std::string_view done = {};
  CommandTraits traits = {};
};

// Returns the kind of the entity that a command names in its field segment, cart, section or knot; nothing for a
// command without such a field, or whose field has another name because it may be of several kinds.
template <class C>
constexpr std::optional<world::EntityKind> named_kind() {
  if constexpr (requires(C c) { c.segment.name; }) return world::EntityKind::segment;
  else if constexpr (requires(C c) { c.cart.name; }) return world::EntityKind::cart;
  else if constexpr (requires(C c) { c.section.name; }) return world::EntityKind::section;
  else if constexpr (requires(C c) { c.knot.name; }) return world::EntityKind::knot;
  else return std::nullopt;
}

struct Session;
struct Change;  // of the session by one command: edit/perform/perform_context.h

// The CommandInfo of a kind of command, and the function that carries it out. It checks first and changes nothing on
// failure; one with Effect::document changes only the document.
#define COASTER_COMMAND(Kind, ...)                 \
  static_assert(__COUNTER__ >= 0);                 \
  static constexpr CommandInfo kInfo{__VA_ARGS__}; \
  friend base::Status perform(Session& session, Change& change, const Kind& command)

// fields(self, visit) calls visit(keyword, member) in the order of the text; an empty keyword is positional: "move @k4
// to 1 2 3" has the fields ("", knot) and ("to", position). "on?" is optional, "on?|by" also accepts the former keyword
// "by".
#define COASTER_FIELDS(...)                                                         \
  template <class Self, class Visit>                                                \
  static void fields([[maybe_unused]] Self& self, [[maybe_unused]] Visit&& visit) { \
    __VA_ARGS__;                                                                    \
  }

// The fields of commands that add equipment; the numbers are in m/s, m/s^2, m/s and s.
template <class Equipment, class Visit>
void visit_equipment(Equipment& to, Visit&& visit) {
  visit("as", to.kind);
  visit("speed?", to.speed);
  visit("acceleration?", to.acceleration);
  visit("hysteresis?", to.hysteresis);
  visit("seconds?", to.seconds);
}

template <class... C>
struct CommandList {
  static constexpr std::size_t size = sizeof...(C);
  // Calls make.template operator()<C>() for each kind, in order.
  template <class Make>
  static constexpr auto table(Make make) {
    return std::array{make.template operator()<C>()...};
  }
};
template <class... A, class... B>
CommandList<A..., B...> operator+(CommandList<A...>, CommandList<B...>);

// The commands of a header stand between COASTER_COMMAND_GROUP(Ride) and COASTER_COMMAND_LIST(Ride, kinds), which
// defines RideCommands, their CommandList. A command that the list leaves out does not compile: both count.
#define COASTER_COMMAND_GROUP(Group) constexpr int kBefore##Group = __COUNTER__
#define COASTER_COMMAND_LIST(Group, ...)            \
  using Group##Commands = CommandList<__VA_ARGS__>; \
  static_assert(Group##Commands::size == __COUNTER__ - kBefore##Group - 1, "the list has each command of its header")

}  // namespace coaster::edit
