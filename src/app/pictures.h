// Saves the last frame as a PNG file, and compares it with a golden picture.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>

#include "base/files.h"
#include "gfx/gl_objects.h"
#include "gfx/renderer.h"
#include "ui/context/state.h"

namespace coaster::app {

struct Program;

base::Status write_picture(Program& program, const std::filesystem::path& path);

// Saves the scene, or with `panels` the whole last frame, as NAME-1.png or with the first unused number, where NAME is
// the track's name, or its file's where nobody has named it: in the user's picture folder ($XDG_PICTURES_DIR, else
// ~/Pictures, else the current folder), in a script's $OUT. A notice gives the path or the error.
void take_photo(Program& program, bool panels);

// Combines PNG files into one, optionally each at half its size. Code::bad_file if one is not a picture.
base::Status write_sheet(const base::FileRoot& root, const std::filesystem::path& path, int columns, bool half,
                         std::span<const std::filesystem::path> pictures);

// Returns a new folder for a movie, "red-comet-movie-1": in the user's video folder ($XDG_VIDEOS_DIR, else ~/Videos,
// else the folder of take_photo()), in a script's $OUT.
std::filesystem::path movie_folder(const Program& program);

// Returns how two PNG files differ, as script::Host says.
std::string picture_difference(std::string_view png, std::string_view other);

// Compares the last frame with a golden picture, by the rule of gfx/image.h. If they differ, writes NAME.new.png,
// NAME.reference.png, NAME.difference.png and NAME.html into `folder`. `update`: writes the golden instead,
// SCRIPTS/golden/NAME.png, below the folder SCRIPTS, if it is missing or differs. Code::expectation if there is no
// golden or the pictures differ.
base::Status compare_picture(Program& program, const std::string& name, const std::filesystem::path& golden,
                             const std::filesystem::path& folder, bool update);

// Small pictures of tracks for the start screen, drawn by a second renderer next to the scene's, one per frame on
// demand.
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
