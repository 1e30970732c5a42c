// A program without GL: a real session, frames that only count, widgets set by the test.
#pragma once

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "base/scratch_folder.h"
#include "edit/perform/apply.h"
#include "edit/session/session.h"
#include "query/context.h"
#include "script/grammar.h"
#include "script/runner.h"
#include "world/panel_settings.h"

namespace coaster::script {

struct FakeHost {
  edit::Session session = edit::make_session({});
  base::Files files;
  query::FrameStats stats;
  std::vector<query::Widget> widgets;
  world::Workspace elsewhere = world::Workspace::ride;  // has other widgets
  std::vector<query::Widget> elsewhere_widgets;
  std::vector<std::pair<platform::Events, int>> frames;  // what each frame was given
  std::vector<edit::Command> at_release;                 // applied in frames where the left button goes up over them
  std::vector<std::string> printed, reported;
  std::map<std::string, std::string> snapped;
  std::uint64_t commands = 0;
  int changes = 0;  // commands since the last frame; a frame counts them as uploads
  std::string toast;
  Environment environment;

  Host host() {
    Host h;
    h.set_environment = [this](const Environment& e) { return environment = e, base::Status{}; };
    h.apply = [this](const edit::Command& command) { return apply(command); };
    h.frame = [this](const platform::Events& events, int ticks) { return frame(events, ticks); };
    h.advance = [this](int ticks) { edit::advance(session, ticks); };
    h.context = [this]() -> const query::QueryContext {
      toast = session.notices.list.empty() ? "" : session.notices.list.back().text;
      return {session, stats, toast, "title"};
    };
    h.widgets = [this] { return session.settings.panels->workspace == elsewhere ? elsewhere_widgets : widgets; };
    h.pixel_of = [this](const AimPoint& aim) -> base::Result<glm::vec2> {
      const auto position = position_of(aim);
      if (!position) return position.status();
      return glm::vec2(100 + 10 * position->x, 100 - 10 * position->y);
    };
    h.position_of = [this](const AimPoint& aim) { return position_of(aim); };
    h.screenshot = [this](const std::filesystem::path& path) { return files.write_atomic(path, "picture"); };
    h.snap = [this](const std::string& name, const std::filesystem::path& golden, const std::filesystem::path&, bool) {
      snapped[name] = golden.string();
      return base::Status{};
    };
    h.commands = [this] { return commands; };
    h.print = [this](std::string_view line) { printed.emplace_back(line); };
    h.report = [this](std::string_view notice) { reported.emplace_back(notice); };
    h.files = &files;
    return h;
  }

  base::Status apply(const edit::Command& command) {
    const base::Status status = edit::apply(session, files, command);
    ++commands;
    if (status) ++changes;
    return status;
  }

  base::Status frame(const platform::Events& events, int ticks) {
    frames.emplace_back(events, ticks);
    for (const platform::Event& event : events) {
      const auto* const button = std::get_if<platform::MouseButton>(&event);
      if (!button || button->down) continue;
      for (const edit::Command& command : at_release) (void)apply(command);
    }
    edit::advance(session, ticks);
    ++stats.frame;
    stats.uploads = changes;
    changes = 0;
    return {};
  }

  base::Result<glm::vec3> position_of(const AimPoint& aim) const {
    if (aim.kind == view::PickKind::none) return aim.position;
    const world::Entity e = world::find(session.document, aim.name);
    if (!e.valid()) return base::Status{base::Code::refused, "there is no such entity"};
    return world::knot(session.document, e).position;
  }
};

// A folder of this process alone.
inline const std::filesystem::path& test_folder() {
  static const test::ScratchFolder folder;
  return folder.path();
}

// Parses and runs the lines below the header.
inline base::Status run_lines(Host host, const std::string& lines, bool update = false) {
  base::Files files;
  const ParsedScript parsed = parse_script("coaster-script 1\n" + lines, "test.coaster", test_folder(), files);
  if (!parsed.errors.empty()) return {base::Code::usage, parsed.errors.front()};
  const auto out = base::FileRoot().open(test_folder() / "out");
  if (!out) return out.status();
  return run_script(parsed.script, host, {*out, update, {}});
}
inline base::Status run_lines(FakeHost& fake, const std::string& lines, bool update = false) {
  return run_lines(fake.host(), lines, update);
}

}  // namespace coaster::script
