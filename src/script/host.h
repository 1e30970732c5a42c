// The interface from scripts to the running program: plain functions that the app provides. Scripts are independent of
// ImGui and GL.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/crash_guard.h"
#include "base/files.h"
#include "edit/commands/command.h"
#include "platform/events.h"
#include "query/query.h"
#include "query/widget.h"
#include "view/pick.h"

namespace coaster::script {

// A target in the viewport, which the app projects to a pixel.
struct AimPoint {
  view::PickKind kind = view::PickKind::none;  // none: a position of the world
  world::EntityName name;
  double t = 0;            // on a curve
  glm::vec3 position{0};   // for none
  bool on_ground = false;  // its height is that of ground or water there
};

// Session-wide settings of the env line.
struct Environment {
  int width = 640, height = 360;
  std::uint64_t seed = 0;
  float scale = 1, density = 1;
  int samples = 0;
};

struct Host {
  std::function<base::Status(const Environment&)> set_environment;
  std::function<base::Status(const edit::Command&)> apply;  // immediately, between frames
  std::function<base::Status(const platform::Events&, int ticks)>
      frame;                                            // one whole frame: events, UI, commands, ticks, drawing
  std::function<void(int ticks)> advance;               // ticks without drawing
  std::function<const query::QueryContext()> context;   // the last frame and the present state
  std::function<std::vector<query::Widget>()> widgets;  // widgets of the last frame
  std::function<base::Result<glm::vec2>(const AimPoint&)> pixel_of;  // in the last frame's view; an error if off screen
  std::function<base::Result<glm::vec3>(const AimPoint&)> position_of;
  std::function<base::Status(const std::filesystem::path&)> screenshot;  // PNG of the last frame
  std::function<base::Status(const std::filesystem::path&, int columns, bool half,
                             std::span<const std::filesystem::path>)>
      sheet;  // several pictures in one
  // Compares the last frame with a golden PNG; writes new/reference/difference and an HTML page below the folder.
  std::function<base::Status(const std::string& name, const std::filesystem::path& golden,
                             const std::filesystem::path& folder, bool update)>
      snap;
  // The next four may be empty; checks that need them are then skipped or rejected.
  // Returns how two PNG files differ: "in size: ..." or "in 12 of 230400 pixels, ..."; empty if one is no PNG file or
  // their pixels are equal.
  std::function<std::string(std::string_view png, std::string_view other)> compare_pictures;
  std::function<std::uint64_t()> commands;            // number of commands run since the start, from any source
  std::function<view::Pick()> hovered;                // under the cursor in the last frame
  std::function<view::Viewport()> viewport;           // of the last frame
  std::function<void(int line, int lines)> progress;  // before each statement
  std::function<void(std::string_view line)> print;   // to stdout (log, hash log)
  std::function<void(std::string_view notice)>
      report;  // to stderr: notices of opened files; empty where panels show them
  std::function<base::Status(const std::filesystem::path&)>
      set_home;  // uses that folder for settings and autosaves, as after a start; may be empty
  std::function<base::Status(const std::filesystem::path& folder, int fps, bool gif)>
      start_movie;                                            // starts recording all ticks; may be empty
  std::function<void(int frames)> slow_job;                   // delays the next import or search by hand; may be empty
  std::function<void(const base::PlannedCrash&)> plan_crash;  // may be empty
  std::function<base::Status()> stop_movie;                   // waits for the movie's file; may be empty
  std::function<bool()> interrupted;  // true when the system has asked the program to end; may be empty
  // Lessons. teach() shows a card, or hides it if null. answer() returns the card's button that was pressed since the
  // last call. Empty: there is no player, and the script runs the lesson's body.
  std::function<void(const query::LessonCard*)> teach;
  std::function<query::LessonAnswer()> answer;
  base::Files* files = nullptr;
  bool window = false;  // a screen paces the frames
};

}  // namespace coaster::script
