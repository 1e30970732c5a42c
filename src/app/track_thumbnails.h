// Small pictures of tracks for the start screen, drawn by a second renderer next to the scene's, one per frame on
// demand.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gfx/gl_objects.h"
#include "gfx/renderer.h"
#include "ui/context/state.h"

namespace coaster::app {

class TrackPictures {
 public:
  // Draws the first requested file whose picture is missing or out of date, at least `width` px wide. Draws none in the
  // first frame that requests some, so that the start screen shows at once. The pictures stay when nothing is requested
  // any more.
  void update(const gfx::Gl& gl, const gfx::Renderer& scenes, std::span<const std::string> wanted, int width,
              world::Style style, world::Scenery scenery);

  // Returns whether another picture may be due: the last update drew one or was the first.
  bool busy() const { return busy_; }

  const std::map<std::string, ui::TrackPicture>& made() const { return made_; }

 private:
  struct Source {
    std::int64_t time = 0;
    int width = 0;  // px
    world::Style style{};
    world::Scenery scenery{};
    friend bool operator==(const Source&, const Source&) = default;
  };
  ui::TrackPicture draw(const gfx::Gl& gl, const gfx::Renderer& scenes, const std::string& path, const Source& source);

  bool requested_ = false;  // by the last update
  bool busy_ = false;
  std::map<std::string, Source> sources_;
  std::map<std::string, gfx::GlObject> textures_;
  std::map<std::string, ui::TrackPicture> made_;
};

}  // namespace coaster::app
