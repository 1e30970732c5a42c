// Opens, frames and draws tracks other than the open one.
#include "app/track_pictures.h"

#include <utility>

#include "app/scene.h"
#include "base/folders.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "gfx/image.h"
#include "view/camera.h"

namespace coaster::app {

ui::TrackPicture TrackPictures::draw(const gfx::Gl& gl, const gfx::Renderer& scenes, const std::string& path,
                                     world::Style style) {
  constexpr int kWidth = 480, kHeight = 270, kSamples = 4;
  ui::TrackPicture picture;
  edit::Session session = edit::make_session({});
  base::Files files;
  if (const base::Status opened = edit::apply(session, files, edit::Load{path}); !opened) {
    picture.problem = opened.message;
    return picture;
  }
  picture.name = session.document.name;
  picture.length = session.derived.length;
  const auto renderer = scenes.sibling(kSamples);  // a separate one: its buffers follow one Derived
  const view::Viewport viewport{0, 0, kWidth, kHeight};
  const view::View view =
      view::orbit_view(view::frame_all(session.settings.camera, session.document, viewport), viewport);
  const view::Overlay nothing_over_it;
  const std::vector<sim::Pose> cars = cart_poses(session, view.eye);
  gfx::Scene scene{session.derived, view, nothing_over_it, cars};
  scene.show_polyline = false;
  scene.style = style;
  scene.supports = edit::find(session, edit::Want::supports).supports;
  (void)renderer->draw(scene, kWidth, kHeight);
  gfx::Object texture = gfx::make_texture(gl, renderer->read_pixels());
  picture.texture = texture.id();
  textures_[path] = std::move(texture);
  return picture;
}

void TrackPictures::update(const gfx::Gl& gl, const gfx::Renderer& scenes, std::span<const std::string> wanted,
                           world::Style style) {
  busy_ = !std::exchange(requested_, !wanted.empty()) && requested_;
  if (busy_) return;
  for (const std::string& path : wanted) {
    const Source source{base::change_time(path), style};
    const auto found = sources_.find(path);
    if (found != sources_.end() && found->second == source) continue;
    made_[path] = draw(gl, scenes, path, style);
    sources_[path] = source;
    busy_ = true;
    return;
  }
}

}  // namespace coaster::app
