#include "ui/tools/transform_tool.h"

#include <imgui.h>

#include <cmath>
#include <variant>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "base/units.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_shape.h"
#include "sim/ground/land.h"
#include "ui/tools/selecting.h"
#include "ui/widgets/theme.h"
#include "view/pick.h"
#include "world/selection.h"

namespace coaster::ui {
namespace {

using glm::dvec2;
using glm::dvec3;

dvec3 unit(int axis) {
  dvec3 v(0);
  v[axis] = 1;
  return v;
}

// Returns the point nearest to the ray on the line through `pivot` along an axis.
std::optional<dvec3> meet_axis(const view::Ray& ray, dvec3 pivot, int axis) {
  const dvec3 a = unit(axis), d(ray.direction), off = dvec3(ray.origin) - pivot;
  const double cosine = glm::dot(a, d), sine2 = 1 - cosine * cosine;
  constexpr double kAlong = 1e-4;  // squared sine of the angle between axis and ray
  if (sine2 < kAlong) return std::nullopt;
  const double t = (glm::dot(off, a) - glm::dot(off, d) * cosine) / sine2;
  return std::abs(t) < world::kMaxCoordinate ? std::optional(pivot + t * a) : std::nullopt;
}

std::string snap_words(const Ui& ui, TransformKind kind, world::SnapTo to) {
  const world::Snapping& snapping = ui.session().settings.snapping;
  if (to == world::SnapTo::off) return "Snap: off";
  if (kind == TransformKind::rotate) return fmt::format("Snap: {}\u00B0", base::to_text(snapping.angle));
  if (kind == TransformKind::scale) return "Snap: 0.1";
  if (to == world::SnapTo::grid) return in_units(ui, fmt::format("Snap: grid {} m", base::to_text(snapping.step)));
  return to == world::SnapTo::knots ? "Snap: knots" : "Snap: ground";
}

using platform::Key;
using CKind = Constraint::Kind;

constexpr std::array<const char*, 3> kAxisNames{"X", "Y", "Z"}, kPlanes{"YZ", "XZ", "XY"};
constexpr std::size_t kMostTyped = 16;

// Returns the character that a key types into a number, 0 for none.
char digit_of(Key key) {
  const int code = static_cast<int>(key);
  if (code >= static_cast<int>(Key::d0) && code <= static_cast<int>(Key::d0) + 9)
    return static_cast<char>('0' + code - static_cast<int>(Key::d0));
  if (key == Key::period) return '.';
  if (key == Key::comma) return ',';  // rejected with the reason: ignored, 7,25 would become 725
  if (key == Key::minus) return '-';
  return 0;
}

// Returns the character that a text adds to a number, 0 for none: `of_key` for digits of other scripts.
char number_part(const std::string& text, char of_key) {
  if (text.size() == 1) return std::string_view("0123456789.,-").find(text[0]) == std::string_view::npos ? 0 : text[0];
  return of_key >= '0' ? of_key : 0;
}

// Ctrl inverts snapping: on becomes off, off becomes the grid.
world::SnapTo snap_now(const world::Settings& settings) {
  if (!ImGui::GetIO().KeyCtrl) return settings.snapping.to;
  return settings.snapping.to == world::SnapTo::off ? world::SnapTo::grid : world::SnapTo::off;
}

// Returns the axis of a rotation: that of the constraint, or the line of sight.
glm::vec3 rotation_axis(const view::View& view, const Constraint& constraint) {
  return constraint.kind == Constraint::Kind::free ? view::line_of_sight(view) : glm::vec3(unit(constraint.axis));
}

double rounded_to(double value, double step) { return std::round(value / step) * step; }

}  // namespace

std::optional<dvec3> meet(const view::View& view, glm::vec2 pixel, glm::vec3 pivot, const Constraint& constraint) {
  const view::Ray ray = view::ray_through(view, pixel);
  if (constraint.kind == Constraint::Kind::axis) return meet_axis(ray, dvec3(pivot), constraint.axis);
  const glm::vec3 normal(constraint.kind == Constraint::Kind::plane ? unit(constraint.axis)
                                                                    : dvec3(view::line_of_sight(view)));
  const auto hit = view::meet_plane(ray, pivot, normal);
  return hit ? std::optional(dvec3(*hit)) : std::nullopt;
}

double turned_angle(const view::View& view, glm::vec2 from, glm::vec2 to, glm::vec3 pivot, glm::vec3 axis) {
  const auto middle = view::project(view, pivot);
  if (!middle) return 0;
  const dvec2 a = dvec2(from) - dvec2(middle->x, middle->y), b = dvec2(to) - dvec2(middle->x, middle->y);
  if (!(glm::length(a) > 1) || !(glm::length(b) > 1)) return 0;
  // Pixels grow downwards: turning clockwise on the screen is right-handed about what points away from the eye.
  const double clockwise = std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b));
  return glm::dot(dvec3(axis), dvec3(view::line_of_sight(view))) >= 0 ? clockwise : -clockwise;
}

dvec3 snapped(const SnapScene& scene, world::SnapTo to, dvec3 position, dvec3 start, const Constraint& constraint) {
  dvec3 wanted = position;
  switch (to) {
    case world::SnapTo::off: break;
    case world::SnapTo::grid:
      for (int i = 0; i < 3; ++i)
        wanted[i] = std::round(position[i] / scene.settings.snapping.step) * scene.settings.snapping.step;
      break;
    case world::SnapTo::knots: {
      double least = 12.0 * static_cast<double>(view::mark_scale(scene.settings, scene.view));
      for (const world::Entity e : scene.document.track.knots) {
        if (world::is_selected(scene.settings, e)) continue;
        const glm::vec3 at = world::knot(scene.document, e).position;
        const auto seen = view::project(scene.view, at);
        if (!seen || std::abs(seen->z) > 1) continue;
        const double distance = glm::length(glm::vec2(seen->x, seen->y) - scene.cursor);
        if (distance < least) least = distance, wanted = dvec3(at);
      }
      break;
    }
    case world::SnapTo::ground: {
      const sim::Land land(scene.document.park);
      const view::Ray ray = view::ray_through(scene.view, scene.cursor);
      if (constraint.kind == Constraint::Kind::free)
        if (const auto hit = land.plain() ? view::meet_plane(ray, glm::vec3(0), {0, 1, 0}) : view::meet_land(ray, land))
          wanted = dvec3(*hit);
      wanted.y = land.surface(wanted.x, wanted.z);
      break;
    }
  }
  for (int i = 0; i < 3; ++i)
    if (!constraint.allows(i)) wanted[i] = start[i];
  return wanted;
}

void draw_snap_label(Ui& ui, TransformKind kind, world::SnapTo to) {
  const std::string words = snap_words(ui, kind, to);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const float off = std::floor(16 * ui.scale), pad = std::floor(4 * ui.scale);
  ImGui::SetNextWindowPos({std::floor(mouse.x) + off, std::floor(mouse.y) + off});
  ImGui::SetNextWindowBgAlpha(0.85f);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad, pad));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  constexpr ImGuiWindowFlags kPassive = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoInputs |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                        ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("##snapping", nullptr, kPassive)) {
    ui.panel = "Cursor";
    ImGui::PushFont(small_font());
    tinted_line(words, to == world::SnapTo::off ? palette().dim : palette().accent);
    ImGui::PopFont();
    note_item(ui, "Snapping", "label", "", true, words);
    ui.panel.clear();
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

void TransformTool::begin(Ui& ui, TransformKind kind, Constraint constraint, std::optional<int> button) {
  const edit::Session& session = ui.session();
  const std::vector<world::Entity> knots = world::selected_knots(session.document, session.settings);
  if (knots.empty()) return;
  *this = {};
  active_ = true;
  length_ = base::shown_in(ui.units, "m");
  kind_ = kind, constraint_ = constraint, button_ = button;
  knots_ = edit::Knots(names_of(session.document, knots));
  pivot_ = world::middle_of(session.document, knots);
  active_start_ = world::knot(session.document, knots.back()).position;
  start_ = last_ = mouse_position();
}

std::size_t TransformTool::fields() const {
  if (kind_ == TransformKind::rotate) return 1;
  if (kind_ == TransformKind::scale && constraint_.kind == CKind::free) return 1;
  return constraint_.kind == CKind::axis ? 1 : constraint_.kind == CKind::plane ? 2 : 3;
}

std::optional<double> TransformTool::typed(std::size_t field) const {
  const base::Result<double> value = base::evaluate(text_[field]);
  if (!value) return std::nullopt;
  return kind_ == TransformKind::move ? base::metric_value(*value, length_) : *value;
}
std::string TransformTool::mistyped() const {
  for (std::size_t field = 0; field < fields(); ++field) {
    if (text_[field].empty()) continue;
    const base::Result<double> value = base::evaluate(text_[field]);
    if (!value) return fmt::format("{} is not a number: {}.", base::quoted_start(text_[field]), value.status().message);
  }
  return {};
}
bool TransformTool::any_typed() const { return typed(0) || typed(1) || typed(2); }

void TransformTool::take_keys(const platform::Events& events) {
  for (const platform::Event& event : events) {
    const auto* const press = std::get_if<platform::KeyPress>(&event);
    const auto* const input = std::get_if<platform::TextInput>(&event);
    if (active_ && input != nullptr && of_keyboard_) type(number_part(input->utf8, digit_of(*of_keyboard_)));
    if (press != nullptr && press->down)
      of_keyboard_ = press->place == Key::unknown ? std::nullopt : std::optional(press->key);
    if (!active_ || press == nullptr || !press->down || press->modifiers.ctrl || press->modifiers.alt) continue;
    if (press->key >= Key::x && press->key <= Key::z) {
      const Constraint next{press->modifiers.shift ? CKind::plane : CKind::axis,
                            static_cast<int>(press->key) - static_cast<int>(Key::x)};
      constraint_ = next == constraint_ ? Constraint{} : next;  // the same key again: no constraint
      field_ = 0, angle_ = 0, last_ = start_;
    } else if (press->key == Key::g || press->key == Key::r || press->key == Key::s) {
      kind_ = press->key == Key::g   ? TransformKind::move
              : press->key == Key::r ? TransformKind::rotate
                                     : TransformKind::scale;
      text_ = {}, field_ = 0, angle_ = 0, last_ = start_;
    } else if (press->key == Key::enter || press->key == Key::keypad_enter) {
      begun_ = true;  // the numbers count even if the mouse has not moved
      button_.reset();
      entered_ = true;
    } else if (press->key == Key::tab) {
      field_ = (field_ + 1) % fields();
    } else if (press->key == Key::backspace) {
      if (std::string& text = text_[field_]; !text.empty()) text.pop_back();
    } else if (!of_keyboard_) {
      type(digit_of(press->key));
    }
  }
}

void TransformTool::type(char c) {
  std::string& text = text_[field_];
  if (c == 0 || text.size() >= kMostTyped) return;
  if (c == '-') text = text.starts_with('-') ? text.substr(1) : "-" + text;
  else if (c != '.' || text.find('.') == std::string::npos) text += c;
}

glm::vec3 TransformTool::movement(const Ui& ui, const view::View& view) {
  if (any_typed()) {
    glm::vec3 by(0);
    std::size_t field = 0;
    for (int i = 0; i < 3; ++i)
      if (constraint_.allows(i)) by[i] = static_cast<float>(typed(field++).value_or(0));
    return by;
  }
  const edit::Session& session = ui.session();
  const auto from = meet(view, start_, pivot_, constraint_), to = meet(view, mouse_position(), pivot_, constraint_);
  if (!from || !to) return glm::vec3(0);
  const glm::dvec3 start(active_start_), wanted = start + (*to - *from);
  const SnapScene scene{session.document, session.settings, view, mouse_position()};
  return glm::vec3(snapped(scene, snap_now(session.settings), wanted, start, constraint_) - start);
}

edit::Command TransformTool::command(const Ui& ui, const view::View& view) {
  const world::Settings& settings = ui.session().settings;
  const glm::vec2 mouse = mouse_position();
  const auto axis_index = static_cast<std::size_t>(constraint_.axis);
  const std::string along = constraint_.kind == CKind::axis    ? fmt::format(" along {}", kAxisNames[axis_index])
                            : constraint_.kind == CKind::plane ? fmt::format(" in {}", kPlanes[axis_index])
                                                               : "";
  if (kind_ == TransformKind::move) {
    const glm::vec3 by = movement(ui, view);
    shown_ = fmt::format("Move{}:", along);
    for (int i = 0; i < 3; ++i)
      if (constraint_.allows(i)) shown_ += " " + digits(ui, by[i], 3, "m");
    shown_ += fmt::format(" {}", length_.name);
    return edit::Translate{knots_, by, true};
  }
  if (kind_ == TransformKind::rotate) {
    const glm::vec3 axis = rotation_axis(view, constraint_);
    angle_ += turned_angle(view, last_, mouse, pivot_, axis);
    last_ = mouse;
    double degrees = base::degrees(angle_);
    if (snap_now(settings) != world::SnapTo::off) degrees = rounded_to(degrees, settings.snapping.angle);
    degrees = typed(0).value_or(degrees);
    const std::string about = constraint_.kind == CKind::free ? "" : fmt::format(" about {}", kAxisNames[axis_index]);
    shown_ = fmt::format("Rotate{}: {}\u00B0", about, fixed(degrees, 2));
    return edit::Rotate{knots_, degrees, pivot_, axis, true};
  }
  const auto middle = view::project(view, pivot_);
  const double from = middle ? glm::length(start_ - glm::vec2(*middle)) : 1,
               to = middle ? glm::length(mouse - glm::vec2(*middle)) : 1;
  double factor = from > 2 ? to / from : 1 + (to - from) / 100;
  if (snap_now(settings) != world::SnapTo::off) factor = std::max(0.1, rounded_to(factor, 0.1));
  factor = std::max(factor, 1e-3);
  glm::vec3 by(1);
  std::size_t field = 0;
  shown_ = fmt::format("Scale{}:", along);
  for (int i = 0; i < 3; ++i) {
    if (!constraint_.allows(i)) continue;
    const double value = any_typed() ? typed(constraint_.kind == CKind::free ? 0 : field++).value_or(1) : factor;
    by[i] = static_cast<float>(value);
    if (i == 0 || constraint_.kind != CKind::free) shown_ += " " + fixed(value, 3);
  }
  return edit::Scale{knots_, by, pivot_, true};
}

void TransformTool::emit(Ui& ui, const view::View& view) {
  const edit::Command next = command(ui, view);
  const std::string text = edit::print(next);
  if (text == sent_) return;
  sent_ = text;
  if (!gesture_) ui.emit(edit::BeginGesture{});
  gesture_ = true;
  ui.out.commands.push_back(next);
}

bool TransformTool::update(Ui& ui, const view::View& view) {
  if (!active_) return false;
  if (gesture_ && !ui.session().history.in_gesture) {  // undone, or ended by a script
    *this = {};
    return false;
  }
  const ImGuiIO& io = ImGui::GetIO();
  begun_ = begun_ || any_typed() || glm::length(mouse_position() - start_) >= ImGui::GetIO().MouseDragThreshold;
  const std::string mistake = mistyped();
  if (begun_ && mistake.empty()) emit(ui, view);
  else (void)command(ui, view);
  if (begun_ && !any_typed()) draw_snap_label(ui, kind_, snap_now(ui.session().settings));
  const bool still = !begun_,
             let_go = button_ ? !io.MouseDown[*button_] : entered_ || io.MouseClicked[ImGuiMouseButton_Left];
  if (!button_ && io.MouseClicked[ImGuiMouseButton_Right]) cancel(ui);
  else if (let_go && mistake.empty()) finish(ui);
  else if (let_go) refuse(ui, mistake);
  return still && let_go;
}

void TransformTool::finish(Ui& ui) {
  if (gesture_) ui.emit(edit::EndGesture{});
  *this = {};
}

// The number stays so that the user can correct it; after the release of a button the transform ends without effect.
void TransformTool::refuse(Ui& ui, const std::string& mistake) {
  ui.warn(mistake);
  entered_ = false;
  if (button_) cancel(ui);
}

bool TransformTool::cancel(Ui& ui) {
  if (!active_) return false;
  if (gesture_) ui.emit(edit::CancelGesture{});
  *this = {};
  return true;
}

std::string TransformTool::status() const {
  if (!active_) return {};
  return text_[field_].empty() ? shown_ : fmt::format("{}   [{}_]", shown_, text_[field_]);
}

}  // namespace coaster::ui
