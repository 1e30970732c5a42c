// Recording. Each line is flushed, so a crash loses at most the last second of ticks.
#include "script/recorder.h"

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "base/file_lock.h"
#include "base/text.h"
#include "edit/commands/codec.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "edit/session/session.h"
#include "exchange/formats.h"
#include "world/selection.h"
#include "world/settings_groups.h"

namespace coaster::script {
namespace {

// Returns the commands that restore settings and selection at the start.
std::vector<edit::Command> settings_commands(const edit::Session& session) {
  const world::Settings& s = session.settings;
  std::vector<edit::Command> commands{edit::set_camera(s.camera), edit::SetFlyCamera{s.fly},
                                      edit::SetSnapping{s.snapping.to, s.snapping.step, s.snapping.angle},
                                      edit::ChooseElement{s.element}};
  world::for_each_setting([&]<auto Setting>() { commands.push_back(edit::Set<Setting>{world::value_in<Setting>(s)}); });
  for (std::size_t i = 0; i < std::size(world::kLayers); ++i) {
    const auto layer = static_cast<world::Layer>(i);
    commands.push_back(edit::ShowLayer{layer, s.lab->layers.has(layer)});
  }
  if (s.selected.valid() && session.document.entities.alive(s.selected))
    commands.push_back(edit::Select{{world::name_of(session.document, s.selected)}, s.selected_t});
  const auto names = [&](const std::vector<world::Entity>& several) {
    std::vector<world::EntityName> all;
    for (const world::Entity e : several) all.push_back(world::name_of(session.document, e));
    return all;
  };
  if (const auto knots = world::selected_knots(session.document, s); knots.size() > 1)
    commands.push_back(edit::SelectKnots{edit::Knots(names(knots))});
  if (const auto sections = world::selected_sections(session.document, s); sections.size() > 1)
    commands.push_back(edit::SelectSections{edit::Sections(names(sections))});
  return commands;
}

}  // namespace

base::Result<std::unique_ptr<Recorder>> Recorder::start(const base::Files& files, const std::filesystem::path& path,
                                                        const edit::Session& session) {
  auto folder = base::FileRoot().open(path.has_parent_path() ? path.parent_path() : ".");
  if (!folder) return folder.status();
  base::Files below = files.with(std::move(*folder));
  auto out = below.create(path);
  if (!out) return out.status();
  if (!out->put_in_place()) return base::Status{base::Code::io, path.string() + ": cannot be written"};
  std::unique_ptr<Recorder> recorder(new Recorder(path, std::move(below), std::move(*out)));
  if (const base::Status s = recorder->line("coaster-script 1"); !s) return s;
  if (const base::Status s = recorder->snapshot(session); !s) return s;
  for (const edit::Command& command : settings_commands(session))
    if (const base::Status s = recorder->line(edit::print(command)); !s) return s;
  return recorder;
}

Recorder::~Recorder() { (void)write_ticks(); }

base::Status Recorder::line(const std::string& text) {
  if (out_.write(text + '\n')) return {};
  return {base::Code::io, fmt::format("{}: the recording cannot be written: {}", path_.string(), std::strerror(errno))};
}

base::Status Recorder::write_ticks() {
  if (pending_ticks_ == 0) return {};
  const std::string text = fmt::format("ticks {}", pending_ticks_);
  pending_ticks_ = 0;
  return line(text);
}

base::Status Recorder::snapshot(const edit::Session& session) {
  std::filesystem::path track = path_;
  ++snapshots_;
  track.replace_filename(
      fmt::format("{}{}.json", path_.stem().string(), snapshots_ > 1 ? fmt::format("-{}", snapshots_) : ""));
  if (const base::Status saved = exchange::save_track(files_, track, session.document); !saved) return saved;
  return line("load " + base::quoted(track.filename().string()));
}

base::Status Recorder::command(const edit::Command& command, const edit::Session& after) {
  using edit::RecordedForm;
  const RecordedForm recorded = edit::opens_link(command) ? RecordedForm::line : edit::info(command).traits.recorded;
  if (recorded == RecordedForm::nothing) return {};
  if (const base::Status written = write_ticks(); !written) return written;
  if (recorded == RecordedForm::track) return snapshot(after);
  edit::Command written = command;
  if (std::string* const path = edit::path_of(written); path && recorded == RecordedForm::whole_path)
    *path = base::canonical_path(*path).string();
  return line(edit::print(written));
}

base::Status Recorder::ticks(int count) {
  pending_ticks_ += count;
  return pending_ticks_ >= world::kTicksPerSecond ? write_ticks() : base::Status{};
}

}  // namespace coaster::script
