// Writes and compares pictures.
#include "app/pictures.h"

#include <algorithm>
#include <cstdlib>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "app/program.h"
#include "app/scene.h"
#include "base/folders.h"
#include "base/parallel.h"
#include "base/text.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "gfx/image.h"
#include "sim/solids/supports.h"
#include "view/camera.h"
#include "world/appearance_settings.h"
#include "world/document.h"

namespace coaster::app {
namespace {

// Pictures bypass the program's file handling: injected faults are meant for documents.
base::Status write(const base::FileRoot& root, const std::filesystem::path& path, const gfx::Image& image,
                   base::ReplaceableFiles replaces = base::ReplaceableFiles::made) {
  const std::filesystem::path folder = path.parent_path();
  if (const base::Status made = folder.empty() ? base::Status{} : root.make_folders(folder); !made) return made;
  base::Files files(root);
  return files.write_atomic(path, gfx::encode_png(image), replaces);
}

// Writes below the script's folder, which contains "golden/NAME.png".
base::Status write_golden(const std::string& name, const std::filesystem::path& golden, const gfx::Image& image) {
  std::filesystem::path folder = golden.parent_path();
  for ([[maybe_unused]] const std::filesystem::path& part : std::filesystem::path(name)) folder = folder.parent_path();
  const auto root = base::FileRoot().open(folder.empty() ? "." : folder);
  return root ? write(*root, golden, image, base::ReplaceableFiles::any) : root.status();
}

std::string page(const std::string& file) {
  std::string html = fmt::format("<!doctype html><meta charset=\"utf-8\"><title>{}</title>\n", file);
  for (const char* const kind : {"new", "reference", "difference"})
    html += fmt::format("<figure><figcaption>{0}</figcaption><img src=\"{1}.{0}.png\"></figure>\n", kind, file);
  return html;
}

// Returns a folder of the user by its variable, or below the home folder if it exists there; empty if neither.
std::filesystem::path user_folder(const char* variable, const char* name) {
  std::error_code failed;
  if (const char* const named = std::getenv(variable); named && std::filesystem::path(named).is_absolute())
    return named;
  if (const char* const home = std::getenv("HOME"))
    if (const auto folder = std::filesystem::path(home) / name; std::filesystem::is_directory(folder, failed))
      return folder;
  return {};
}

std::filesystem::path picture_folder(const Program& program) {
  if (program.files.root().limited()) return program.files.root().folder();
  const std::filesystem::path folder = user_folder("XDG_PICTURES_DIR", "Pictures");
  std::error_code failed;
  return folder.empty() ? std::filesystem::current_path(failed) : folder;
}

// Returns letters and digits of a track's name in lower case, joined by "-".
std::string file_stem(std::string_view name) {
  std::string stem;
  for (const char c : base::lower(name)) {
    if ((c >= '0' && c <= '9') || (c >= 'a' && c <= 'z')) stem += c;
    else if (!stem.empty() && stem.back() != '-') stem += '-';
  }
  while (stem.ends_with('-')) stem.pop_back();
  return stem.empty() ? "track" : stem;
}

// Returns "red-comet-movie-1" for the kind "-movie": the track's name, or its file's where nobody has named it, with
// the first unused number.
std::filesystem::path free_path(const Program& program, const std::filesystem::path& folder, const char* kind,
                                const char* ending) {
  constexpr int kMostNumbers = 10'000;
  const std::string stem = file_stem(world::track_name(program.session.document.name, program.session.file.path));
  std::filesystem::path path;
  std::error_code failed;
  for (int i = 1; i < kMostNumbers; ++i)
    if (path = folder / fmt::format("{}{}-{}{}", stem, kind, i, ending);
        !std::filesystem::exists(std::filesystem::symlink_status(path, failed)))
      break;
  return path;
}

}  // namespace

base::Status write_picture(Program& program, const std::filesystem::path& path) {
  if (program.stats.frame == 0) return {base::Code::refused, "no frame has been drawn"};
  draw_pixels(program);
  return write(program.files.root(), path, program.renderer->read_pixels());
}

std::filesystem::path movie_folder(const Program& program) {
  const base::FileRoot& root = program.files.root();
  std::filesystem::path folder = root.limited() ? root.folder() : user_folder("XDG_VIDEOS_DIR", "Videos");
  if (folder.empty()) folder = picture_folder(program);
  return free_path(program, folder, "-movie", "");
}

void take_photo(Program& program, bool panels) {
  const std::filesystem::path path = free_path(program, picture_folder(program), "", ".png");
  if (!panels) draw_scene_alone(program, {program.stats.width, program.stats.height});
  const base::Status wrote =
      panels ? write_picture(program, path) : write(program.files.root(), path, program.renderer->read_pixels());
  if (!panels) program.picture.unseen = true;  // what was drawn is not the frame
  if (wrote) program.surface->offer(path.string());
  std::error_code ignored;  // then the path as it is
  const std::filesystem::path whole = std::filesystem::absolute(path, ignored).lexically_normal();
  edit::notify(program.session, wrote ? edit::NoticeKind::info : edit::NoticeKind::error,
               wrote ? fmt::format("Saved {}", whole.string()) : wrote.message);
}

base::Status write_sheet(const base::FileRoot& root, const std::filesystem::path& path, int columns, bool half,
                         std::span<const std::filesystem::path> pictures) {
  constexpr int kGap = 12;  // px
  base::Files files;
  std::vector<gfx::Image> images;
  int width = 0, height = 0;  // of the largest
  for (const std::filesystem::path& picture : pictures) {
    const auto bytes = files.read(picture);
    if (!bytes) return bytes.status();
    auto image = gfx::decode_png(*bytes, picture.string());
    if (!image) return image.status();
    images.push_back(half ? gfx::half_size(*image) : std::move(*image));
    width = std::max(width, images.back().width), height = std::max(height, images.back().height);
    const std::int64_t cell = std::int64_t{width + kGap} * (height + kGap);
    if (static_cast<std::int64_t>(pictures.size()) > base::kMaxPixels / cell)
      return {base::Code::refused,
              fmt::format("{}: {} pictures of up to {}x{} pixels are more than the limit of {} pixels", path.string(),
                          pictures.size(), width, height, base::kMaxPixels)};
  }
  return write(root, path, gfx::contact_sheet(images, columns, kGap));
}

std::string picture_difference(std::string_view png, std::string_view other) {
  const auto a = gfx::decode_png(png, ""), b = gfx::decode_png(other, "");
  if (!a || !b) return {};
  const gfx::PictureDifference difference = gfx::compare(*a, *b, {.share = 0, .block = 0, .channel = 0});
  if (!difference.same_size)
    return fmt::format("in size: {}x{} and {}x{} pixels", a->width, a->height, b->width, b->height);
  if (difference.pixels == 0) return {};
  return fmt::format("in {} of {} pixels, the first at x {} y {}, by up to {} of 255 at x {} y {}", difference.pixels,
                     a->width * a->height, difference.first.x, difference.first.y, difference.largest,
                     difference.largest_at.x, difference.largest_at.y);
}

base::Status compare_picture(Program& program, const std::string& name, const std::filesystem::path& golden,
                             const std::filesystem::path& folder, bool update) {
  if (program.stats.frame == 0) return {base::Code::refused, "no frame has been drawn"};
  draw_pixels(program);
  const gfx::Image picture = program.renderer->read_pixels();
  const base::FileRoot& root = program.files.root();
  base::Files files(root);
  const auto at = [&](const char* kind) { return folder / fmt::format("{}.{}", name, kind); };
  const auto bytes = files.read(golden);
  const auto reference = bytes ? gfx::decode_png(*bytes, golden.string()) : base::Result<gfx::Image>(bytes.status());
  if (update && !reference) return write_golden(name, golden, picture);
  if (!bytes) {
    if (const base::Status wrote = write(root, at("new.png"), picture); !wrote) return wrote;
    return {base::Code::expectation, fmt::format("no golden picture {} (--update-goldens makes it); the picture is {}",
                                                 golden.string(), at("new.png").string())};
  }
  if (!reference) return reference.status();
  // Goldens are Mesa's pictures; browsers draw by ANGLE.
  const bool as_mesa = program.surface->library() != "WebGL 2";
  const gfx::PictureTolerance tolerance =
      as_mesa ? gfx::PictureDifference::kSameSamples : gfx::PictureDifference::kOtherSamples;
  const gfx::PictureDifference difference = gfx::compare(picture, *reference, tolerance);
  if (difference.acceptable) return {};
  if (update) return write_golden(name, golden, picture);
  for (const base::Status& wrote : {write(root, at("new.png"), picture), write(root, at("reference.png"), *reference)})
    if (!wrote) return wrote;
  if (difference.same_size)
    if (const base::Status wrote = write(root, at("difference.png"), difference.picture); !wrote) return wrote;
  if (const base::Status wrote = files.write_atomic(at("html"), page(std::filesystem::path(name).filename().string()));
      !wrote)
    return wrote;
  if (!difference.same_size)
    return {base::Code::expectation, fmt::format("the picture is {}x{}, the golden one {}x{}", picture.width,
                                                 picture.height, reference->width, reference->height)};
  return {
      base::Code::expectation,
      fmt::format("the picture differs from {} in {} pixels, {} of them in an 8x8 block; another driver may change {} "
                  "and {}; see {}",
                  golden.string(), difference.pixels, difference.worst_block, difference.most_pixels, tolerance.block,
                  at("html").string())};
}

// --- Small pictures of tracks for the start screen

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
