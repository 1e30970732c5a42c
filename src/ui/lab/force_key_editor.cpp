#include "ui/lab/force_key_editor.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "edit/commands/commands_force_sections.h"
#include "edit/commands/commands_session.h"
#include "sim/plan/force_plan.h"
#include "ui/context/ui.h"
#include "ui/lab/page_widgets.h"
#include "ui/plots/plot.h"
#include "ui/widgets/theme.h"
#include "world/force_program.h"
#include "world/panel_settings.h"
#include "world/sections.h"

namespace coaster::ui {
namespace {

using world::Entity;
using world::ForceChannel;
using world::ForceDomain;
using world::ForceKey;
using world::ForceProgram;

constexpr std::uint32_t kForceColour = 0xFF8A1F, kActualColour = 0x4C9AFF, kFeltColour = 0xB58CFF,
                        kRampColour = 0x39424D;

// Beyond the end of a path that stopped early: metres per unit of the axis.
double rate_beyond(const sim::ForcePlan& plan) {
  return plan.task.program.over == ForceDomain::distance ? 1.0 : std::max(1.0, plan.end_speed);
}

// Converts between a program's axis (m or s from the section's start) and the track's (m).
struct ForceAxes {
  const sim::ForcePlan& plan;
  ForceChannel channel;
  std::size_t first;  // index of the section's first segment
  double start;       // m along the track, where the section begins
  const ForceProgram& program() const { return plan.task.program; }
  const std::vector<ForceKey>& keys() const { return program().keys(channel); }
  bool of_curvature() const { return program().of == world::ForceQuantity::curvature; }
  // Returns the value of the ride that is felt where the channel's keys act; nothing for roll.
  std::optional<sim::RideValue> felt() const;
  double x_of(double at) const;
  double at_of(double x) const;
  // Returns the length of a key's handle on that side; 0 if there is no key.
  double reach(std::size_t key, int side) const;
  // m or s: where the keys end, or the track, if its held end is farther.
  double end() const { return std::max(program().length, plan.path.points.back().at); }
};

double ForceAxes::x_of(double at) const {
  const double last = plan.path.points.back().at;
  const auto length = [&](std::size_t i) { return plan.path.curve.points[i].s; };
  return start + sim::between_points(plan, at, length) + std::max(0.0, at - last) * rate_beyond(plan);
}

double ForceAxes::at_of(double x) const {
  const std::vector<sim::ElementPoint>& curve = plan.path.curve.points;
  const std::vector<sim::ForcePoint>& points = plan.path.points;
  const double s = x - start;
  if (s >= curve.back().s) return points.back().at + (s - curve.back().s) / rate_beyond(plan);
  const auto next = std::upper_bound(curve.begin(), curve.end(), s,
                                     [](double one, const sim::ElementPoint& point) { return one < point.s; });
  if (next == curve.begin()) return 0;
  const auto i = static_cast<std::size_t>(next - curve.begin()) - 1;
  const double gap = curve[i + 1].s - curve[i].s, part = gap > 0 ? (s - curve[i].s) / gap : 0.0;
  return points[i].at + part * (points[i + 1].at - points[i].at);
}

double ForceAxes::reach(std::size_t key, int side) const {
  const std::vector<ForceKey>& all = keys();
  if (side < 0 ? key == 0 : key + 1 >= all.size()) return 0;
  const double gap = std::abs(all[side < 0 ? key - 1 : key + 1].at - all[key].at);
  const double own = side < 0 ? all[key].before : all[key].after;
  return own > 0 ? own : gap / 3;
}

// Fills the positions and values of the target curve, and of the actual curve unless it comes from the ride.
void fill_curves(const sim::DerivedTrack& derived, const ForceAxes& axes, ForceKeyEditing& state) {
  state.place.clear(), state.asked.clear(), state.actual.clear();
  const sim::ForcePlan& plan = axes.plan;
  const auto channel = static_cast<std::size_t>(axes.channel);
  for (std::size_t i = 0; i < plan.path.points.size(); ++i) {
    state.place.push_back(axes.start + plan.path.curve.points[i].s);
    state.asked.push_back(plan.path.points[i].asked(axes.channel));
    if (axes.of_curvature()) {
      state.actual.push_back(sim::curvature_at(derived, axes.first, state.place.back())[channel]);
      continue;
    }
    if (axes.channel != ForceChannel::roll) continue;
    const sim::TrackPlace place = sim::place_at(derived, state.place.back());
    const double spin = base::degrees(derived.shape_at(place.index).roll.spin(place.s));
    const bool metres = axes.program().over == ForceDomain::distance;
    state.actual.push_back(metres ? spin : spin * std::sqrt(std::max(0.0, plan.path.points[i].square)));
  }
}

std::optional<sim::RideValue> ForceAxes::felt() const {
  if (channel == ForceChannel::roll) return std::nullopt;
  return channel == ForceChannel::vertical ? sim::RideValue::vertical : sim::RideValue::lateral;
}

// A range that grows by values, and ends at whole steps beyond them.
struct PlotRange {
  double low, high, step;
  void take(double value) {
    if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
  }
  double bottom() const { return std::floor(low / step) * step - step; }
  double top() const { return std::ceil(high / step) * step + step; }
};

PlotRange least_range(const ForceAxes& axes) {
  if (!axes.felt()) return axes.of_curvature() ? PlotRange{-10, 10, 10} : PlotRange{-5, 5, 5};
  return axes.of_curvature() ? PlotRange{-0.01, 0.01, 0.01} : PlotRange{-0.5, 2, 0.5};
}

// Returns the ends of the axes: the section with a margin, the range of target and actual values, and at the right edge
// that of g felt where keys are curvature.
ForcePlotRanges shown_ends(const ForceAxes& axes, const std::optional<RidePlots>& ride, const ForceKeyEditing& state) {
  constexpr double kMargin = 0.05;
  const double from = axes.start, to = axes.x_of(axes.end()), margin = kMargin * (to - from);
  PlotRange own = least_range(axes), felt{-0.5, 2, 0.5};
  for (const double value : state.asked) own.take(value);
  for (const double value : state.actual) own.take(value);
  for (const ForceKey& key : axes.keys()) own.take(key.value);
  if (ride && axes.felt()) {
    const sim::SeatCurves& curves = ride->study().curves;
    const auto v = static_cast<std::size_t>(*axes.felt());
    for (std::size_t i = 0; i < curves.place.size(); ++i)
      if (curves.place[i] > from && curves.place[i] < to) (axes.of_curvature() ? felt : own).take(curves.least[v][i]);
  }
  return {from - margin, to + margin, own.bottom(), own.top(), felt.bottom(), felt.top()};
}

// Returns the limits of g within the plot, for the shortest overloads that count and for lasting ones, at their heights
// on the channel's axis.
std::vector<LevelLine> shown_limits(const sim::ForceLimitCurves& envelope, const ForceAxes& axes,
                                    const ForcePlotRanges& ends) {
  using sim::ForceAxis;
  constexpr double kLasting = 10;  // s
  std::vector<LevelLine> levels;
  const auto add = [&](ForceAxis axis, double sign) {
    for (const double seconds : {envelope.shortest, kLasting}) {
      double y = sign * sim::limit(envelope.curves[static_cast<std::size_t>(axis)], seconds);
      if (axes.of_curvature())
        y = ends.low + (y - ends.felt_low) / (ends.felt_high - ends.felt_low) * (ends.high - ends.low);
      if (y >= ends.low && y <= ends.high)
        levels.push_back({fmt::format("limit, {} s", base::to_text(seconds)), y, 0xE5534B});
    }
  };
  if (axes.channel == ForceChannel::vertical) add(ForceAxis::down, 1), add(ForceAxis::lift, -1);
  if (axes.channel == ForceChannel::lateral) add(ForceAxis::side, 1), add(ForceAxis::side, -1);
  return levels;
}

// Returns the value rounded to a multiple of the step.
double to_step(double value, double step) {
  const double per_one = std::round(1 / step);
  return per_one >= 1 ? std::round(value * per_one) / per_one : std::round(value / step) * step;
}

void copy_from(Ui& ui, const ForceKeyEditing& state, const std::vector<world::ForceKey>& keys, bool all) {
  edit::CopyForceKeys copy{{state.section}, state.channel};
  if (!all) copy.from = copy.to = keys[*state.key].at;
  ui.emit(copy);
}

void paste_into(Ui& ui, ForceKeyEditing& state, const world::ForceProgram& program) {
  const std::vector<world::ForceKey>& keys = program.keys(state.channel);
  double at = 0;
  if (state.key) {
    const double next = *state.key + 1 < keys.size() ? keys[*state.key + 1].at : program.length;
    at = to_step((keys[*state.key].at + next) / 2, steps_of(program, state.channel).at);
  }
  state.inserted = at;
  ui.out.wants_paste = true, ui.out.keys_to = ForceKeyPlace{state.section, state.channel, at};
}

// Handles a key press. Ctrl+C copies the selected key, Ctrl+Shift+C all keys of the channel. Ctrl+V pastes behind the
// selected key, half-way to the next one, or without one at the section's start; if sections were copied, it pastes
// those. Returns true if the press was one of these.
bool copy_or_paste(Ui& ui, ForceKeyEditing& state, const world::ForceProgram& program,
                   const platform::KeyPress& press) {
  const bool all = press.modifiers.shift;
  if (!press.modifiers.ctrl || press.modifiers.alt) return false;
  const std::vector<world::ForceKey>& keys = program.keys(state.channel);
  if (press.key == platform::Key::c && (all ? !keys.empty() : state.key.has_value()))
    return copy_from(ui, state, keys, all), true;
  if (press.key == platform::Key::v && !all) return paste_into(ui, state, program), true;
  return false;
}

const ForceProgram& program_of(const Ui& ui, Entity section) {
  return world::section(ui.session().document, section).force;
}

// Returns the force section that is selected alone in Build; none elsewhere.
Entity selected_forces(const Ui& ui) {
  const edit::Session& session = ui.session();
  const world::Panels& shown = *session.settings.panels;
  const auto* const section = session.document.entities.find<world::Section>(session.settings.selected);
  const bool build = shown.workspace == world::Workspace::build && shown.show_panels && session.settings.also.empty();
  return build && section && section->kind == world::SectionKind::force ? session.settings.selected : world::kNone;
}

// The state of the graph; another section starts with a fresh one.
ForceKeyEditing& state_of(Ui& ui, Entity section) {
  ForceKeyEditing& state = ui.lab.keys;
  const world::EntityName name = world::name_of(ui.session().document, section);
  if (state.section != name) state = {.section = name, .channel = state.channel};
  const std::vector<ForceKey>& keys = program_of(ui, section).keys(state.channel);
  if (state.key && *state.key >= keys.size()) state.key.reset();
  for (std::size_t i = 0; state.inserted && i < keys.size(); ++i)
    if (keys[i].at == *state.inserted) state.key = i, state.inserted.reset();
  if (state.gesture && !ui.session().history.in_gesture) state.gesture = false, state.undone = true;
  return state;
}

// Returns the position, limited to the section and the neighbouring keys.
double between_neighbours(const ForceProgram& program, ForceChannel channel, std::size_t key, double at) {
  const std::vector<ForceKey>& keys = program.keys(channel);
  const double gap = world::key_gap_of(program.over);
  const double low = key > 0 ? keys[key - 1].at + gap : 0.0;
  const double high = key + 1 < keys.size() ? keys[key + 1].at - gap : program.length;
  return low <= high ? std::clamp(at, low, high) : keys[key].at;
}

void move_key(Ui& ui, ForceKeyEditing& state, const ForceProgram& program, double from, double to, double value,
              bool from_start) {
  const double limit = world::channel_of(program.of, state.channel).limit;
  to = between_neighbours(program, state.channel, *state.key, to), value = std::clamp(value, -limit, limit);
  const ForceKey& now = program.keys(state.channel)[*state.key];
  if (now.at == to && now.value == value) return;
  ui.emit(edit::MoveForceKey{{state.section}, from_start, state.channel, from, to, value});
}

// Without a value, the key is on the curve.
void insert_key(Ui& ui, ForceKeyEditing& state, const ForceProgram& program, double at, std::optional<double> value) {
  const std::vector<ForceKey>& keys = program.keys(state.channel);
  const double gap = world::key_gap_of(program.over);
  const auto near = [&](const ForceKey& key) { return std::abs(key.at - at) < gap; };
  if (at < 0 || at > program.length) return;
  if (std::any_of(keys.begin(), keys.end(), near))
    return ui.warn(fmt::format("Keys are at least {} {} apart.", gap, world::unit_of(program.over)));
  state.inserted = at;
  if (value) ui.emit(edit::SetForceKey{{state.section}, false, state.channel, *value, at});
  else ui.emit(edit::InsertForceKey{{state.section}, state.channel, at});
}

void begin_gesture(Ui& ui, ForceKeyEditing& state) {
  if (!std::exchange(state.gesture, true)) ui.emit(edit::BeginGesture{});
}

void drag_key(Ui& ui, ForceKeyEditing& state, const ForceAxes& axes, PlotDrag to) {
  const ForceProgram& program = axes.program();
  const bool snaps = !ImGui::GetIO().KeyCtrl;
  const world::KeySteps steps = steps_of(program, state.channel);
  const double at = axes.at_of(to.x);
  begin_gesture(ui, state);
  if (state.side == 0)
    return move_key(ui, state, program, state.from.at, snaps ? to_step(at, steps.at) : at,
                    snaps ? to_step(to.y, steps.value) : to.y, true);
  const ForceKey& from = state.from;
  const double reach = std::max(state.side * (at - from.at), 0.1 * world::key_gap_of(program.over));
  const double value = snaps ? to_step(to.y, steps.value) : to.y;
  ForceKey next = program.keys(state.channel)[*state.key];
  (state.side < 0 ? next.before : next.after) = reach;
  next.slope = std::clamp((value - from.value) / (state.side * reach), -world::kMostForceSlope, world::kMostForceSlope);
  if (next != program.keys(state.channel)[*state.key])
    ui.emit(edit::ShapeForceKey{{state.section}, true, state.channel, from.at, next.slope, next.before, next.after});
}

// The knobs: all keys, then the handles of the selected one.
struct Knobs {
  std::vector<Knob> list;
  std::vector<int> sides;                    // for the knobs after the keys
  std::vector<std::array<double, 4>> lines;  // x, x, y, y: the line of a handle
};
Knobs knobs_of(const ForceAxes& axes, const ForceKeyEditing& state) {
  const ForceProgram& program = axes.program();
  const std::vector<ForceKey>& keys = program.keys(state.channel);
  const std::string unit(world::unit_of(program.over)), of(world::unit_of(program, state.channel));
  Knobs knobs;
  for (std::size_t i = 0; i < keys.size(); ++i)
    knobs.list.push_back({.x = axes.x_of(keys[i].at),
                          .y = keys[i].value,
                          .colour = kForceColour,
                          .chosen = state.key == i,
                          .value = fmt::format("{:.6g} {} at {:.6g} {}", keys[i].value, of, keys[i].at, unit)});
  if (!state.key) return knobs;
  const ForceKey& key = keys[*state.key];
  for (const int side : {-1, 1}) {
    const double reach = axes.reach(*state.key, side);
    if (reach <= 0) continue;
    const double x = axes.x_of(key.at + side * reach), y = key.value + side * reach * key.slope;
    knobs.list.push_back(
        {.x = x, .y = y, .colour = kForceColour, .small = true, .value = side < 0 ? "before" : "after"});
    knobs.sides.push_back(side);
    knobs.lines.push_back({axes.x_of(key.at), x, key.value, y});
  }
  return knobs;
}

void take_knob(ForceKeyEditing& state, const ForceProgram& program, const Knobs& knobs, std::size_t held) {
  const std::vector<ForceKey>& keys = program.keys(state.channel);
  state.side = held < keys.size() ? 0 : knobs.sides[held - keys.size()];
  if (state.side == 0) state.key = held;
  state.from = keys[*state.key];
}

// Handles the mouse.
void follow_mouse(Ui& ui, ForceKeyEditing& state, const ForceAxes& axes, const Knobs& knobs, const KnobTouch& touch) {
  const ForceProgram& program = axes.program();
  const auto undoes = [](const edit::Command& c) { return c.is<edit::Undo>() || c.is<edit::CancelGesture>(); };
  if (state.gesture && std::any_of(ui.out.commands.begin(), ui.out.commands.end(), undoes))
    state.gesture = false, state.undone = true;
  if (touch.held && touch.pressed) take_knob(state, program, knobs, *touch.held), state.undone = false;
  if (touch.held && touch.moved && state.key && !state.undone) drag_key(ui, state, axes, touch.at);
  if (touch.released && std::exchange(state.gesture, false)) ui.emit(edit::EndGesture{});
  if (!touch.twice || touch.over) return;
  const world::KeySteps steps = steps_of(program, state.channel);
  insert_key(ui, state, program, to_step(axes.at_of(touch.at.x), steps.at), to_step(touch.at.y, steps.value));
}

// Returns true if the key press changed the selected key.
bool work_key(Ui& ui, ForceKeyEditing& state, const ForceProgram& program, const platform::KeyPress& press) {
  using platform::Key;
  const std::vector<ForceKey>& keys = program.keys(state.channel);
  const ForceKey key = keys[*state.key];
  world::KeySteps steps = steps_of(program, state.channel);
  if (press.modifiers.ctrl) steps = {steps.at / 10, steps.value / 10};
  const auto move = [&](double along, double up) {
    move_key(ui, state, program, key.at, to_step(key.at + along * steps.at, steps.at),
             to_step(key.value + up * steps.value, steps.value), false);
    return true;
  };
  switch (press.key) {
    case Key::left: return move(-1, 0);
    case Key::right: return move(1, 0);
    case Key::up: return move(0, 1);
    case Key::down: return move(0, -1);
    case Key::escape: return state.key.reset(), true;
    case Key::del: ui.emit(edit::RemoveForceKey{{state.section}, false, state.channel, key.at}); return true;
    case Key::insert: {
      const double next = *state.key + 1 < keys.size() ? keys[*state.key + 1].at : program.length;
      const double middle = (key.at + next) / 2, round = to_step(middle, steps.at);
      const bool far = std::min(round - key.at, next - round) >= world::key_gap_of(program.over);
      insert_key(ui, state, program, far ? round : middle, {});
      return true;
    }
    default: return false;
  }
}

}  // namespace

Entity edited_forces(const Ui& ui) {
  return ui.drawers.graph.open && !ui.drawers.table ? selected_forces(ui) : world::kNone;
}

void force_channels(Ui& ui, Entity section, float bar) {
  ForceKeyEditing& state = state_of(ui, section);
  const TabBar look{.height = bar, .pad = std::floor(12 * ui.scale) / 2, .rgb = ink(kForceColour), .least_line = 1};
  const auto rows = world::channels_of(program_of(ui, section).of);
  for (const world::ForceChannelRow& row : rows) {
    const auto channel = static_cast<ForceChannel>(&row - rows.data());
    const std::string help = fmt::format("{} Shows and edits these keys.", row.help);
    if (tab(ui, fmt::format("Keys/{}", row.label), help, channel == state.channel, look))
      state.channel = channel, state.key.reset();
  }
}

void force_plot(Ui& ui, Entity section, const std::optional<RidePlots>& ride) {
  ForceKeyEditing& state = state_of(ui, section);
  const sim::ForcePlan* const plan = ui.find.force(section);
  if (plan == nullptr || plan->path.points.empty())
    return small_note(plan == nullptr || plan->refusal.empty() ? "The section has no track."
                                                               : base::sentence(plan->refusal));
  const std::size_t first = world::run_of(ui.session().document, section).first;
  const ForceAxes axes{*plan, state.channel, first, ui.session().derived.starts[first]};
  fill_curves(ui.session().derived, axes, state);
  const ForcePlotRanges ends = state.gesture ? state.axes : shown_ends(axes, ride, state);
  std::vector<Series> series, felt;
  if (!state.actual.empty()) series.push_back({"actual", state.place, state.actual, kActualColour});
  if (ride && axes.felt())
    ride->add_curves(*axes.felt(), axes.of_curvature() ? "felt" : "actual", axes.of_curvature() ? felt : series);
  if (!series.empty()) series.front().width = 4;  // visible on both sides of the target curve
  series.push_back({"asked", state.place, state.asked, kForceColour, SeriesKind::line, 1.6f});
  const Knobs knobs = knobs_of(axes, state);
  for (const std::array<double, 4>& line : knobs.lines)
    series.push_back({"", {line.data(), 2}, {line.data() + 2, 2}, kForceColour, SeriesKind::line, 1.0f});
  const std::array ramp{axes.start, axes.x_of(plan->path.ramp)}, bottom{ends.low, ends.low}, top{ends.high, ends.high};
  if (plan->path.ramp > 0) series.push_back({"ramp", ramp, bottom, kRampColour, SeriesKind::line, 1.0f, top});
  const std::array nowhere{std::numeric_limits<double>::quiet_NaN()};  // the legend of the right axis
  if (!felt.empty()) series.push_back({"felt", {ramp.data(), 1}, nowhere, kFeltColour});
  const std::vector<LevelLine> levels = shown_limits(edit::force_limits(ui.session()), axes, ends);
  const std::string_view label = world::kForceChannels[static_cast<std::size_t>(state.channel)].label;
  KnobTouch touch;
  Plot picture{
      .x = {.unit = "m", .low = ends.from, .high = ends.to},
      .y = {.unit = std::string(world::unit_of(axes.program(), state.channel)), .low = ends.low, .high = ends.high},
      .series = series,
      .levels = levels,
      .knobs = knobs.list,
      .touch = &touch,
      .value = fmt::format("{} {}", label, state.key ? fmt::format("key {}", *state.key + 1) : "no key"),
      .labels = small_size("-0.0").x};
  if (!felt.empty()) {
    felt.front().colour = kFeltColour;
    picture.right = {.title = "g", .low = ends.felt_low, .high = ends.felt_high};
    picture.right_series = felt;
  }
  constexpr std::string_view kHelp =
      "What the keys of the selected section ask for, over what riders feel or the track has. Drag a key or a handle; "
      "Ctrl does not snap. Double-click to insert a key, Delete removes it. Tab chooses keys, arrows move them.";
  if (ride) ride->show(ui, "Plot", picture, kHelp);
  else (void)plot(ui, "Plot", picture, kHelp);
  state.axes = ends;
  follow_mouse(ui, state, axes, knobs, touch);
}

platform::Events without_force_keys(Ui& ui, const platform::Events& events) {
  const Entity section = selected_forces(ui);
  if (!section.valid()) return events;
  ForceKeyEditing& state = state_of(ui, section);
  const ForceProgram& program = program_of(ui, section);
  const std::size_t count = program.keys(state.channel).size();
  platform::Events others;
  for (const platform::Event& event : events) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    const bool tab = press != nullptr && press->key == platform::Key::tab && !press->modifiers.ctrl;
    const bool ours = press != nullptr && press->down && !state.gesture && (tab || edited_forces(ui).valid());
    if (ours && tab) {
      ui.drawers.graph.wanted = true, ui.drawers.table = false;
      if (count == 0) ui.warn("This channel has no keys. Double-click the graph to insert one.");
      const std::size_t now = state.key.value_or(press->modifiers.shift ? 0 : count - 1);
      if (count > 0) state.key = (now + (press->modifiers.shift ? count - 1 : 1)) % count;
    } else if (ours && copy_or_paste(ui, state, program, *press)) {
      continue;
    } else if (!ours || !state.key || !work_key(ui, state, program, *press)) {
      others.push_back(event);
    }
  }
  return others;
}

}  // namespace coaster::ui
