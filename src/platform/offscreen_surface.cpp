// The off-screen surface: a context of one of the libraries, and a size.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include "platform/driver_threads.h"
#include "platform/offscreen_context.h"
#include "platform/surface.h"

namespace coaster::platform {
namespace {

class OffscreenSurface final : public Surface {
 public:
  OffscreenSurface(OffscreenContext context, std::string library, Size size)
      : context_(std::move(context)), library_(std::move(library)), size_(size) {}
  ~OffscreenSurface() override { context_.destroy(); }

  void poll(Events& events, double) override {
    if (resized_) events.push_back(Resize{size_.width, size_.height});
    resized_ = false;
    events.push_back(Tick{1.0 / 60.0});
  }
  Size size() const override { return size_; }
  float content_scale() const override { return content_scale_; }
  void* gl_proc(const char* name) override { return context_.proc(name); }
  void present(unsigned) override {}
  double clock() const override {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  void set_title(const std::string&) override {}
  void resize(Size size) override {
    size_ = {std::max(size.width, 0), std::max(size.height, 0)};
    resized_ = true;
  }
  void set_content_scale(float scale) override { content_scale_ = scale; }
  std::string clipboard() override { return clipboard_; }
  void set_clipboard(const std::string& text) override { clipboard_ = text; }
  bool is_window() const override { return false; }
  std::string library() const override { return library_; }
  std::optional<Placement> placement() const override { return std::nullopt; }
  void place(const Placement&) override {}

 private:
  OffscreenContext context_;
  std::string library_;
  Size size_;
  float content_scale_ = 1;
  bool resized_ = false;
  std::string clipboard_;
};

struct Library {
  std::string_view choice, name;
  base::Result<OffscreenContext> (*make)();
  bool by_name_alone = false;
};
constexpr Library kLibraries[] = {{"osmesa", "OSMesa", make_osmesa_context},
                                  {"egl", "EGL", [] { return make_egl_context(false); }},
                                  {"gles", "EGL", [] { return make_egl_context(true); }, true}};

}  // namespace

base::Result<std::unique_ptr<Surface>> make_offscreen(const SurfaceOptions& options) {
  // Mesa's software renderer optimises its shaders for longer than most off-screen runs take to draw. Its first context
  // reads this once.
  setenv("GALLIVM_PERF", "nopt", 0);
  spare_driver_threads();
  const char* const named = std::getenv("COASTER_HEADLESS");
  const std::string wanted = options.headless.empty() && named ? named : options.headless;
  std::string reasons;
  for (const Library& library : kLibraries) {
    if (wanted.empty() ? library.by_name_alone : library.choice != wanted) continue;
    auto context = library.make();
    if (context)
      return std::unique_ptr<Surface>(
          std::make_unique<OffscreenSurface>(std::move(*context), std::string(library.name), options.size));
    reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", context.status().message);
  }
  if (reasons.empty())
    return base::Status{base::Code::usage,
                        fmt::format("COASTER_HEADLESS: expected osmesa, egl or gles, found {}", wanted)};
  return base::Status{
      base::Code::graphics,
      fmt::format("No OpenGL without a display: {}. Install EGL (libegl1 and libgl1-mesa-dri on Debian)", reasons)};
}

}  // namespace coaster::platform
