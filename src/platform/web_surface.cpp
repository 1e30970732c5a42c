// The surface of a browser's page: its canvas, by Emscripten's html5.h, and a WebGL 2 context.
#include <emscripten.h>
#include <malloc.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include <GL/glcorearb.h>
#include <emscripten/html5.h>

#include "platform/events.h"
#include "platform/surface.h"
#include "platform/touch.h"

extern "C" void* emscripten_webgl_get_proc_address(const char* name);

namespace coaster::platform {
namespace {

// Transform feedback is read by mapping a buffer, which WebGL lacks, so this returns a copy of its bytes.
void* mapped = nullptr;
void* map_range(GLenum target, GLintptr offset, GLsizeiptr length, GLbitfield) {
  mapped = std::malloc(static_cast<std::size_t>(length));
  // clang-format off
  EM_ASM({ GLctx.getBufferSubData($0, $1, HEAPU8, $2, $3); }, target, offset, mapped, length);
  // clang-format on
  return mapped;
}
GLboolean unmap(GLenum) {
  std::free(std::exchange(mapped, nullptr));
  return GL_TRUE;
}

// Returns null for functions that a page lacks.
void* web_gl_function(const char* name) {
  if (std::strcmp(name, "glMapBufferRange") == 0) return reinterpret_cast<void*>(&map_range);
  if (std::strcmp(name, "glUnmapBuffer") == 0) return reinterpret_cast<void*>(&unmap);
  return emscripten_webgl_get_proc_address(name);
}

// A page knows the layout only by the keys that are pressed.
class WebKeyboard {
 public:
  // Returns the key of an event. A layout is of another script from the first letter of it on.
  KeyPress read(const EmscriptenKeyboardEvent& event, bool down, Modifiers held);
  // Returns the text that the event types, in which AltGr or Option may be held; "" for none.
  std::string text(const EmscriptenKeyboardEvent& event, Modifiers held) const;
  void release() { alt_graph_ = false; }

 private:
  bool alt_graph_ = false, other_script_ = false;
};

struct NamedKey {
  const char* code;
  Key key;
};
// clang-format off
constexpr NamedKey kNamedKeys[] = {
    {"Space", Key::space}, {"Quote", Key::apostrophe}, {"Comma", Key::comma}, {"Minus", Key::minus},
    {"Period", Key::period}, {"Slash", Key::slash}, {"Semicolon", Key::semicolon}, {"Equal", Key::equal},
    {"BracketLeft", Key::left_bracket}, {"Backslash", Key::backslash}, {"BracketRight", Key::right_bracket},
    {"Backquote", Key::grave}, {"Escape", Key::escape}, {"Enter", Key::enter}, {"Tab", Key::tab},
    {"Backspace", Key::backspace}, {"Insert", Key::insert}, {"Delete", Key::del}, {"ArrowRight", Key::right},
    {"ArrowLeft", Key::left}, {"ArrowDown", Key::down}, {"ArrowUp", Key::up}, {"PageUp", Key::page_up},
    {"PageDown", Key::page_down}, {"Home", Key::home}, {"End", Key::end}, {"Numpad1", Key::keypad_1},
    {"Numpad3", Key::keypad_3}, {"Numpad5", Key::keypad_5}, {"Numpad7", Key::keypad_7},
    {"NumpadEnter", Key::keypad_enter}};
// clang-format on

// Returns the key's place on a US layout.
Key place_of(const EmscriptenKeyboardEvent& event) {
  for (const NamedKey& named : kNamedKeys)
    if (std::strcmp(named.code, event.code) == 0) return named.key;
  const std::string_view code = event.code;
  if (code.size() == 4 && code.starts_with("Key")) return Key{code[3]};
  if (code.size() == 6 && code.starts_with("Digit")) return Key{code[5]};
  if (code.size() >= 2 && code[0] == 'F') {
    const int number = std::atoi(event.code + 1);
    if (number >= 1 && number <= 12) return Key{static_cast<int>(Key::f1) + number - 1};
  }
  return Key{code.starts_with("Numpad") ? 320 : -1};  // one without a name, of the keypad or elsewhere
}

// Returns the character of the event, "" for keys with names of several letters.
std::string_view character_of(const EmscriptenKeyboardEvent& event) {
  const std::string_view typed = event.key;
  return typed.size() == 1 || (!typed.empty() && (typed[0] & 0x80) != 0) ? typed : "";
}

// True if Option makes another character than a letter or digit: @ on macOS.
bool is_option_text(std::string_view print, Modifiers held) {
  const auto is = [&](char first, char last) { return (print[0] | 32) >= first && (print[0] | 32) <= last; };
  return held.alt && !held.ctrl && !print.empty() && !is('a', 'z') && !is('0', '9');
}

KeyPress WebKeyboard::read(const EmscriptenKeyboardEvent& event, bool down, Modifiers held) {
  if (std::strcmp(event.key, "AltGraph") == 0) alt_graph_ = down;
  const Key place = place_of(event);
  const std::string_view print = character_of(event);
  const bool text = (alt_graph_ && down) || is_option_text(print, held);
  if (place >= Key::a && place <= Key::z && !print.empty() && !text) other_script_ = is_other_script(print);
  return {text ? Key::unknown : key_at(place, print, other_script_), down, event.repeat != 0, held, place};
}

std::string WebKeyboard::text(const EmscriptenKeyboardEvent& event, Modifiers held) const {
  const std::string_view print = character_of(event);
  const bool shortcut = held.ctrl || (held.alt && !is_option_text(print, held));
  return std::string(shortcut && !alt_graph_ ? "" : print);
}

constexpr const char* kCanvas = "#canvas";
class WebSurface;
WebSurface* of_page = nullptr;  // for functions that the page calls by name

class WebSurface final : public Surface {
 public:
  WebSurface(EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context, bool window, const SurfaceOptions& options)
      : context_(context), window_(window), size_(window ? Size{} : options.size), lost_(options.lost), last_(clock()) {
    if (!window) return;
    of_page = this;
    listen();
    fit();
  }
  ~WebSurface() override {
    of_page = nullptr;
    emscripten_webgl_destroy_context(context_);
  }

  void poll(Events& events, double) override {
    if (lost_ && emscripten_is_webgl_context_lost(context_)) lost_();
    if (window_) fit();
    for (Event& event : std::exchange(pending_, {})) events.push_back(std::move(event));
    if (!typed_.empty()) {
      for (Event& event : typed_.front()) events.push_back(std::move(event));
      typed_.pop_front();
    }
    follow_fingers(events);
    const double now = clock();
    const double passed = now - std::exchange(last_, now);
    events.push_back(Tick{window_ ? passed : 1.0 / 60.0});
  }
  Size size() const override { return size_; }
  float content_scale() const override {
    return window_ ? static_cast<float>(emscripten_get_device_pixel_ratio()) : content_scale_;
  }
  void* gl_proc(const char* name) override { return web_gl_function(name); }
  void present(unsigned framebuffer) override {
    if (!window_ || size_ == Size{}) return;
    const auto bind = reinterpret_cast<PFNGLBINDFRAMEBUFFERPROC>(gl_proc("glBindFramebuffer"));
    const auto blit = reinterpret_cast<PFNGLBLITFRAMEBUFFERPROC>(gl_proc("glBlitFramebuffer"));
    bind(GL_READ_FRAMEBUFFER, framebuffer);
    bind(GL_DRAW_FRAMEBUFFER, 0);
    blit(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  double clock() const override { return emscripten_get_now() / 1000; }
  void set_title(const std::string& title) override { emscripten_set_window_title(title.c_str()); }
  void resize(Size size) override {
    if (window_ || size == size_) return;
    size_ = size;
    pending_.push_back(Resize{size.width, size.height});
  }
  void set_content_scale(float scale) override { content_scale_ = scale; }
  std::string clipboard() override { return clipboard_; }
  void set_clipboard(const std::string& text) override {
    clipboard_ = text;
    // clang-format off
    if (window_) EM_ASM({ Module.coasterCopy(UTF8ToString($0)); }, text.c_str());
    // clang-format on
  }
  void offer(const std::string& path) override {
    // clang-format off
    if (window_) EM_ASM({ Module.coasterDownload(UTF8ToString($0)); }, path.c_str());
    // clang-format on
  }
  void toggle_full_screen() override {
    if (window_) EM_ASM(Module.coasterFullScreen());
  }
  void end_sound() override {
    // clang-format off
    if (window_) EM_ASM({ for (const device of Object.values(AL.contexts)) device.audioCtx.close(); });
    // clang-format on
  }
  void take_text(bool wanted) override {
    if (!window_ || wanted == std::exchange(takes_text_, wanted)) return;
    // clang-format off
    EM_ASM({ Module.coasterTakesText($0); }, wanted ? 1 : 0);
    // clang-format on
  }
  void answer_by(const std::function<std::string(const std::string& question)>& ask) override { ask_ = ask; }
  void before_leaving(const std::function<bool()>& autosave) override { autosave_ = autosave; }
  bool is_window() const override { return window_; }
  std::string library() const override { return "WebGL 2"; }

  std::string answer(const std::string& question) const { return ask_ ? ask_(question) : ""; }
  bool autosave() const { return autosave_ && autosave_(); }

  // From the page: a file or a link to open, and text that the browser pastes.
  void drop(const char* path) { pending_.push_back(FileDrop{path}); }
  void paste(const char* text) {
    clipboard_ = text;
    for (const bool down : {true, false}) pending_.push_back(KeyPress{Key::v, down, false, {false, true, false}});
  }

  // From a keyboard on the screen: characters to remove, then a text to type, in which a line break is Enter. A key
  // that is pressed again has to be seen released, so each press has a frame and a pause.
  void type(int removed, std::string_view text) {
    const auto press = [&](Key key) {
      typed_.push_back({KeyPress{key, true, false, {}}, KeyPress{key, false, false, {}}});
      typed_.push_back({});
    };
    for (int i = 0; i < removed; ++i) press(Key::backspace);
    for (std::size_t end = 0; !text.empty(); text.remove_prefix(std::min(end + 1, text.size()))) {
      end = std::min(text.find('\n'), text.size());
      if (end > 0) typed_.push_back({TextInput{std::string(text.substr(0, end))}});
      if (end < text.size()) press(Key::enter);
    }
  }

 private:
  // Gives the canvas as many pixels as the screen has for it.
  void fit() {
    double width = 0, height = 0;
    emscripten_get_element_css_size(kCanvas, &width, &height);
    const double scale = emscripten_get_device_pixel_ratio();
    const Size now{static_cast<int>(std::lround(width * scale)), static_cast<int>(std::lround(height * scale))};
    if (now == size_) return;
    size_ = now;
    emscripten_set_canvas_element_size(kCanvas, now.width, now.height);
    pending_.push_back(Resize{now.width, now.height});
  }
  template <class E>
  static Modifiers modifiers_of(const E& event) {
    return {event.shiftKey != 0, event.ctrlKey != 0 || event.metaKey != 0, event.altKey != 0};
  }
  MouseMove at(long x, long y) const {
    const double scale = emscripten_get_device_pixel_ratio();
    return {static_cast<float>(static_cast<double>(x) * scale), static_cast<float>(static_cast<double>(y) * scale)};
  }
  EM_BOOL mouse(int type, const EmscriptenMouseEvent& event) {
    pending_.push_back(at(event.clientX, event.clientY));
    if (type == EMSCRIPTEN_EVENT_MOUSEMOVE) return EM_TRUE;
    constexpr std::array<Button, 3> kButtons{Button::left, Button::middle, Button::right};
    if (event.button < kButtons.size())
      pending_.push_back(MouseButton{kButtons[event.button], type == EMSCRIPTEN_EVENT_MOUSEDOWN, modifiers_of(event)});
    return EM_FALSE;  // a press gives the keyboard to the canvas
  }
  // Follows the fingers since the last frame, up to a press or release that needs a separate frame. Fingers that do not
  // move are followed in every frame, because a press becomes long with time.
  void follow_fingers(Events& events) {
    while (!fingers_.empty()) {
      Fingers& then = fingers_.front();
      const bool now = fingers_.size() == 1;
      if (now || !then.followed) {
        then.followed = touch_.follow(then.down, now ? clock() : then.time, content_scale(), events);
        if (now || !then.followed) return;
      }
      fingers_.pop_front();
    }
  }
  EM_BOOL finger(const EmscriptenTouchEvent& event, bool up) {
    std::vector<Finger> down;
    for (int i = 0; i < event.numTouches; ++i) {
      const EmscriptenTouchPoint& point = event.touches[i];
      if (up && point.isChanged) continue;
      const MouseMove place = at(point.clientX, point.clientY);
      down.push_back({point.identifier, place.x, place.y});
    }
    fingers_.push_back({std::move(down), clock(), false});
    return EM_TRUE;
  }
  EM_BOOL wheel(const EmscriptenWheelEvent& event) {
    const double notch = event.deltaMode == DOM_DELTA_PIXEL ? 100 : event.deltaMode == DOM_DELTA_LINE ? 3 : 1;
    pending_.push_back(at(event.mouse.clientX, event.mouse.clientY));
    pending_.push_back(Wheel{static_cast<float>(-event.deltaX / notch), static_cast<float>(-event.deltaY / notch)});
    return EM_TRUE;
  }
  EM_BOOL key(int type, const EmscriptenKeyboardEvent& event) {
    const bool down = type == EMSCRIPTEN_EVENT_KEYDOWN;
    const Modifiers held = modifiers_of(event);
    const KeyPress press = keyboard_.read(event, down, held);
    if (press.key == Key::v && held == Modifiers{false, true, false}) return EM_FALSE;  // paste() follows
    pending_.push_back(press);
    // macOS reports no release of a key that is pressed with Command.
    if (down && event.metaKey) pending_.push_back(KeyPress{press.key, false, false, held, press.place});
    if (std::string typed = keyboard_.text(event, held); down && !typed.empty())
      pending_.push_back(TextInput{std::move(typed)});
    // The browser's: reload, and Ctrl+Shift+I, its tools.
    return press.place != Key::f5 && !(press.place == Key::i && held.ctrl && (held.shift || held.alt));
  }
  void listen() {
    const auto on_mouse = [](int type, const EmscriptenMouseEvent* e, void* w) {
      return static_cast<WebSurface*>(w)->mouse(type, *e);
    };
    const auto on_key = [](int type, const EmscriptenKeyboardEvent* e, void* w) {
      return static_cast<WebSurface*>(w)->key(type, *e);
    };
    const auto on_touch = [](int type, const EmscriptenTouchEvent* e, void* w) {
      return static_cast<WebSurface*>(w)->finger(
          *e, type == EMSCRIPTEN_EVENT_TOUCHEND || type == EMSCRIPTEN_EVENT_TOUCHCANCEL);
    };
    emscripten_set_touchstart_callback(kCanvas, this, EM_FALSE, on_touch);
    emscripten_set_touchmove_callback(kCanvas, this, EM_FALSE, on_touch);
    emscripten_set_touchend_callback(kCanvas, this, EM_FALSE, on_touch);
    emscripten_set_touchcancel_callback(kCanvas, this, EM_FALSE, on_touch);
    const auto on_wheel = [](int, const EmscriptenWheelEvent* e, void* w) {
      return static_cast<WebSurface*>(w)->wheel(*e);
    };
    const auto on_focus = [](int type, const EmscriptenFocusEvent*, void* w) -> EM_BOOL {
      static_cast<WebSurface*>(w)->keyboard_.release();
      static_cast<WebSurface*>(w)->pending_.push_back(Focus{type == EMSCRIPTEN_EVENT_FOCUS});
      return EM_FALSE;
    };
    emscripten_set_mousemove_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, on_mouse);
    emscripten_set_mousedown_callback(kCanvas, this, EM_FALSE, on_mouse);
    emscripten_set_mouseup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, on_mouse);
    emscripten_set_wheel_callback(kCanvas, this, EM_FALSE, on_wheel);
    emscripten_set_keydown_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, on_key);
    emscripten_set_keyup_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, on_key);
    emscripten_set_focus_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, on_focus);
    emscripten_set_blur_callback(EMSCRIPTEN_EVENT_TARGET_WINDOW, this, EM_FALSE, on_focus);
  }
  EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context_;
  WebKeyboard keyboard_;
  bool window_;
  Size size_;
  std::function<void()> lost_;
  std::function<std::string(const std::string& question)> ask_;
  std::function<bool()> autosave_;
  Events pending_;
  std::deque<Events> typed_;  // one a frame
  bool takes_text_ = false;
  float content_scale_ = 1;  // without a window
  struct Fingers {
    std::vector<Finger> down;
    double time = 0;
    bool followed = false;
  };
  std::deque<Fingers> fingers_;  // after each event of the screen; the last one is kept
  TouchTranslator touch_;
  double last_;
  std::string clipboard_;
};

base::Result<std::unique_ptr<Surface>> make_surface(bool window, const SurfaceOptions& options) {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.alpha = wanted.depth = wanted.antialias = EM_FALSE;  // the renderer draws into its own framebuffer
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE context = emscripten_webgl_create_context(kCanvas, &wanted);
  if (context <= 0 || emscripten_webgl_make_context_current(context) != EMSCRIPTEN_RESULT_SUCCESS)
    return base::Status{base::Code::graphics, "This browser has no WebGL 2, which coaster draws with."};
  emscripten_webgl_enable_extension(context, "EXT_color_buffer_float");
  return std::unique_ptr<Surface>(std::make_unique<WebSurface>(context, window, options));
}

extern "C" {
EMSCRIPTEN_KEEPALIVE void coaster_open(const char* path) {
  if (of_page != nullptr) of_page->drop(path);
}
EMSCRIPTEN_KEEPALIVE void coaster_paste(const char* text) {
  if (of_page != nullptr) of_page->paste(text);
}
EMSCRIPTEN_KEEPALIVE void coaster_type(int removed, const char* text) {
  if (of_page != nullptr) of_page->type(removed, text);
}
EMSCRIPTEN_KEEPALIVE int coaster_autosave() { return of_page != nullptr && of_page->autosave() ? 1 : 0; }
// Returns the value of a query or the place of a widget (app/script_host.h), valid until the next call.
EMSCRIPTEN_KEEPALIVE const char* coaster_answer(const char* question) {
  static std::string text;
  text = of_page != nullptr ? of_page->answer(question) : "";
  return text.c_str();
}
// Bytes that the program has allocated.
EMSCRIPTEN_KEEPALIVE double coaster_allocated() { return static_cast<double>(::mallinfo().uordblks); }
}

}  // namespace

base::Result<std::unique_ptr<Surface>> make_window(const SurfaceOptions& options) {
  return make_surface(true, options);
}
base::Result<std::unique_ptr<Surface>> make_offscreen(const SurfaceOptions& options) {
  return make_surface(false, options);
}
std::string window_library() { return "WebGL 2"; }

}  // namespace coaster::platform
