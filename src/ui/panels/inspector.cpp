// Inspector: values of the selected knot, segment or cart.
#include <algorithm>
#include <limits>

#include <imgui.h>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "curve/continuity.h"
#include "edit/commands/commands_document.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/commands_shape.h"
#include "sim/study/jolt.h"
#include "ui/context/query_widgets.h"
#include "ui/tools/selecting.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::ui {
namespace {

using world::Entity;
using world::EntityKind;
using world::EntityName;

constexpr std::string_view kAxes[] = {"x", "y", "z"};

// Typed numbers may exceed float. The largest float exceeds every limit, so the command clamps it with a notice.
float to_float(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

std::optional<ChangedNumber> vector_fields(Ui& ui, std::string_view group, glm::vec3 v, Number like,
                                           std::string_view tooltip) {
  std::array<Number, 3> fields{like, like, like};
  for (int i = 0; i < 3; ++i) fields[static_cast<std::size_t>(i)].value = v[i];
  return numbers(ui, group, kAxes, fields, tooltip);
}

std::optional<ChangedNumber> position_fields(Ui& ui, const world::Knot& knot, std::string_view tooltip) {
  constexpr double kReach = world::kMaxCoordinate;
  return vector_fields(ui, "Position", knot.position,
                       {.decimals = 3, .step = 0.02, .low = -kReach, .high = kReach, .typed_in = "m"}, tooltip);
}

// Handles, roll and joint of one knot or several; the fields show those of `knot`. `both`: one length sets both.
void handle_fields(Ui& ui, const edit::Knots& knots, const world::Knot& knot, bool both, std::string_view tooltip) {
  constexpr std::string_view kEnds[] = {"in", "out"};
  const Number length{
      .decimals = 3, .step = 0.02, .low = world::kMinHandle, .high = world::kMaxHandle, .typed_in = "m"};
  std::array<Number, 2> lengths{length, length};
  lengths[0].value = knot.in_length;
  lengths[1].value = knot.out_length;
  if (const auto c = numbers(ui, "Handles", kEnds, lengths, tooltip)) {
    const float to = to_float(c->value);
    ui.emit(edit::SetHandleLengths{knots, both || c->index == 0 ? to : knot.in_length,
                                   both || c->index == 1 ? to : knot.out_length});
  }
}
void roll_field(Ui& ui, const edit::Knots& knots, const world::Knot& knot, std::string_view tooltip) {
  const Number roll{
      .value = world::roll_deg(knot), .unit = "\u00B0", .step = 0.25, .low = -180, .high = 180, .largest = 1e300};
  if (const auto to = number(ui, "Roll", roll, tooltip)) ui.emit(edit::SetRoll{knots, *to});
}
// The spin of one knot or several; the fields show that of `knot`.
void spin_fields(Ui& ui, const edit::Knots& knots, const world::Knot& knot) {
  const double most = base::degrees(double{world::kMaxSpin});
  const double spin = base::degrees(double{knot.spin});
  const Number number_of{.value = spin, .unit = "\u00B0/m", .step = 0.05, .low = -most, .high = most, .largest = 1e300};
  if (const auto to = number(ui, "Spin", number_of,
                             "Rate of roll along the track at the knot, the same on both sides. Positive to the "
                             "rider's right."))
    ui.emit(edit::SetSpin{knots, *to});
  if (const auto kind = combo_of(ui, "Spin type", knot.spin_kind,
                                 "Automatic: follows the roll of the neighbouring knots. Set: stays as it is.")) {
    if (*kind == world::SpinKind::automatic) ui.emit(edit::AutomaticSpin{knots});
    else ui.emit(edit::SetSpin{knots, spin});
  }
}
// At the present speed of the first train.
void roll_rate(Ui& ui, const world::Knot& knot) {
  const edit::Session& session = ui.session();
  const world::TrainMotion* const train = session.motion.carts.find(world::first_cart(session.document));
  read_out(ui, "Roll rate", train ? fixed(base::degrees(double{knot.spin}) * train->speed, 1) : "--", "\u00B0/s",
           "The spin times the present speed of the first train.");
}
void joint_list(Ui& ui, const edit::Knots& knots, const world::Knot& knot, std::string_view tooltip) {
  const LockedWidgets locked(ui, edit::SetJoint::kInfo.name);
  if (const auto kind = combo_of(ui, "Joint", knot.joint, tooltip)) ui.emit(edit::SetJoint{knots, *kind});
}

void jolt(Ui& ui, Entity knot) {
  const auto index = world::index_of(ui.session().document.track.knots, knot);
  if (!index) return;
  const std::span<const sim::Jolt> jolts = ui.find.jolts();
  const auto step = sim::fastest_step(ui.session().document, jolts, *index);
  read_out(ui, "g-step", step ? digits(ui, *step, 3, "g") : "--", "g",
           "v\u00B2 |\u0394\u03BA| / g: step of the force here at the fastest passage of the whole ride, of all cars.",
           false, step > sim::kStepLimit);
  if (ui.find.ride() == nullptr) return;
  const sim::Jolt found = *index < jolts.size() ? jolts[*index] : sim::Jolt{};
  read_out(ui, "Jolt", digits(ui, found.total, 2, "g"), "g",
           fmt::format("Largest change of felt g by the jumps of curvature and roll here, low-pass filtered: "
                       "vertical {}, lateral {}, longitudinal {} g. Worst in car {}, at {} m/s.",
                       digits(ui, found.up, 2, "g"), digits(ui, found.left, 2, "g"), digits(ui, found.forward, 2, "g"),
                       found.car + 1, fixed(found.speed, 1)),
           found.total > sim::kJoltLimit);
}

void continuity(Ui& ui, Entity entity, EntityName name) {
  const world::Document& document = ui.session().document;
  const world::KnotSegments at = world::neighbours(document, entity);
  if (!at.before.valid() || !at.after.valid()) {
    read_out(ui, "Continuity", "end of the track", "", "The end of an open track is no joint.");
    return;
  }
  const curve::JointContinuity joint =
      curve::joint(world::cubic_of(document, at.before), world::cubic_of(document, at.after));
  const std::string argument = "@" + world::to_text(name);
  read_query(ui, "Geometric", "geometric",
             "Geometric continuity. G0: same position, G1: same tangent, G2: same curvature.", {.argument = argument});
  read_query(
      ui, "Parametric", "parametric",
      "Parametric continuity. C1: equal first derivatives, C2: equal second derivatives. Stricter than G1 and G2.",
      {.argument = argument});
  read_query(ui, "Gap", "gap", "Distance between the end of one segment and the start of the next.",
             {.decimals = 3, .unit = "mm", .factor = 1e3, .argument = argument});
  read_out(ui, "Angle", fixed(base::degrees(joint.angle), 3), "\u00B0", "Angle between the two tangents.");
  read_out(ui, "Speed ratio", fixed(joint.speed_ratio, 3), "", "|C'(0)| / |B'(1)|: 1 for C1.");
  jolt(ui, entity);
}

void knot_inspector(Ui& ui, Entity entity, EntityName name) {
  const world::Knot& knot = world::knot(ui.session().document, entity);
  heading(
      ui, "Position (m)",
      "Position of the knot: x, height y, z. Drag it in the viewport; Shift moves it vertically, Ctrl horizontally.");
  if (const auto c = position_fields(ui, knot, "Drag, or click and type a value.")) {
    glm::vec3 to = knot.position;
    to[c->index] = to_float(c->value);
    ui.emit(edit::MoveKnot{{name}, to});
  }
  heading(ui, "Direction", "The unit tangent in the direction of travel. Both segments of a joint share it (G1).");
  if (const auto c = vector_fields(ui, "Direction", knot.tangent, {.decimals = 3, .step = 0.005, .low = -1, .high = 1},
                                   "Drag, or click and type. The direction is normalised.")) {
    glm::vec3 to = knot.tangent;
    to[c->index] = to_float(c->value);
    ui.emit(edit::SetDirection{{name}, to});
  }
  heading(ui, "Handles (m)",
          "Distances to the control points before (in) and after (out) the knot: a third of the parametric speed.");
  handle_fields(ui, name, knot, knot.joint == world::JointKind::smooth,
                "Drag, or click and type a value. A smooth joint keeps both equal.");
  roll_field(ui, name, knot, "Bank of the track at the knot, in degrees. Positive to the rider's right.");
  spin_fields(ui, name, knot);
  roll_rate(ui, knot);
  joint_list(ui, name, knot, "Continuity between the two segments at this knot.");
  continuity(ui, entity, name);
}

// Fields of the active knot that change every selected one.
void knots_inspector(Ui& ui, Entity active, const std::vector<Entity>& knots) {
  const world::Document& document = ui.session().document;
  const world::Knot& knot = world::knot(document, active);
  const edit::Knots all(names_of(document, knots));
  read_out(ui, "Active", world::label_of(document, active), "",
           "The values below are those of this knot. A change applies to all selected knots.");
  heading(ui, "Position (m)", "Sets one coordinate of all selected knots. The other two stay.");
  if (const auto c = position_fields(ui, knot, "Set this coordinate of all selected knots."))
    ui.emit(edit::Align{all, static_cast<world::Axis>(c->index), c->value});
  heading(ui, "Handles (m)", "Handle lengths of all selected knots.");
  handle_fields(ui, all, knot, false, "Set the handle lengths of all selected knots.");
  roll_field(ui, all, knot, "Bank of all selected knots, in degrees.");
  spin_fields(ui, all, knot);
  joint_list(ui, all, knot, "Joint type of all selected knots.");
}

bool is_longest(const sim::DerivedTrack& derived, Entity entity) {
  for (const Entity other : derived.order)
    if (derived.shape(other).arc.length() > derived.shape(entity).arc.length()) return false;
  return true;
}

void segment_inspector(Ui& ui, Entity entity, EntityName name) {
  const edit::Session& session = ui.session();
  const sim::SegmentShape* shape = session.derived.segments.find(entity);
  const Number place{
      .value = session.settings.selected_t, .decimals = 4, .step = 0.002, .low = 0, .high = 1, .largest = 1e300};
  if (const auto to = number(ui, "Position t###Place", place,
                             "The selected position as parameter t, 0 to 1. Insert point splits the segment there."))
    ui.emit(edit::Select{{name}, *to});
  const Number turns =
      whole_number(world::segment(session.document, entity).turns, -world::kMaxTurns, world::kMaxTurns);
  if (const auto to =
          number(ui, "Turns", turns, "Full turns of roll within the segment (barrel rolls), added to the least twist."))
    ui.emit(edit::SetTurns{{name}, static_cast<int>(*to)});
  if (shape == nullptr) return;
  const double t = session.settings.selected_t;
  const glm::dvec3 at = curve::point(shape->key.cubic, t);
  read_out(ui, "Length", shape->measured_length, 3, "m", "Arc length, by the method selected in Evaluation.");
  read_out(ui, "Distance here###Distance there", shape->arc.distance(t), 3, "m",
           "Arc length from the segment's start to position t.");
  read_out(ui, "Height here###Height there", at.y, 3, "m", "Height at position t.");
  read_out(ui, "Curvature here###Curvature there", curve::curvature_if_any(shape->key.cubic, t).value_or(kNoNumber), 5,
           "1/m", "Curvature at position t: |B' \u00D7 B''| / |B'|\u00B3.");
  read_out(ui, "Twist", sim::has_cusp(*shape) ? "--" : fixed(base::degrees(shape->roll.twist), 2), "\u00B0",
           "Roll between the frames of the two knots. None over a cusp.");
  read_out(ui, "Longest", is_longest(session.derived, entity) ? "yes" : "no", "",
           "Add curve splits the longest segment.");
}

void cart_inspector(Ui& ui, Entity entity) {
  const edit::Session& session = ui.session();
  const world::Train* cart = session.document.entities.find<world::Train>(entity);
  if (cart != nullptr) {
    read_out(ui, "Starts on", world::label_of(session.document, cart->segment), "",
             "The segment that the train starts on.");
    read_out(ui, "Start position###Start place", fixed(cart->fraction * 100, 1), "%",
             "Fraction of that segment's length.");
  }
  const world::TrainMotion* motion = session.motion.carts.find(entity);
  if (motion == nullptr) return;
  read_out(ui, "Now on", world::label_of(session.document, motion->segment), "", "The segment that the train is on.");
  read_out(ui, "Speed", motion->speed, 2, "m/s", "Speed along the track. Negative: backwards.");
  read_out(ui, "Distance", motion->track_distance, 2, "m", "Distance from the start of the track.");
  read_out(ui, "Travelled", motion->travelled, 2, "m",
           "Distance travelled since the start. Backwards counts as negative.");
  read_out(ui, "Lap", std::to_string(motion->laps), "", "Laps completed since the start.");
  if (session.derived.order.empty()) return;
  read_out(ui, "Energy", fixed(sim::energy(session.document, session.derived, entity, *motion), 3), "J/kg",
           "v\u00B2/2 + g (y - datum).");
  read_out(ui, "Vertical g###g up",
           digits(ui, sim::felt(session.document, session.derived, entity, *motion).up, 2, "g"), "g",
           "Felt acceleration towards the rider's head.");
}

}  // namespace

void inspector_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  const Entity selected = session.settings.selected;
  const EntityName* name = session.document.entities.find<EntityName>(selected);
  if (name == nullptr) {
    heading(ui, "Nothing selected", "Click a knot, the curve or a train to select it.");
    return;
  }
  constexpr const char* kKinds[] = {"Knot", "Segment", "Train", "Section"};
  if (const std::vector<Entity> knots = world::selected_knots(session.document, session.settings); knots.size() > 1) {
    read_out(ui, "Selected", std::to_string(knots.size()) + " knots", "",
             fmt::format("Shift+click adds or removes a knot, {} draws a box.", ui.keys.shown("Box select")));
    ImGui::PushID("several");
    knots_inspector(ui, selected, knots);
    ImGui::PopID();
    return;
  }
  read_out(ui, "Selected", fmt::format("{} {}", kKinds[static_cast<std::size_t>(name->kind)], world::to_text(*name)),
           "", "The selected object. Scripts write @ before its name.");
  // Different ids for each entity: text typed in a field of one never goes to the next.
  ImGui::PushID(static_cast<int>(name->kind) * 0x1000000 + static_cast<int>(name->number));
  switch (name->kind) {
    case EntityKind::knot: knot_inspector(ui, selected, *name); break;
    case EntityKind::segment: segment_inspector(ui, selected, *name); break;
    case EntityKind::cart: cart_inspector(ui, selected); break;
    case EntityKind::section: break;
  }
  ImGui::PopID();
}

}  // namespace coaster::ui
