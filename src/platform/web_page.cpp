// What a page has in place of a desktop: the browser's loop, which runs before each repaint of the page, and its
// encoder, WebCodecs by packaging/web/movie.js. It knows no fonts of the system.
#include <emscripten.h>

#include <cstdlib>
#include <utility>

#include "platform/system.h"

namespace coaster::platform {
namespace {

struct Loop {
  std::function<bool()> step;
  std::function<int()> finish;
};

void run_step(void* data) {
  Loop* const loop = static_cast<Loop*>(data);
  if (loop->step()) return;
  emscripten_cancel_main_loop();
  const int code = loop->finish();
  delete loop;
  emscripten_force_exit(code);
}

// clang-format off
EM_JS(int, js_has_encoder, (), { return Module.coasterMovie !== undefined && Module.coasterMovie.can() ? 1 : 0; });
EM_JS(void, js_begin, (int rate), { Module.coasterMovie.begin(rate); });
EM_JS(void, js_end, (), { Module.coasterMovie.end(); });
EM_JS(int, js_waiting, (), { return Module.coasterMovie.waiting(); });
EM_JS(void, js_add, (const void* rgba, int width, int height), {
  Module.coasterMovie.add(HEAPU8.slice(rgba, rgba + 4 * width * height), width, height);
});
EM_JS(void, js_finish, (const char* name), { Module.coasterMovie.finish(UTF8ToString(name)); });
EM_JS(double, js_part, (), { return Module.coasterMovie.part(); });
// What is to be said at the end, or why it failed; "" before.
EM_JS(char*, js_said, (int failure), {
  const text = failure ? Module.coasterMovie.failed : Module.coasterMovie.said;
  const size = lengthBytesUTF8(text) + 1;
  const copy = _malloc(size);
  stringToUTF8(text, copy, size);
  return copy;
});
// clang-format on

std::string said(bool failure) {
  char* const text = js_said(failure ? 1 : 0);
  std::string copy = text;
  std::free(text);
  return copy;
}

}  // namespace

int run_frames(std::function<bool()> step, std::function<int()> finish) {
  emscripten_set_main_loop_arg(run_step, new Loop{std::move(step), std::move(finish)}, 0, 0);
  return 0;
}

bool BrowserEncoder::in_page() { return true; }

base::Result<std::unique_ptr<BrowserEncoder>> BrowserEncoder::start(int rate) {
  if (js_has_encoder() == 0)
    return base::Status{base::Code::refused,
                        "This browser cannot encode movies here. It needs WebCodecs and a page sent by https."};
  js_begin(rate);
  return std::make_unique<BrowserEncoder>();
}

BrowserEncoder::~BrowserEncoder() { js_end(); }
bool BrowserEncoder::ready() const { return js_waiting() < 4; }

base::Status BrowserEncoder::add(int width, int height, std::span<const std::uint8_t> rgba) {
  js_add(rgba.data(), width, height);
  const std::string failed = said(true);
  return failed.empty() ? base::Status{} : base::Status{base::Code::io, "The browser's encoder failed: " + failed};
}

void BrowserEncoder::finish(const std::string& name) { js_finish(name.c_str()); }

std::optional<std::string> BrowserEncoder::poll() {
  std::string text = said(false);
  return text.empty() ? std::nullopt : std::optional(std::move(text));
}

double BrowserEncoder::done() const { return js_part(); }
std::vector<SystemFont> fonts_with(std::vector<unsigned>) { return {}; }

}  // namespace coaster::platform
