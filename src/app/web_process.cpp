// A web page cannot start other programs. The browser's file dialog gives the chosen file to the page.
#include <emscripten.h>

#include <cstdlib>
#include <filesystem>
#include <utility>

#include "app/process.h"

namespace coaster::app {
namespace {

// clang-format off
EM_JS(int, open_dialog, (), { return Module.coasterPick ? Module.coasterPick() : 0; });
// Returns "" while it is open, "-" if it was cancelled.
EM_JS(char*, picked_file, (), {
  const path = Module.coasterPicked ? Module.coasterPicked() : "-";
  const size = lengthBytesUTF8(path) + 1, text = _malloc(size);
  stringToUTF8(path, text, size);
  return text;
});
// clang-format on

}  // namespace

std::string find_program(const char*) { return {}; }
Process::~Process() = default;
base::Status Process::start(std::vector<std::string>, int, bool, int) {
  return {base::Code::io, "a page starts no programs"};
}
std::optional<int> Process::poll() { return std::nullopt; }
void Process::end() {}
SystemDialogProcess::SystemDialogProcess() : program_("browser") {}

// Saved files are also downloaded, and the browser asks where to: the suggested name is sufficient.
bool SystemDialogProcess::start(const ui::SystemDialogRequest& request) {
  process_.output() = request.save ? (std::filesystem::path(request.folder) / request.name).string() : "";
  running_ = request.save || open_dialog() != 0;
  return running_;
}

std::optional<std::string> SystemDialogProcess::poll() {
  if (!running_) return std::nullopt;
  std::string path = std::exchange(process_.output(), {});
  if (path.empty()) {
    char* const text = picked_file();
    path = text;
    std::free(text);
  }
  if (path.empty()) return std::nullopt;
  running_ = false;
  return path == "-" ? std::string() : path;
}

}  // namespace coaster::app
