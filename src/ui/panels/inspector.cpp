// Inspector: the selected knot, segment or cart, in numbers.
#include <algorithm>
#include <cmath>
#include <limits>

#include <imgui.h>

#include "curve/continuity.h"
#include "ui/actions/key_map.h"
#include "ui/panels/panels.h"
#include "world/selection.h"
#include "world/topology.h"

namespace coaster::ui {
namespace {

using world::Entity;
using world::Kind;
using world::Name;

constexpr std::string_view kAxes[] = {"x", "y", "z"};

std::string at_name(Name name) { return "@" + world::to_text(name); }

// Typed numbers can be beyond float; the largest float is beyond every limit, so the command clamps it and says so.
float to_float(double value) {
  constexpr double kLargest = std::numeric_limits<float>::max();
  return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

std::array<Number, 3> components(glm::vec3 v, Number like) {
  std::array<Number, 3> result{like, like, like};
  for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(i)].value = v[i];
  return result;
}

void shape(Ui& ui, Name name, const world::Knot& knot) {
  constexpr double kReach = world::kMaxCoordinate;
  heading(ui, "Position (m)",
          "Where the track goes through: x, height y, z. Drag the knot in the viewport; Shift moves it up and down, "
          "Ctrl along the ground.");
  if (const auto c = numbers(ui, "Position", kAxes,
                             components(knot.position, {.decimals = 3, .step = 0.02, .low = -kReach, .high = kReach}),
                             "Drag, or click and type metres.")) {
    glm::vec3 to = knot.position;
    to[c->index] = to_float(c->value);
    ui.emit(edit::MoveKnot{{name}, to});
  }
  heading(ui, "Direction",
          "The unit tangent: the way of travel. A joint has one, so its two segments share their tangent line (G1).");
  if (const auto c = numbers(ui, "Direction", kAxes,
                             components(knot.tangent, {.decimals = 3, .step = 0.005, .low = -1, .high = 1}),
                             "Drag, or click and type; the direction is made a unit vector again.")) {
    glm::vec3 to = knot.tangent;
    to[c->index] = to_float(c->value);
    ui.emit(edit::SetDirection{{name}, to});
  }
  heading(ui, "Handles (m)",
          "Distances of the control points before (in) and after (out) the knot: a third of the parametric speed.");
  const Number length{.decimals = 3, .step = 0.02, .low = world::kMinHandle, .high = world::kMaxHandle};
  std::array<Number, 2> lengths{length, length};
  lengths[0].value = knot.in_length;
  lengths[1].value = knot.out_length;
  constexpr std::string_view kEnds[] = {"in", "out"};
  if (const auto c =
          numbers(ui, "Handles", kEnds, lengths, "Drag, or click and type metres. A smooth joint keeps both equal.")) {
    const float to = to_float(c->value);
    const bool both = knot.joint == world::JointKind::smooth;
    ui.emit(edit::SetLengths{
        {name}, both || c->index == 0 ? to : knot.in_length, both || c->index == 1 ? to : knot.out_length});
  }
  const Number roll{.value = world::roll_deg(knot),
                    .unit = "\u00B0",
                    .decimals = 2,
                    .step = 0.25,
                    .low = -180,
                    .high = 180,
                    .largest = 1e300};
  if (const auto to =
          number(ui, "Roll", roll, "Bank of the track here, degrees from the horizon; positive to the rider's right."))
    ui.emit(edit::SetRoll{{name}, *to});
}

void continuity(Ui& ui, Entity entity, Name name) {
  const world::Document& document = ui.session().document;
  const world::Neighbours at = world::neighbours(document, entity);
  if (!at.before.valid() || !at.after.valid()) {
    read_out(ui, "Continuity", "end of the track", "", "An end of an open track joins nothing.");
    return;
  }
  const curve::Joint joint = curve::joint(world::cubic_of(document, at.before), world::cubic_of(document, at.after));
  read_query(ui, "Geometric", "geometric", at_name(name),
             "Continuity of shape: G0 meets, G1 one tangent line, G2 one curvature too.");
  read_query(ui, "Parametric", "parametric", at_name(name),
             "Continuity of the parameter: C1 has equal first derivatives, C2 equal second ones. More than G1, G2.");
  read_query(ui, "Gap", "gap", at_name(name), "Distance between the end of one segment and the start of the next.",
             {.decimals = 3, .unit = "mm", .factor = 1e3});
  read_out(ui, "Angle", fixed(joint.angle * 180.0 / 3.14159265358979, 3), "\u00B0", "Angle between the two tangents.");
  read_out(ui, "Speed ratio", fixed(joint.speed_ratio, 3), "", "|C'(0)| / |B'(1)|: 1 for C1.");
}

void knot_inspector(Ui& ui, Entity entity, Name name) {
  const world::Knot& knot = world::knot(ui.session().document, entity);
  shape(ui, name, knot);
  if (const auto kind = combo_of(ui, "Joint", knot.joint, "How the two segments at this knot are tied together."))
    ui.emit(edit::SetJoint{{name}, *kind});
  continuity(ui, entity, name);
}

// Fields of the active knot that go to every selected one.
void knots_inspector(Ui& ui, Entity active, const std::vector<Entity>& knots) {
  const world::Document& document = ui.session().document;
  const world::Knot& knot = world::knot(document, active);
  edit::Knots all;
  for (const Entity e : knots) all.names.push_back(world::name_of(document, e));
  read_out(ui, "Active", world::label_of(document, active), "",
           "The numbers below are its; a change goes to all selected knots.");
  heading(ui, "Position (m)", "Of all selected knots at once: each keeps its other two coordinates.");
  constexpr double kReach = world::kMaxCoordinate;
  if (const auto c = numbers(ui, "Position", kAxes,
                             components(knot.position, {.decimals = 3, .step = 0.02, .low = -kReach, .high = kReach}),
                             "Give all selected knots this coordinate."))
    ui.emit(edit::Align{all, static_cast<world::Axis>(c->index), c->value});
  heading(ui, "Handles (m)", "Of all selected knots at once.");
  constexpr std::string_view kSides[] = {"in", "out"};
  const Number length{.decimals = 3, .step = 0.02, .low = world::kMinHandle, .high = world::kMaxHandle};
  std::array<Number, 2> lengths{length, length};
  lengths[0].value = knot.in_length, lengths[1].value = knot.out_length;
  if (const auto c = numbers(ui, "Handles", kSides, lengths, "Give all selected knots handles of this length."))
    ui.emit(edit::SetLengths{all, c->index == 0 ? to_float(c->value) : knot.in_length,
                             c->index == 1 ? to_float(c->value) : knot.out_length});
  const Number roll{.value = world::roll_deg(knot),
                    .unit = "\u00B0",
                    .decimals = 2,
                    .step = 0.2,
                    .low = -180,
                    .high = 180,
                    .largest = 1e6};
  if (const auto to = number(ui, "Roll", roll, "Bank of all selected knots, degrees from the horizon."))
    ui.emit(edit::SetRoll{all, *to});
  if (const auto kind = combo_of(ui, "Joint", knot.joint, "The joints of all selected knots."))
    ui.emit(edit::SetJoint{all, *kind});
}

bool is_longest(const sim::Derived& derived, Entity entity) {
  for (const Entity other : derived.order)
    if (derived.shape(other).arc.length() > derived.shape(entity).arc.length()) return false;
  return true;
}

void segment_inspector(Ui& ui, Entity entity, Name name) {
  const edit::Session& session = ui.session();
  const sim::SegmentShape* shape = session.derived.segments.find(entity);
  const Number place{
      .value = session.settings.selected_t, .decimals = 4, .step = 0.002, .low = 0, .high = 1, .largest = 1e300};
  if (const auto to = number(ui, "Place", place,
                             "The picked place: the parameter t from 0 to 1. Insert point splits the segment here."))
    ui.emit(edit::Select{{name}, *to});
  const Number turns{.value = static_cast<double>(world::segment(session.document, entity).turns),
                     .decimals = 0,
                     .step = 0.05,
                     .low = -world::kMaxTurns,
                     .high = world::kMaxTurns,
                     .largest = 1e9};
  if (const auto to =
          number(ui, "Turns", turns, "Whole turns of roll within the segment (barrel rolls), besides the least twist."))
    ui.emit(edit::SetTurns{{name}, static_cast<int>(*to)});
  if (shape == nullptr) return;
  const double t = session.settings.selected_t;
  const glm::dvec3 at = curve::point(shape->key.cubic, t);
  read_out(ui, "Length", fixed(shape->measured_length, 3), "m", "By the arc-length method chosen under Evaluation.");
  read_out(ui, "Distance there", fixed(shape->arc.distance(t), 3), "m",
           "Arc length from the segment's start to the picked place.");
  read_out(ui, "Height there", fixed(at.y, 3), "m", "Height of the picked place.");
  read_out(ui, "Curvature there", fixed(curve::curvature(shape->key.cubic, t), 5), "1/m",
           "|B' \u00D7 B''| / |B'|\u00B3 at the picked place.");
  read_out(ui, "Twist", fixed(shape->twist * 180.0 / 3.14159265358979, 2), "\u00B0",
           "Roll added between the knots' frames, spread evenly over the length.");
  read_out(ui, "Longest", is_longest(session.derived, entity) ? "yes" : "no", "",
           "Add curve splits the longest segment.");
}

void cart_inspector(Ui& ui, Entity entity, Name) {
  const edit::Session& session = ui.session();
  const world::Cart* cart = session.document.entities.find<world::Cart>(entity);
  if (cart != nullptr) {
    read_out(ui, "Starts on", world::label_of(session.document, cart->segment), "",
             "The segment that the cart starts on.");
    read_out(ui, "Start place", fixed(cart->fraction * 100, 1), "%", "Fraction of that segment's length.");
  }
  const world::CartMotion* motion = session.motion.carts.find(entity);
  if (motion == nullptr) return;
  read_out(ui, "Now on", world::label_of(session.document, motion->segment), "", "The segment that the cart is on.");
  read_out(ui, "Speed", fixed(motion->speed, 2), "m/s", "Along the track; negative backwards.");
  read_out(ui, "Distance", fixed(motion->track_distance, 2), "m", "From the start of the track.");
  read_out(ui, "Travelled", fixed(motion->travelled, 2), "m", "Since the start, backwards counting negative.");
  read_out(ui, "Lap", std::to_string(motion->laps), "", "Whole rounds since the start.");
  if (session.derived.order.empty()) return;
  read_out(ui, "Energy", fixed(sim::energy(session.document, session.derived, entity, *motion), 3), "J/kg",
           "v\u00B2/2 + g (y - datum).");
  read_out(ui, "g up", fixed(sim::felt(session.document, session.derived, entity, *motion).up, 2), "g",
           "Felt acceleration towards the rider's head.");
}

}  // namespace

void inspector_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  const Entity selected = session.settings.selected;
  const Name* name = session.document.entities.find<Name>(selected);
  if (name == nullptr) {
    heading(ui, "Nothing selected", "Click a knot, the curve or a cart to select it.");
    return;
  }
  constexpr const char* kKinds[] = {"Knot", "Segment", "Cart"};
  if (const std::vector<Entity> knots = world::selected_knots(session.document, session.settings); knots.size() > 1) {
    read_out(ui, "Selected", std::to_string(knots.size()) + " knots", "",
             "Shift+click adds and takes away, " + ui.keys.shown("Box select") + " draws a box.");
    ImGui::PushID("several");
    knots_inspector(ui, selected, knots);
    ImGui::PopID();
    return;
  }
  read_out(ui, "Selected", std::string(kKinds[static_cast<std::size_t>(name->kind)]) + " " + world::to_text(*name), "",
           "What the fields below are about; scripts write @ before the name.");
  // Fields of another entity are other fields: what is typed in one never lands in the next.
  ImGui::PushID(static_cast<int>(name->kind) * 0x1000000 + static_cast<int>(name->number));
  switch (name->kind) {
    case Kind::knot: knot_inspector(ui, selected, *name); break;
    case Kind::segment: segment_inspector(ui, selected, *name); break;
    case Kind::cart: cart_inspector(ui, selected, *name); break;
  }
  ImGui::PopID();
}

}  // namespace coaster::ui
