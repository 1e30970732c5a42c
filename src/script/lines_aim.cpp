// Parses aim.*: the target, the modifiers and the destination of a drag.
#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "script/lines.h"

namespace coaster::script {
namespace {

using view::PickKind;
using AimVerb = AimAction::Verb;
constexpr std::string_view kTargets =
    "@k3, @k3.in, @k3.out, @k3.spin, @s2:0.4, @c1, @q2, @q2.turn, @q2.bank, gizmo.x .. gizmo.xy, ground X Y Z or world "
    "X Y Z";

bool refuse(Words& words, const base::Token& word) {
  const std::string at = "@" + word.text.substr(0, word.text.find_first_of(".:"));
  const std::string hint = world::parse_name(at.substr(1)) ? fmt::format("; did you mean \"@{}\"?", word.text) : "";
  return words.fail(word.column, fmt::format("expected {}, found {}{}", kTargets, base::quoted_start(word.text), hint));
}

// Parses "@k3.in", "@s2:0.4" and so on.
bool parse_entity(Words& words, const base::Token& word, AimPoint& point) {
  std::string_view text = word.text;
  if (!text.starts_with('@')) return refuse(words, word);
  text.remove_prefix(1);
  if (text.ends_with(':')) return refuse(words, word);
  std::string_view handle, place;
  if (const std::size_t dot = text.find('.'); dot != std::string_view::npos && text.find(':') == std::string_view::npos)
    handle = text.substr(dot + 1), text = text.substr(0, dot);
  if (const std::size_t colon = text.find(':'); colon != std::string_view::npos)
    place = text.substr(colon + 1), text = text.substr(0, colon);
  const auto name = world::parse_name(text);
  if (!name) return refuse(words, word);
  point.name = *name;
  using world::Kind;
  constexpr std::tuple<Kind, std::string_view, PickKind> kMarks[] = {
      {Kind::knot, "", PickKind::knot},          {Kind::knot, "in", PickKind::handle_in},
      {Kind::knot, "out", PickKind::handle_out}, {Kind::knot, "spin", PickKind::spin},
      {Kind::section, "", PickKind::section},    {Kind::section, "turn", PickKind::turn},
      {Kind::section, "bank", PickKind::bank},   {Kind::cart, "", PickKind::cart}};
  for (const auto& [of, mark, kind] : kMarks)
    if (of == name->kind && handle == mark && place.empty()) return point.kind = kind, true;
  if (name->kind != world::Kind::segment || !handle.empty()) return refuse(words, word);
  point.kind = PickKind::curve;
  point.t = 0.5;
  if (place.empty()) return true;
  const auto t = base::parse_double(place);
  if (!t || !(*t >= 0 && *t <= 1))
    return words.fail({word.column,
                       "expected a parameter from 0 to 1 after the colon, found " + base::quoted_start(place),
                       base::is_number(place)});
  point.t = *t;
  return true;
}

// Parses "gizmo.x", an arrow, and "gizmo.xz", the square that moves along both axes.
bool parse_gizmo(Words& words, const base::Token& word, AimPoint& point) {
  constexpr std::array<std::string_view, 6> kParts{"x", "y", "z", "yz", "xz", "xy"};
  const auto part =
      std::find(kParts.begin(), kParts.end(), std::string_view(word.text).substr(std::string_view("gizmo.").size()));
  if (part == kParts.end()) return refuse(words, word);
  point.kind = static_cast<PickKind>(static_cast<int>(PickKind::axis_x) + (part - kParts.begin()));
  return true;
}

bool parse_point(Words& words, AimPoint& point, std::string& text, int& column) {
  const base::Token* const word = words.take(kTargets);
  if (!word) return false;
  text = word->text, column = word->column;
  if (word->text.starts_with("gizmo.")) return parse_gizmo(words, *word, point);
  if (word->text != "ground" && word->text != "world") return parse_entity(words, *word, point);
  const auto position = words.vector("a coordinate (m)");
  if (position) point.position = *position;
  if (word->text == "ground") point.position.y = 0;
  return position.has_value();
}

bool begin(Words& words, AimVerb verb, AimAction& aim) {
  aim.verb = verb;
  take_modifiers(words, aim.modifiers);
  if (!parse_point(words, aim.target, aim.target_text, aim.target_column)) return false;
  take_modifiers(words, aim.modifiers);
  return true;
}

template <AimVerb verb>
bool target_alone(Words& words, Action& action) {
  AimAction aim;
  if (!begin(words, verb, aim)) return false;
  action = std::move(aim);
  return words.end();
}

// Parses "to X Y Z" or "to TARGET".
bool parse_destination(Words& words, AimAction& aim) {
  const base::Token* const next = words.peek();
  AimPoint to;
  if (next && base::parse_double(next->text)) {
    const auto position = words.vector("a coordinate (m)");
    if (!position) return false;
    to.position = *position;
  } else {
    std::string text;
    int column = 1;
    if (!parse_point(words, to, text, column)) return false;
  }
  aim.to = to;
  return true;
}

bool parse_aim_drag(Words& words, Action& action) {
  AimAction aim;
  if (!begin(words, AimVerb::drag, aim)) return false;
  if (words.accept("to")) {
    if (!parse_destination(words, aim)) return false;
  } else if (words.accept("by")) {
    aim.by = words.vector("a distance (m)");
    if (!aim.by) return false;
  } else {
    return words.fail(next_column(words), "expected by X Y Z or to TARGET");
  }
  take_modifiers(words, aim.modifiers);
  action = std::move(aim);
  return words.end();
}

constexpr LineRow kAimLines[]{{"aim.click", target_alone<AimVerb::click>},
                              {"aim.doubleclick", target_alone<AimVerb::doubleclick>},
                              {"aim.hover", target_alone<AimVerb::hover>},
                              {"aim.drag", parse_aim_drag}};

}  // namespace

std::span<const LineRow> aim_lines() { return kAimLines; }

}  // namespace coaster::script
