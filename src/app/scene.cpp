#include "app/scene.h"

#include <algorithm>
#include <utility>

#include "base/console.h"
#include "gfx/instances.h"
#include "sim/ride/shown_cars.h"
#include "world/aids.h"
#include "world/lab_view.h"
#include "world/look.h"

namespace coaster::app {
namespace {

bool is_riding(const Program& program, const Look& look) {
  const world::CameraMode mode = program.picture.rig.mode;
  const bool with_train = mode == world::CameraMode::ride || mode == world::CameraMode::chase;
  return look.alone || (with_train && program.session.motion.state == world::RideState::running);
}

// True if ways home show. They are not searched for while a drag changes the track.
bool shows_circuit(const Program& program, const Look& look) {
  return look.settings.aids->circuit > 0 && !program.session.history.in_gesture;
}

// A saved picture shows all conflicts. Others may show them later.
edit::Want wanted_conflicts(const Look& look, const Program& program) {
  return look.unseen || program.surface->is_window() ? edit::Want::conflicts_so_far : edit::Want::conflicts;
}

edit::Want wanted_by(const Look& look, const Program& program) {
  using edit::Want;
  const world::Layers& layers = look.settings.lab->layers;
  Want wanted = Want::values;
  if (layers.has(world::Layer::flips)) wanted = wanted | Want::breaks;
  if (layers.has(world::Layer::conflicts) && !is_riding(program, look))
    wanted = wanted | wanted_conflicts(look, program) | Want::folds | Want::tight_bends;
  if (layers.has(world::Layer::limits)) wanted = wanted | Want::overloads | Want::jolts;
  if (layers.has(world::Layer::supports)) wanted = wanted | Want::supports;
  if (look.settings.aids->show_element) wanted = wanted | Want::element | Want::room;
  if (shows_circuit(program, look)) wanted = wanted | Want::circuit;
  return wanted;
}

// Adds the palette's element or a way home to the overlay.
void mark_plan(const Program& program, const Look& look, const edit::Findings& found, view::Findings& marked) {
  if (look.settings.aids->show_element) marked.element = found.element, marked.narrow = found.room;
  if (!shows_circuit(program, look) || found.circuit->list.empty()) return;
  const std::size_t last = found.circuit->list.size() - 1,
                    wanted = static_cast<std::size_t>(look.settings.aids->circuit) - 1;
  marked.element = &found.circuit->list[std::min(wanted, last)].plan, marked.narrow = {};
}

}  // namespace

std::vector<sim::Pose> cart_poses(const edit::Session& session, glm::vec3 eye) {
  return sim::shown_cars(session.document, session.derived, session.motion, session.settings.frames, eye,
                         gfx::Instances::kFullCars);
}

const edit::Findings& find_seen(Program& program, const Look& look) {
  edit::look_from(program.session, gfx::surroundings_of(look.view));
  return edit::find(program.session, wanted_by(look, program));
}

gfx::DrawStats draw_scene(Program& program, const Look& look, const edit::Findings& found, platform::Size size) {
  const edit::Session& session = program.session;
  const world::Layers& layers = look.settings.lab->layers;
  view::Findings marked{.failure = session.motion.failure, .riding = is_riding(program, look)};
  if (layers.has(world::Layer::flips)) marked.breaks = found.breaks;
  if (layers.has(world::Layer::conflicts) && !marked.riding) {
    marked.conflicts = found.conflicts;
    marked.folds = found.folds, marked.tight_bends = found.tight_bends;
  }
  if (layers.has(world::Layer::limits)) marked.spans = found.overloads, marked.jolts = found.jolts;
  mark_plan(program, look, found, marked);
  const view::Overlay overlay =
      view::build_overlay(session.document, session.derived, look.settings, look.view, look.hovered, marked);
  const std::vector<sim::Pose> carts = cart_poses(session, look.view.eye);
  gfx::Scene scene{session.derived,
                   look.view,
                   overlay,
                   carts,
                   layers.has(world::Layer::polyline),
                   found.values,
                   session.settings.look->theme};
  scene.style = session.settings.look->style;
  scene.shadows = session.settings.look->shadows;
  scene.unseen = look.unseen;
  scene.clock = [&] { return program.surface->clock(); };
  if (layers.has(world::Layer::supports)) scene.supports = found.supports;
  program.stats.colour_low = found.values->low, program.stats.colour_high = found.values->high;
  program.stats.supports = scene.supports ? scene.supports->count() : 0;
  program.stats.support_rebuilds = scene.supports ? scene.supports->rebuilds() : 0;
  const gfx::DrawStats drawn = program.renderer->draw(scene, size.width, size.height);
  if (const std::string notice = program.renderer->take_notice(); !notice.empty()) {
    edit::notify(program.session, edit::NoticeKind::warning, notice);
    if (!program.surface->is_window()) base::print_error(notice);
  }
  if (const base::Status& failed = program.renderer->failure(); !failed)
    leave_without_graphics(program, failed.message);
  return drawn;
}

void draw_pixels(Program& program) {
  const platform::Size size{program.stats.width, program.stats.height};
  if (!std::exchange(program.picture.unseen, false) || size.width < 1 || size.height < 1) return;
  const Look look{program.session.settings, program.picture.view, program.picture.hovered};
  (void)draw_scene(program, look, find_seen(program, look), size);
  program.ui->draw(size.width, size.height);
}

void draw_scene_alone(Program& program, const view::View& view, platform::Size size) {
  world::Settings settings = program.session.settings;
  settings.selected = world::kNone;
  settings.also.clear();
  settings.aids->show_gizmo = settings.aids->show_element = false;
  settings.aids->circuit = 0;
  settings.lab->layers.set(world::Layer::polyline, false);
  const Look look{settings, view, {}, true};
  (void)draw_scene(program, look, find_seen(program, look), size);
}

}  // namespace coaster::app
