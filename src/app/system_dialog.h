// The desktop's file dialog: zenity or kdialog, if installed, in a separate process that no frame waits for. A web page
// uses the browser's dialog (web_dialog.cpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/process.h"
#include "ui/context/output.h"

namespace coaster::app {

class SystemDialogProcess {
 public:
  // Looks for the programs in PATH.
  SystemDialogProcess();

  bool available() const { return !program_.empty(); }
  bool running() const { return running_; }
  // Ends the previous dialog. Returns false if it cannot be started.
  bool start(const ui::SystemDialogRequest& request);
  // Polls without waiting: returns the chosen file once the dialog has ended, "" if it was cancelled.
  std::optional<std::string> poll();

 private:
  std::vector<std::string> arguments(const ui::SystemDialogRequest& request) const;

  std::string program_;  // full path
  Process process_;
  bool running_ = false;
};

}  // namespace coaster::app
