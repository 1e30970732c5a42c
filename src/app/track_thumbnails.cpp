// Opens, frames and draws tracks other than the open one.
#include "app/track_thumbnails.h"

#include <algorithm>
#include <utility>

#include "app/scene.h"
#include "base/folders.h"
#include "base/parallel.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "gfx/image.h"
#include "sim/solids/supports.h"
#include "view/camera.h"
#include "world/appearance_settings.h"

namespace coaster::app {

ui::TrackPicture TrackPictures::draw(const gfx::Gl& gl, const gfx::Renderer& scenes, const std::string& path,
                                     const Source& source) {
  constexpr int kSamples = 4;
  const int width = source.width, height = width * 9 / 16;
  ui::TrackPicture picture;
  edit::Session session = edit::make_session({});
  base::Files files;
  if (const base::Status opened = edit::apply(session, files, edit::LoadTrack{path}); !opened) {
    picture.problem = opened.message;
    return picture;
  }
  picture.name = session.document.name;
  picture.length = session.derived.length;
  const auto renderer = scenes.sibling(kSamples);  // a separate one: its buffers follow one DerivedTrack
  const view::Viewport viewport{0, 0, static_cast<float>(width), static_cast<float>(height)};
  const view::View view =
      view::orbit_view(view::frame_all(session.settings.camera, session.document, viewport), viewport);
  const view::Overlay nothing_over_it;
  session.settings.look->scenery = source.scenery;
  const std::vector<sim::Pose> cars = cart_poses(session, view.eye);
  gfx::Scene scene{session.derived, view, nothing_over_it, cars};
  scene.show_polyline = false;
  scene.style = source.style;
  scene.document = &session.document;
  edit::SessionFindings(session).look_from(gfx::surroundings_of(view));
  scene.supports = &edit::SessionFindings(session).supports();
  // Where no thread helps, a land would take half a second of each picture.
  if (base::has_threads()) add_surroundings(scene, edit::SessionFindings(session), source.scenery);
  scene.eye_room = kEyeRoom;
  (void)renderer->draw(scene, width, height);
  gfx::GlObject texture = gfx::make_texture(gl, renderer->read_pixels());
  picture.texture = texture.id();
  textures_[path] = std::move(texture);
  return picture;
}

void TrackPictures::update(const gfx::Gl& gl, const gfx::Renderer& scenes, std::span<const std::string> wanted,
                           int width, world::Style style, world::Scenery scenery) {
  constexpr int kStep = 80;  // px: a window that is resized draws them again only sometimes
  busy_ = !std::exchange(requested_, !wanted.empty()) && requested_;
  if (busy_) return;
  for (const std::string& path : wanted) {
    const Source source{base::change_time(path), (std::max(width, 1) + kStep - 1) / kStep * kStep, style, scenery};
    const auto found = sources_.find(path);
    if (found != sources_.end() && found->second == source) continue;
    made_[path] = draw(gl, scenes, path, source);
    sources_[path] = source;
    busy_ = true;
    return;
  }
}

}  // namespace coaster::app
