#include "app/scene.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/console.h"
#include "gfx/per_frame_instances.h"
#include "sim/ground/ground.h"
#include "sim/ground/plants.h"
#include "sim/ride/ride.h"
#include "sim/solids/supports.h"
#include "sim/study/complete_circuit.h"
#include "ui/tools/show_places.h"
#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::app {
namespace {

bool is_riding(const Program& program, const PictureSettings& look) {
  const world::CameraMode mode = program.picture.rig.mode;
  const bool with_train = mode == world::CameraMode::ride || mode == world::CameraMode::chase;
  return look.alone || (with_train && program.session.motion.state == world::RideState::running);
}

// Returns the plan of the closing section that shows; null for none. It is not searched for while a drag changes the
// track.
const sim::ElementPlan* shown_closing(const edit::SessionFindings& find, const Program& program,
                                      const PictureSettings& look) {
  if (look.settings.aids->circuit <= 0 || program.session.history.in_gesture) return nullptr;
  const sim::CircuitProposals& ways = find.circuit();
  return ways.list.empty() ? nullptr : &ways.list[ui::shown_proposal(*look.settings.aids, ways)].plan;
}

// Returns the water that cars throw up where their rails are near some.
std::vector<gfx::Splash> find_splashes(const edit::Session& session, const sim::Ground& ground,
                                       std::span<const sim::Pose> cars) {
  constexpr double kReach = 1.5, kSlow = 4, kFast = 20;  // m from the water; m/s
  std::vector<gfx::Splash> splashes;
  std::size_t trains = 0;
  for (const sim::Pose& car : cars) {
    trains += car.leads ? 1 : 0;
    if (trains == 0 || trains > session.motion.carts.size()) continue;
    const double speed = std::fabs(session.motion.carts.items()[trains - 1].speed);
    const glm::dvec3 at = car.position, way(car.frame.forward.x, 0, car.frame.forward.z);
    const double near = 1 - std::fabs(at.y - ground.water()) / kReach;
    if (near <= 0 || speed < kSlow || glm::length(way) < 0.3 || ground.height(at.x, at.z) > ground.water()) continue;
    splashes.push_back({glm::vec3(at.x, ground.water(), at.z), glm::vec3(glm::normalize(way)),
                        static_cast<float>(std::fmin(speed / kFast, 1) * std::sqrt(near))});
  }
  return splashes;
}

// Seats different people in every other car, who raise their arms where they nearly float.
void enliven(const edit::Session& session, std::vector<sim::Pose>& poses) {
  constexpr float kFloating = 0.3f;        // g
  constexpr std::size_t kMostLively = 64;  // cars, for which the felt g is computed in each picture
  std::size_t train = 0;
  int car = 0;
  for (std::size_t i = 0; i < poses.size(); ++i, ++car) {
    if (poses[i].leads && i > 0) ++train, car = 0;
    poses[i].group = static_cast<std::uint8_t>(car % 2);
    if (i >= kMostLively) continue;
    const world::Entity entity = session.motion.carts.entities()[train];
    const world::TrainMotion& motion = session.motion.carts.items()[train];
    poses[i].arms_up = sim::felt(session.document, session.derived, entity, motion, car).up < kFloating;
  }
}

}  // namespace

std::vector<sim::Pose> cart_poses(const edit::Session& session, glm::vec3 eye) {
  std::vector<sim::Pose> poses = sim::shown_cars(session.document, session.derived, session.motion,
                                                 session.settings.frames, eye, gfx::CarInstances::kFullCars);
  if (session.settings.look->scenery != world::Scenery::plain) enliven(session, poses);
  return poses;
}

PictureContents find_seen(Program& program, const PictureSettings& look) {
  const edit::SessionFindings find(program.session);
  const world::Layers& layers = look.settings.lab->layers;
  find.look_from(gfx::surroundings_of(look.view));
  PictureContents seen{
      {.failure = program.session.motion.failure, .riding = is_riding(program, look)}, find.values(), nullptr};
  view::MarkedFindings& marked = seen.marked;
  if (layers.has(world::Layer::flips)) marked.breaks = find.breaks();
  if (layers.has(world::Layer::conflicts) && !marked.riding) {
    // A saved picture shows all conflicts. Others may show them later.
    marked.conflicts = look.unseen || program.surface->is_window() ? find.conflicts_so_far() : find.conflicts();
    marked.flooded = find.flooded();
    marked.folds = find.folds(), marked.tight_bends = find.tight_bends();
  }
  if (layers.has(world::Layer::limits)) marked.spans = find.overloads(), marked.jolts = find.jolts();
  marked.ground = &find.ground();
  if (look.settings.aids->show_element) marked.element = &find.element(), marked.narrow = find.room();
  if (const sim::ElementPlan* const way = shown_closing(find, program, look)) marked.element = way, marked.narrow = {};
  if (layers.has(world::Layer::supports)) seen.supports = &find.supports();
  // What add_surroundings() shows is found here, with the rest of what takes the program's time.
  if (look.settings.look->scenery != world::Scenery::plain) (void)find.plants(), (void)find.stations();
  return seen;
}

void add_surroundings(gfx::Scene& scene, const edit::SessionFindings& find, world::Scenery scenery) {
  scene.ground = &find.ground();
  scene.scenery = scenery;
  if (scenery == world::Scenery::plain) return;
  if (!scene.ground->plain()) scene.plants = &find.plants();
  if (scene.style != world::Style::blueprint) scene.stations = &find.stations();
}

gfx::DrawStats draw_scene(Program& program, const PictureSettings& look, const PictureContents& seen,
                          platform::Size size) {
  const edit::Session& session = program.session;
  const world::Layers& layers = look.settings.lab->layers;
  const view::Overlay overlay =
      view::build_overlay(session.document, session.derived, look.settings, look.view, look.hovered, seen.marked);
  const std::vector<sim::Pose> carts = cart_poses(session, look.view.eye);
  gfx::Scene scene{session.derived,
                   look.view,
                   overlay,
                   carts,
                   layers.has(world::Layer::polyline),
                   &seen.values,
                   session.settings.look->theme};
  scene.style = session.settings.look->style;
  scene.shadows = session.settings.look->shadows;
  scene.unseen = look.unseen;
  scene.clock = [&] { return program.surface->clock(); };
  scene.supports = seen.supports;
  scene.document = &session.document;
  add_surroundings(scene, edit::SessionFindings(program.session), session.settings.look->scenery);
  std::vector<gfx::Splash> splashes;
  if (scene.scenery != world::Scenery::plain && !scene.ground->plain())
    scene.splashes = splashes = find_splashes(session, *scene.ground, carts);
  scene.eye_room = seen.marked.riding ? 0 : kEyeRoom;
  // A ride moves the waves; otherwise pictures of one scene are equal.
  if (session.motion.state != world::RideState::stopped)
    scene.seconds = static_cast<double>(session.tick) * world::kTick;
  if (scene.scenery != world::Scenery::plain && session.settings.panels->workspace == world::Workspace::ride)
    scene.show_polyline = false;
  program.stats.colour_low = seen.values.low, program.stats.colour_high = seen.values.high;
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
  const PictureSettings look{program.session.settings, program.picture.view, program.picture.hovered};
  (void)draw_scene(program, look, find_seen(program, look), size);
  program.ui->draw(size.width, size.height);
}

void draw_scene_alone(Program& program, platform::Size size) {
  const view::Viewport whole{0, 0, static_cast<float>(size.width), static_cast<float>(size.height)};
  const view::View view = view::view_of(program.picture.rig.eye, whole, program.picture.view.density);
  world::Settings settings = program.session.settings;
  settings.selected = world::kNone;
  settings.also.clear();
  settings.aids->show_gizmo = settings.aids->show_element = false;
  settings.aids->circuit = 0;
  settings.lab->layers.set(world::Layer::polyline, false);
  const PictureSettings look{settings, view, {}, true};
  (void)draw_scene(program, look, find_seen(program, look), size);
}

}  // namespace coaster::app
