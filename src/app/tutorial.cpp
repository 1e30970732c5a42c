// A script host whose frames are the player's.
#include <utility>

#include "app/script_host.h"
#include "app/tutorial_settings.h"
#include "base/folders.h"
#include "edit/commands/commands_elements.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/commands/set_setting.h"
#include "script/grammar.h"
#include "script/runner.h"
#include "world/settings_groups.h"

namespace coaster::app {

struct TutorialRun {
  script::Script script;
  script::Host host;
  script::RunOptions options;
  world::Settings former;
  script::Runner runner;
  TutorialRun(script::Script what, script::Host by, script::RunOptions with, const world::Settings& now)
      : script(std::move(what)),
        host(std::move(by)),
        options(std::move(with)),
        former(now),
        runner(script, host, options) {}
  TutorialRun(const TutorialRun&) = delete;  // the runner refers to the others
  TutorialRun& operator=(const TutorialRun&) = delete;
};

namespace {

bool strayed(const Program& program) {
  const Tutorial::Start& start = program.tutorial.start;
  return program.session.edits != start.edits && program.session.document != start.document;
}

// Sets those settings to their values at the start of the lesson.
template <auto... Setting>
void restore(Program& program, const world::Settings& start) {
  const auto one = [&]<auto S>() {
    if (const auto value = world::value_in<S>(start); value != world::value_in<S>(program.session.settings))
      (void)apply(program, edit::Set<S>{value});
  };
  (one.template operator()<Setting>(), ...);
}

// Restores track, element and selection of the lesson's start, as far as undo and redo lead there.
void return_to_start(Program& program) {
  const Tutorial::Start& start = program.tutorial.start;
  const bool away = strayed(program);
  while (strayed(program) && !program.session.history.undo.empty() && apply(program, edit::Undo{})) continue;
  while (strayed(program) && !program.session.history.redo.empty() && apply(program, edit::Redo{})) continue;
  if (away) (void)apply(program, edit::set_camera(start.settings.camera));
  const world::Settings& now = program.session.settings;
  if (now.element != start.settings.element)
    (void)apply(program, edit::ChooseElement{start.settings.element});  // it shows the preview
  restore<&world::Aids::show_element, &world::Aids::circuit, &world::Aids::append_mode, &world::Panels::workspace,
          &world::Panels::show_panels>(program, start.settings);
  program.tutorial.card->strayed = false;
  const world::Document& document = program.session.document;
  const bool lives = document.entities.alive(start.settings.selected);
  const world::Entity selected = lives ? start.settings.selected : world::kNone;
  if (now.selected == selected && now.also.empty() && (!lives || now.selected_t == start.settings.selected_t)) return;
  (void)apply(program,
              lives ? edit::Select{{world::name_of(document, selected)}, start.settings.selected_t} : edit::Select{});
}

// The window keeps its size, and the card's buttons answer.
script::Host teaching_host(Program& program) {
  script::Host host = make_script_host(program);
  Program* const p = &program;
  host.set_environment = [](const script::Environment&) { return base::Status{}; };
  host.progress = {};
  host.teach = [p](const query::LessonCard* card) {
    p->tutorial.card = card ? std::optional(*card) : std::nullopt;
    p->tutorial.start = {p->session.document, p->session.settings, p->session.edits};
  };
  host.answer = [p] {
    const query::LessonAnswer answer = std::exchange(p->tutorial.answer, query::LessonAnswer::none);
    if (answer == query::LessonAnswer::show) return_to_start(*p);
    return answer;
  };
  return host;
}

base::Status start(Program& program) {
  base::Files files;
  const std::filesystem::path path = base::data_folder() / "tutorials" / "first_coaster.coaster";
  auto parsed = script::parse_script_file(path, files);
  if (!parsed) return parsed.status();
  if (!parsed->errors.empty()) return {base::Code::usage, parsed->errors.front()};
  const auto out = base::Root().open(
      (program.keeper ? program.keeper->folders.state : std::filesystem::temp_directory_path()) / "tutorial");
  if (!out) return out.status();
  script::RunOptions options;
  options.out = *out;
  program.tutorial.run = std::make_shared<TutorialRun>(std::move(parsed->script), teaching_host(program),
                                                       std::move(options), program.session.settings);
  return program.tutorial.run->runner.begin();
}

}  // namespace

void teach(Program& program) {
  // The player's clicks come before those of the lesson, and not between them.
  if (program.ui && program.ui->input_waits()) return;
  std::optional<base::Status> ended;
  if (std::exchange(program.tutorial.wanted, false) && !program.tutorial.run)
    if (const base::Status started = start(program); !started) ended = started;
  while (program.tutorial.run && !ended) {
    ended = program.tutorial.run->runner.step();
    if (!program.tutorial.run->runner.waits()) continue;
    if (program.tutorial.card) program.tutorial.card->strayed = strayed(program);
    return;
  }
  if (!ended) return;
  if (!*ended) edit::notify(program.session, edit::NoticeKind::error, ended->message);
  end_tutorial(program);
}

void end_tutorial(Program& program) {
  program.tutorial.card.reset();
  const std::shared_ptr<TutorialRun> run = std::move(program.tutorial.run);
  if (!run) return;
  world::for_each_setting([&]<auto Setting>() {
    if constexpr (kLentToTutorial<Setting>)
      if (const auto value = world::value_in<Setting>(run->former);
          value != world::value_in<Setting>(program.session.settings))
        (void)apply(program, edit::Set<Setting>{value});
  });
}

}  // namespace coaster::app
