// The newest notice, shown at the bottom of the viewport for a few seconds; in scripts (no clock) until the next one.
// Above it are the warnings of the same command, such as those of a file above the note about its start speed.
#pragma once

#include <cstdint>
#include <string>

#include "edit/session/session.h"
#include "ui/context/ui.h"
#include "view/camera.h"

namespace coaster::ui {

struct Toasts {
  std::string shown;  // "" if there is none
  edit::NoticeKind kind = edit::NoticeKind::info;
  double since = 0;  // s
  double lasts = 0;  // s, time on screen
  std::uint64_t serial = 0;
  double updated = 0;  // s, time of the last update

  // Takes the newest notices of the session and drops the expired ones. While a dialog is `over` them, their time does
  // not run.
  void update(const edit::Session& session, double seconds, bool scripted, bool over = false);
  // Shows a notice of the UI about input that causes no command.
  void show(edit::NoticeKind what, std::string text, double seconds);
  // Returns the time from `seconds` until the notice begins to fade; afterwards 0, without a notice infinity.
  double still_for(double seconds) const;
  void draw(const Ui& ui, const view::Viewport& viewport) const;
};

}  // namespace coaster::ui
