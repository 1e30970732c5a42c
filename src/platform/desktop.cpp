// What a desktop has in place of a page: the loop of frames, and the system's fonts by fontconfig, loaded when a text
// first needs it. It has no encoder of movies.
#include <dlfcn.h>

#include "platform/system.h"

namespace coaster::platform {
namespace {

// Calls a function of fontconfig, whose header is not needed: all objects are pointers.
template <class Result = void*, class... Arguments>
Result call(void* library, const char* name, Arguments... arguments) {
  return reinterpret_cast<Result (*)(Arguments...)>(dlsym(library, name))(arguments...);
}

// Returns the font that has the most of the characters, and removes those that it has; without a path if none has any.
SystemFont take_font(void* fc, std::vector<unsigned>& left) {
  void *const wanted = call(fc, "FcCharSetCreate"), *const pattern = call(fc, "FcPatternCreate"), *null = nullptr;
  for (const unsigned c : left) call<int>(fc, "FcCharSetAddChar", wanted, c);
  call<int>(fc, "FcPatternAddCharSet", pattern, "charset", wanted);
  call<int>(fc, "FcPatternAddBool", pattern, "scalable", 1);
  call<int>(fc, "FcPatternAddBool", pattern, "color", 0);
  call<int>(fc, "FcConfigSubstitute", null, pattern, 0);
  call<void>(fc, "FcDefaultSubstitute", pattern);
  int result = 0;
  const char* path = nullptr;
  void* known = nullptr;
  SystemFont font;
  void* const found = call(fc, "FcFontMatch", null, pattern, &result);
  if (found && call<int>(fc, "FcPatternGetString", found, "file", 0, &path) == 0 &&
      call<int>(fc, "FcPatternGetInteger", found, "index", 0, &font.index) == 0 &&
      call<int>(fc, "FcPatternGetCharSet", found, "charset", 0, &known) == 0 &&
      std::erase_if(left, [&](unsigned c) { return call<int>(fc, "FcCharSetHasChar", known, c) != 0; }) > 0)
    font.path = path;
  font.index &= 0xffff;  // above: an instance of a variable font
  if (found) call<void>(fc, "FcPatternDestroy", found);
  call<void>(fc, "FcPatternDestroy", pattern);
  call<void>(fc, "FcCharSetDestroy", wanted);
  return font;
}

}  // namespace

// NOLINTNEXTLINE(performance-unnecessary-value-param): a web page keeps them
int run_frames(std::function<bool()> step, std::function<int()> finish) {
  while (step()) {
  }
  return finish();
}

bool BrowserEncoder::in_page() { return false; }
base::Result<std::unique_ptr<BrowserEncoder>> BrowserEncoder::start(int) {
  return base::Status{base::Code::refused, "Only a browser has an encoder."};
}
BrowserEncoder::~BrowserEncoder() = default;
bool BrowserEncoder::ready() const { return true; }
base::Status BrowserEncoder::add(int, int, std::span<const std::uint8_t>) { return {}; }
void BrowserEncoder::finish(const std::string&) {}
std::optional<std::string> BrowserEncoder::poll() { return std::nullopt; }
double BrowserEncoder::done() const { return 0; }

std::vector<SystemFont> fonts_with(std::vector<unsigned> characters) {
  std::vector<SystemFont> fonts;
  void* const fc = characters.empty() ? nullptr : dlopen("libfontconfig.so.1", RTLD_LAZY);
  while (fc && !characters.empty()) {
    fonts.push_back(take_font(fc, characters));
    if (!fonts.back().path.empty()) continue;
    fonts.pop_back();
    break;
  }
  return fonts;
}

}  // namespace coaster::platform
