// A script host whose frames are the player's.
#include <utility>

#include "app/frame.h"
#include "app/script_host.h"
#include "app/tutorial_settings.h"
#include "base/folders.h"
#include "edit/commands/commands_settings.h"
#include "platform/signals.h"
#include "script/grammar.h"
#include "script/runner.h"
#include "world/settings_groups.h"

namespace coaster::app {
namespace {

bool ends(const Program& program) { return program.quit || platform::pending_signal() != 0; }

// The window keeps its size, and the card's buttons answer.
script::Host teaching_host(Program& program) {
  script::Host host = make_script_host(program);
  Program* const p = &program;
  host.set_environment = [](const script::Environment&) { return base::Status{}; };
  host.progress = {};
  host.interrupted = [p] { return ends(*p); };
  host.teach = [p](const query::LessonCard* card) { p->tutorial.card = card ? std::optional(*card) : std::nullopt; };
  host.watch = [p]() -> base::Result<query::LessonAnswer> {
    play_frame(*p);
    return std::exchange(p->tutorial.answer, query::LessonAnswer::none);
  };
  return host;
}

void teach(Program& program) {
  base::Files files;
  const std::filesystem::path path = base::data_folder() / "tutorials" / "first_coaster.coaster";
  const auto parsed = script::parse_script_file(path, files);
  if (!parsed || !parsed->errors.empty())
    return edit::notify(program.session, edit::NoticeKind::error,
                        parsed ? parsed->errors.front() : parsed.status().message);
  script::RunOptions run;
  run.out = (program.keeper ? program.keeper->folders.state : std::filesystem::temp_directory_path()) / "tutorial";
  script::Host host = teaching_host(program);
  const base::Status taught = script::run_script(parsed->script, host, run);
  program.tutorial.card.reset();
  if (!taught && !ends(program)) edit::notify(program.session, edit::NoticeKind::error, taught.message);
}

}  // namespace

void run_tutorial(Program& program) {
  const world::Settings former = program.session.settings;
  program.tutorial.running = true;
  teach(program);
  world::for_each_setting([&]<auto Setting>() {
    if constexpr (kLentToTutorial<Setting>)
      if (const auto value = world::value_in<Setting>(former);
          value != world::value_in<Setting>(program.session.settings))
        (void)apply(program, edit::Set<Setting>{value});
  });
  program.tutorial.running = false;
}

}  // namespace coaster::app
