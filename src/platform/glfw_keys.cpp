#define GLFW_INCLUDE_NONE
#include "platform/glfw_keys.h"

#include <GLFW/glfw3.h>
#include <dlfcn.h>

#include <string>

#include "platform/keyboard.h"

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

}  // namespace

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

}  // namespace coaster::platform
