// The window surface: GLFW and an OpenGL 3.3 core context.
#define GLFW_INCLUDE_NONE
#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <GL/glcorearb.h>
#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include "platform/events.h"
#include "platform/gl_context_detail.h"
#include "platform/surface.h"

namespace coaster::platform {
namespace {

// Returns what a key types in the first layout, if that is its only one: X11 drops what all layouts have in common, and
// GLFW asks for the present layout alone. Empty for others.
std::string only_print_of(int scancode) {
  using Display = void*();
  using KeySymbol = unsigned long(void*, unsigned char, int group, int level);
  static void* const x11 = dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD);
  static const auto display = reinterpret_cast<Display*>(dlsym(RTLD_DEFAULT, "glfwGetX11Display"));
  static const auto symbol = x11 ? reinterpret_cast<KeySymbol*>(dlsym(x11, "XkbKeycodeToKeysym")) : nullptr;
  void* const connection = display && symbol ? display() : nullptr;
  const auto code = static_cast<unsigned char>(scancode);
  if (!connection || symbol(connection, code, 1, 0) != 0) return {};
  const unsigned long first = symbol(connection, code, 0, 0);
  return first > ' ' && first <= '~' ? std::string(1, static_cast<char>(first)) : std::string();
}

// Returns what a key types without modifiers, in the present layout.
std::string print_of(int scancode) {
  const char* const text = glfwGetKeyName(GLFW_KEY_UNKNOWN, scancode);
  return text ? text : only_print_of(scancode);
}

// Returns the key of a press, by GLFW's codes; Key::unknown with AltGr, which makes text.
Key key_of(GLFWwindow* window, int code, int scancode, int mods) {
  if (glfwGetKey(window, GLFW_KEY_RIGHT_ALT) == GLFW_PRESS && (mods & GLFW_MOD_ALT) == 0) return Key::unknown;
  bool other_script = false, tells = false;
  for (int letter = GLFW_KEY_A; letter <= GLFW_KEY_Z; ++letter) {
    const std::string print = print_of(glfwGetKeyScancode(letter));
    other_script = other_script || is_other_script(print);
    tells = tells || !print.empty();
  }
  return key_at(Key{code}, print_of(scancode), other_script || !tells);
}

// Xlib's handler gets no argument, so this is global.
std::function<void()>& lost_handler() {
  static std::function<void()> handler;
  return handler;
}

void call_lost() {
  // At most once: the handler may be called again if it uses the display.
  if (const auto handler = std::exchange(lost_handler(), {})) handler();
}

extern "C" int note_lost(void*) {
  call_lost();
  return 0;
}

// Returns a function of a library that GLFW has loaded; null without that library.
template <class Function>
Function* loaded(const char* library, const char* name) {
  void* const handle = dlopen(library, RTLD_LAZY | RTLD_NOLOAD);
  return handle ? reinterpret_cast<Function*>(dlsym(handle, name)) : nullptr;
}

// Calls `lost` when Xlib loses its connection. It must end the program, or Xlib will.
void watch_display(std::function<void()> lost) {
  lost_handler() = std::move(lost);
  if (!lost_handler()) return;
  using SetHandler = void*(int (*)(void*));
  if (const auto set = loaded<SetHandler>("libX11.so.6", "XSetIOErrorHandler")) set(note_lost);
}

// Calls `lost` if the connection to a Wayland compositor is broken. Call it after each poll.
void check_display() {
  if (!lost_handler()) return;
  using Display = void*();
  using Error = int(void*);
  static const auto display = reinterpret_cast<Display*>(dlsym(RTLD_DEFAULT, "glfwGetWaylandDisplay"));
  static const auto error = loaded<Error>("libwayland-client.so.0", "wl_display_get_error");
  void* const connection = display && error ? display() : nullptr;
  if (connection && error(connection) != 0) call_lost();
}

Modifiers modifiers_of(int mods) {
  return {(mods & GLFW_MOD_SHIFT) != 0, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_ALT) != 0};
}

std::string utf8_of(unsigned codepoint) {
  constexpr unsigned kFirst[] = {0, 0xc0, 0xe0, 0xf0};  // marks of the first byte, by the number of bytes after it
  int more = codepoint < 0x80 ? 0 : codepoint < 0x800 ? 1 : codepoint < 0x10000 ? 2 : 3;
  std::string out(1, static_cast<char>(kFirst[more] | codepoint >> 6 * more));
  while (more-- > 0) out += static_cast<char>(0x80 | (codepoint >> 6 * more & 63));
  return out;
}

class WindowSurface final : public Surface {
 public:
  explicit WindowSurface(GLFWwindow* window) : window_(window), last_(glfwGetTime()) {
    glfwSetWindowUserPointer(window, this);
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
      of(w).mouse_ = of(w).in_pixels(x, y);
      of(w).tell_mouse();
    });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
      if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
      const Button which = button == GLFW_MOUSE_BUTTON_LEFT    ? Button::left
                           : button == GLFW_MOUSE_BUTTON_RIGHT ? Button::right
                                                               : Button::middle;
      of(w).tell_mouse();
      of(w).pending_.push_back(MouseButton{which, action == GLFW_PRESS, modifiers_of(mods)});
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double dx, double dy) {
      of(w).tell_mouse();
      of(w).pending_.push_back(Wheel{static_cast<float>(dx), static_cast<float>(dy)});
    });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int code, int scancode, int action, int mods) {
      // X11 omits a modifier's own bit from its press and includes it in its release, so these are corrected by hand;
      // the event of an unknown key only reports modifiers.
      Modifiers held = modifiers_of(mods);
      const bool down = action != GLFW_RELEASE;
      if (code == GLFW_KEY_LEFT_SHIFT || code == GLFW_KEY_RIGHT_SHIFT) held.shift = down;
      if (code == GLFW_KEY_LEFT_CONTROL || code == GLFW_KEY_RIGHT_CONTROL) held.ctrl = down;
      if (code == GLFW_KEY_LEFT_ALT || code == GLFW_KEY_RIGHT_ALT) held.alt = down;
      // What was pressed is released, whatever the layout is then.
      Key& key = of(w).pressed_[static_cast<std::size_t>(code + 1)];
      if (action == GLFW_PRESS) key = key_of(w, code, scancode, mods);
      of(w).pending_.push_back(KeyPress{key, down, action == GLFW_REPEAT, held, Key{code}});
    });
    glfwSetCharCallback(
        window, [](GLFWwindow* w, unsigned codepoint) { of(w).pending_.push_back(TextInput{utf8_of(codepoint)}); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
      for (int i = 0; i < count; ++i) of(w).pending_.push_back(FileDrop{paths[i]});
    });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int width, int height) {
      of(w).pending_.push_back(Resize{width, height});
    });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).pending_.push_back(Expose{}); });
    glfwSetWindowFocusCallback(
        window, [](GLFWwindow* w, int focused) { of(w).pending_.push_back(Focus{focused == GLFW_TRUE}); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) {
      glfwSetWindowShouldClose(w, GLFW_FALSE);  // the program decides when to close
      of(w).pending_.push_back(CloseRequest{});
    });
    bind_framebuffer_ = reinterpret_cast<PFNGLBINDFRAMEBUFFERPROC>(glfwGetProcAddress("glBindFramebuffer"));
    blit_ = reinterpret_cast<PFNGLBLITFRAMEBUFFERPROC>(glfwGetProcAddress("glBlitFramebuffer"));
  }
  ~WindowSurface() override {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }

  void poll(Events& events, double wait) override {
    if (size() == Size{}) wait = 0.1;  // minimised: nothing to draw
    if (wait > 0) glfwWaitEventsTimeout(wait);
    else glfwPollEvents();
    check_display();
    poll_gamepad();
    for (Event& event : std::exchange(pending_, {})) events.push_back(std::move(event));
    const double now = glfwGetTime();
    events.push_back(Tick{now - std::exchange(last_, now)});
  }
  Size size() const override {
    Size s;
    glfwGetFramebufferSize(window_, &s.width, &s.height);
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return {};
    return s.width > 0 && s.height > 0 ? s : Size{};
  }
  float content_scale() const override {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return x > 0 ? x : 1;
  }
  void* gl_proc(const char* name) override { return reinterpret_cast<void*>(glfwGetProcAddress(name)); }
  void present(unsigned framebuffer) override {
    const Size s = size();
    if (s == Size{}) return;
    bind_framebuffer_(GL_READ_FRAMEBUFFER, framebuffer);
    bind_framebuffer_(GL_DRAW_FRAMEBUFFER, 0);
    blit_(0, 0, s.width, s.height, 0, 0, s.width, s.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(window_);
  }
  double clock() const override { return glfwGetTime(); }
  void set_title(const std::string& title) override {
    if (title == title_) return;
    title_ = title;
    glfwSetWindowTitle(window_, title.c_str());
  }
  void resize(Size size) override { glfwSetWindowSize(window_, size.width, size.height); }
  std::string clipboard() override {
    const char* text = glfwGetClipboardString(window_);
    return text ? text : "";
  }
  void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
  void toggle_full_screen() override {
    if (windowed_) {
      const WindowPlacement before = *std::exchange(windowed_, std::nullopt);
      glfwSetWindowMonitor(window_, nullptr, before.x, before.y, before.width, before.height, GLFW_DONT_CARE);
      if (before.maximised) glfwMaximizeWindow(window_);
      return;
    }
    GLFWmonitor* const monitor = monitor_of_window();
    const GLFWvidmode* const mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (!mode || !(windowed_ = placement())) return;
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }
  bool is_window() const override { return true; }
  std::string library() const override { return window_library(); }
  std::optional<WindowPlacement> placement() const override {
    if (windowed_) return windowed_;
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return std::nullopt;
    WindowPlacement now;
    glfwGetWindowPos(window_, &now.x, &now.y);
    glfwGetWindowSize(window_, &now.width, &now.height);
    now.maximised = glfwGetWindowAttrib(window_, GLFW_MAXIMIZED) == GLFW_TRUE;
    return now.width > 0 && now.height > 0 ? std::optional(now) : std::nullopt;
  }
  void place(const WindowPlacement& wanted) override {
    std::vector<Screen> screens;
    int count = 0;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
      Screen screen;
      glfwGetMonitorWorkarea(monitors[i], &screen.x, &screen.y, &screen.width, &screen.height);
      if (screen.width > 0 && screen.height > 0) screens.push_back(screen);
    }
    const WindowPlacement placed = fitted(wanted, screens);
    glfwSetWindowPos(window_, placed.x, placed.y);
    glfwSetWindowSize(window_, placed.width, placed.height);
    if (placed.maximised) glfwMaximizeWindow(window_);
  }

 private:
  static WindowSurface& of(GLFWwindow* window) {
    return *static_cast<WindowSurface*>(glfwGetWindowUserPointer(window));
  }
  // Returns the monitor that shows the window's middle, else the first; null without monitors.
  GLFWmonitor* monitor_of_window() const {
    int x = 0, y = 0, width = 0, height = 0, count = 0;
    glfwGetWindowPos(window_, &x, &y);
    glfwGetWindowSize(window_, &width, &height);
    x += width / 2, y += height / 2;
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
      int left = 0, top = 0;
      glfwGetMonitorPos(monitors[i], &left, &top);
      const GLFWvidmode* const mode = glfwGetVideoMode(monitors[i]);
      if (mode && x >= left && x < left + mode->width && y >= top && y < top + mode->height) return monitors[i];
    }
    return glfwGetPrimaryMonitor();
  }
  // Cursor positions are in screen coordinates; on some systems these are not pixels.
  // Buttons and wheel act where the mouse is, even if a script has moved the pointer since the mouse moved.
  void tell_mouse() {
    if (mouse_) pending_.push_back(*mouse_);
  }
  MouseMove in_pixels(double x, double y) const {
    int width = 1, height = 1, pixels_x = 1, pixels_y = 1;
    glfwGetWindowSize(window_, &width, &height);
    glfwGetFramebufferSize(window_, &pixels_x, &pixels_y);
    if (width > 0 && height > 0)
      x *= static_cast<double>(pixels_x) / width, y *= static_cast<double>(pixels_y) / height;
    return {static_cast<float>(x), static_cast<float>(y)};
  }
  // Polls the first gamepad: GLFW reports its state, not changes. A gamepad that is unplugged releases everything.
  void poll_gamepad() {
    GLFWgamepadstate state{};
    bool found = false;
    for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST && !found; ++id)
      found = glfwJoystickIsGamepad(id) && glfwGetGamepadState(id, &state);
    const auto trigger = [&](int axis) { return found ? (state.axes[axis] + 1) / 2 : 0.0f; };
    const GamepadAxes axes{state.axes[GLFW_GAMEPAD_AXIS_LEFT_X],    state.axes[GLFW_GAMEPAD_AXIS_LEFT_Y],
                           state.axes[GLFW_GAMEPAD_AXIS_RIGHT_X],   state.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y],
                           trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER), trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER)};
    if (axes != pad_axes_) pending_.push_back(pad_axes_ = axes);
    constexpr std::array<int, kPadButtonNames.size()> kButtons{GLFW_GAMEPAD_BUTTON_A, GLFW_GAMEPAD_BUTTON_B,
                                                               GLFW_GAMEPAD_BUTTON_X, GLFW_GAMEPAD_BUTTON_Y};
    for (std::size_t i = 0; i < kButtons.size(); ++i) {
      const bool down = state.buttons[kButtons[i]] == GLFW_PRESS;
      if (down != std::exchange(pad_down_[i], down)) pending_.push_back(GamepadButton{static_cast<PadButton>(i), down});
    }
  }
  GLFWwindow* window_;
  double last_;
  Events pending_;
  std::optional<MouseMove> mouse_;  // where it moved last
  GamepadAxes pad_axes_;
  std::array<bool, kPadButtonNames.size()> pad_down_{};
  std::array<Key, GLFW_KEY_LAST + 2> pressed_{};  // what each key was when it was pressed, by GLFW's code + 1
  std::string title_;
  std::optional<WindowPlacement> windowed_;  // before it filled the screen
  PFNGLBINDFRAMEBUFFERPROC bind_framebuffer_ = nullptr;
  PFNGLBLITFRAMEBUFFERPROC blit_ = nullptr;
};

// Returns GLFW's latest error as text; GLFW reports it only by a callback or this call.
std::string last_error() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "unknown reason";
}

// Returns the version of OpenGL that a window gets without hints.
std::string version_at_hand() {
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* const window = glfwCreateWindow(64, 64, "coaster", nullptr, nullptr);
  if (!window) return "none";
  glfwMakeContextCurrent(window);
  const auto get_string = reinterpret_cast<PFNGLGETSTRINGPROC>(glfwGetProcAddress("glGetString"));
  const GLubyte* const text = get_string ? get_string(GL_VERSION) : nullptr;
  std::string version = text ? reinterpret_cast<const char*>(text) : "an unknown version";
  glfwDestroyWindow(window);
  return version;
}

}  // namespace

std::string window_library() {
  int major = 0, minor = 0, revision = 0;
  glfwGetVersion(&major, &minor, &revision);  // of the library at run time, not of the header
  return fmt::format("GLFW {}.{}.{}", major, minor, revision);
}

base::Result<std::unique_ptr<Surface>> make_window(const SurfaceOptions& options) {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  if (!set("DISPLAY") && !set("WAYLAND_DISPLAY"))
    return base::Status{base::Code::graphics, "no display (DISPLAY and WAYLAND_DISPLAY are not set); use --headless"};
#ifdef GLFW_PLATFORM
  // By default GLFW tries Wayland first, whose library prints a line if there is no compositor.
  if (!set("WAYLAND_DISPLAY")) glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
  spare_driver_threads();
  if (!glfwInit())
    return base::Status{base::Code::graphics, fmt::format("no window system: {}; use --headless", last_error())};
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer draws into its own framebuffer
  glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
  GLFWwindow* window = nullptr;
  for (const GlVersion version : kGlVersions) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, version.major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, version.minor);
    window = glfwCreateWindow(options.size.width, options.size.height, options.title.c_str(), nullptr, nullptr);
    if (window) break;
  }
  if (!window) {
    const std::string reason = last_error(), found = version_at_hand();
    glfwTerminate();
    return base::Status{base::Code::graphics, fmt::format("a window needs OpenGL 3.3 core, the driver has {} ({}); use "
                                                          "--headless",
                                                          found, reason)};
  }
  glfwMakeContextCurrent(window);
  glfwSwapInterval(options.vsync ? 1 : 0);
  watch_display(options.lost);
  return std::unique_ptr<Surface>(std::make_unique<WindowSurface>(window));
}

}  // namespace coaster::platform
