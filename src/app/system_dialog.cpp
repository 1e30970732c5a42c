#include "app/system_dialog.h"

#include <filesystem>
#include <utility>

namespace coaster::app {

SystemDialogProcess::SystemDialogProcess() {
  for (const char* const name : {"zenity", "kdialog"})
    if (program_.empty()) program_ = find_program(name);
}

std::vector<std::string> SystemDialogProcess::arguments(const ui::SystemDialogRequest& request) const {
  const std::string start = (std::filesystem::path(request.folder) / request.name).string();
  if (program_.ends_with("kdialog")) return {program_, request.save ? "--getsavefilename" : "--getopenfilename", start};
  std::vector<std::string> words{program_, "--file-selection", "--filename=" + start};
  if (request.save) words.insert(words.end(), {"--save", "--confirm-overwrite"});
  return words;
}

bool SystemDialogProcess::start(const ui::SystemDialogRequest& request) {
  running_ = available() && process_.start(arguments(request)).ok();
  return running_;
}

std::optional<std::string> SystemDialogProcess::poll() {
  const std::optional<int> ended = process_.poll();
  if (!ended) return std::nullopt;
  running_ = false;
  std::string file = std::exchange(process_.output(), {});
  while (file.ends_with('\n')) file.pop_back();
  return *ended == 0 ? file : std::string();
}

}  // namespace coaster::app
