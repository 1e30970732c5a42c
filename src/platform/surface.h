// The target of frames: a window (GLFW) or memory (OSMesa or EGL). The only interface with virtual functions in the
// program.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "base/status.h"
#include "platform/events.h"

namespace coaster::platform {

// Position and size in the window system's coordinates, without the window frame.
struct WindowPlacement {
  int x = 0, y = 0, width = 0, height = 0;
  bool maximised = false;
  friend bool operator==(const WindowPlacement&, const WindowPlacement&) = default;
};

// The area of a screen that windows may cover.
struct Screen {
  int x = 0, y = 0, width = 0, height = 0;
};

struct Size {
  int width = 0, height = 0;
  friend bool operator==(const Size&, const Size&) = default;
};

class Surface {
 public:
  virtual ~Surface() = default;
  // Appends the events since the last call, the Tick last. A window without events waits for one, `wait` seconds at
  // most. Headless: only a Tick of exactly 1/60 s, at once.
  virtual void poll(Events& events, double wait) = 0;
  virtual Size size() const = 0;            // framebuffer pixels; zero if minimised
  virtual float content_scale() const = 0;  // pixels per point: 1 on ordinary screens, 2 on dense ones
  virtual void* gl_proc(const char* name) = 0;
  // Shows the colour of `framebuffer` (a GL name, single-sampled, of size()). A window copies it; memory keeps nothing,
  // so read pixels with gfx::read_pixels before.
  virtual void present(unsigned framebuffer) = 0;
  virtual double clock() const = 0;  // seconds, monotonic
  virtual void set_title(const std::string& title) = 0;
  virtual void resize(Size size) = 0;  // a window requests it from the window system; memory resizes
  virtual void set_content_scale(float scale) { (void)scale; }  // of memory; a window has its screen's
  virtual std::string clipboard() = 0;
  virtual void set_clipboard(const std::string& text) = 0;
  // Gives a written file to the user: a browser downloads it. Elsewhere it is already at the chosen path.
  virtual void offer(const std::string& path) { (void)path; }
  // Fills the screen, or returns from that. Where there is no window it does nothing.
  virtual void toggle_full_screen() {}
  // Ends a browser's sound output, which would stay open when a sound device closes. Call it before the device closes.
  virtual void end_sound() {}
  // Whether what is typed goes to a text. A touch screen shows its keyboard while it does.
  virtual void take_text(bool wanted) { (void)wanted; }
  // Lets whoever shows the window ask by text: a browser's page. `ask` must be callable as long as the surface lives.
  virtual void answer_by(const std::function<std::string(const std::string& question)>& ask) { (void)ask; }
  // A browser's page calls `autosave` when it is hidden or left; it returns whether there are unsaved changes, and the
  // browser then asks. It must be callable as long as the surface lives.
  virtual void before_leaving(const std::function<bool()>& autosave) { (void)autosave; }
  virtual bool is_window() const = 0;
  virtual std::string library() const = 0;  // that created the context: "GLFW 3.3.8", "OSMesa", "EGL"
  // Returns the window's position; nothing for memory and while minimised. A maximised window has the size of the
  // screen.
  virtual std::optional<WindowPlacement> placement() const { return std::nullopt; }
  // Moves the window there, or to the nearest visible position.
  virtual void place(const WindowPlacement& placement) { (void)placement; }
};

struct SurfaceOptions {
  Size size{1280, 720};
  std::string title = "coaster";
  bool visible = true;
  bool vsync = true;
  // Called once when the window's display is gone: the X server or the Wayland compositor has ended. It must end the
  // program without using the surface. Empty: Xlib ends it.
  std::function<void()> lost{};
  std::string headless{};  // of an off-screen context: "osmesa", "egl" or "gles"; "": $COASTER_HEADLESS
};

// Opens a window with an OpenGL 3.3 core context. Code::graphics if there is no display (the message suggests
// --headless), no such context (versions needed and found), or the program was built without windows.
base::Result<std::unique_ptr<Surface>> make_window(const SurfaceOptions& options);

// Returns "GLFW 3.3.8", or "none" in a program built without windows.
std::string window_library();

// Creates an off-screen OpenGL core context with the library named by the options, else $COASTER_HEADLESS, else OSMesa
// or, if that is missing, EGL. "gles" is OpenGL ES 3.0 by EGL, as in a browser. Code::graphics if none provides one:
// the message names the packages to install. Code::usage for another name. Sets GALLIVM_PERF unless it is set: Mesa's
// software renderer then compiles shaders in half the time and draws up to 13 % slower.
base::Result<std::unique_ptr<Surface>> make_offscreen(const SurfaceOptions& options);

// Returns `wanted` adjusted to the screens: not larger than the screen it is mostly on, and moved there if less than
// 100 px of its top edge, which holds the title, is on a screen. If it is on no screen: centred on the first. Without
// screens: unchanged.
WindowPlacement fitted(const WindowPlacement& wanted, std::span<const Screen> screens);

}  // namespace coaster::platform
