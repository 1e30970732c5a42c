#include "app/script_host.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "app/frame.h"
#include "app/pictures.h"
#include "base/cancellable_job.h"
#include "base/console.h"
#include "base/folders.h"
#include "base/portable_math.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "edit/session/findings.h"
#include "script/grammar.h"
#include "script/runner.h"
#include "script/ui_driver.h"
#include "sim/ground/ground.h"
#include "view/camera.h"
#include "view/gizmo.h"
#include "view/pick.h"
#include "world/appearance_settings.h"
#include "world/sections.h"

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

using script::AimPoint;

// Ends with a frame, so that the viewport is known when a track is opened.
base::Status set_environment(Program& program, const script::Environment& environment) {
  program.surface->resize({environment.width, environment.height});
  program.surface->set_content_scale(environment.density);
  program.renderer->set_samples(environment.samples);
  if (program.session.settings.look->ui_scale != environment.scale)
    if (const base::Status scaled = apply(program, edit::Set<&world::Appearance::ui_scale>{environment.scale}); !scaled)
      return scaled;
  run_frame(program, {platform::Resize{environment.width, environment.height}, platform::Tick{0}}, 0);
  return {};
}

// Sets a script's size on the surface first, so that this frame already has it.
base::Status frame(Program& program, platform::Events events, int ticks) {
  for (const platform::Event& event : events)
    if (const auto* const resize = std::get_if<platform::Resize>(&event))
      program.surface->resize({resize->width, resize->height});
  if (program.surface->is_window()) {
    platform::Events ignored;  // keeps the window system responsive; only the script provides input
    program.surface->poll(ignored, 0);
  }
  film(program, ticks, [&](int some) {
    events.push_back(platform::Tick{some * world::kTick});
    run_frame(program, events, some);
    events.clear();
  });
  return {};
}

base::Result<glm::vec3> position_of(Program& program, const AimPoint& aim) {
  edit::Session& session = program.session;
  if (aim.kind == view::PickKind::none) {
    glm::vec3 place = aim.position;
    if (aim.on_ground)
      place.y = static_cast<float>(edit::SessionFindings(session).ground().surface(double{place.x}, double{place.z}));
    return place;
  }
  if (view::is_gizmo(aim.kind)) {
    const auto gizmo = view::gizmo_of(session.document, session.settings, program.picture.view);
    if (!gizmo) return base::Status{base::Code::refused, "there is no gizmo: select a knot"};
    return view::gizmo_place(*gizmo, view::mark_scale(session.settings, program.picture.view), aim.kind);
  }
  const world::Entity entity = world::find(session.document, aim.name);
  const std::string label = "@" + world::to_text(aim.name);
  if (!entity.valid()) return base::Status{base::Code::refused, "there is no " + label};
  if (aim.kind == view::PickKind::spin) {
    const auto ring = view::spin_ring_of(session.document, session.settings, program.picture.view);
    if (!ring || ring->knot != entity)
      return base::Status{base::Code::refused, fmt::format("{} has no spin ring: select it alone", label)};
    return glm::vec3(ring->handle());
  }
  const bool handle = view::is_section_handle(aim.kind);
  if (handle && (!view::section_handles_show(session.settings) || session.settings.selected != entity))
    return base::Status{base::Code::refused,
                        fmt::format("{} shows no handles: select it alone, in the workspace build", label)};
  const auto position = view::position_of(session.document, session.derived, session.motion, aim.kind, entity, aim.t);
  if (!position && handle)
    return base::Status{base::Code::refused,
                        label + " has no such handle: its kind is " +
                            std::string(world::kind_name(world::section(session.document, entity)))};
  if (!position) return base::Status{base::Code::refused, label + " has no place on the screen"};
  return *position;
}

// Returns a car's middle, or the nearest pixel of the car if a mark covers it, as a user would click.
glm::vec2 uncovered(Program& program, const AimPoint& aim, glm::vec2 middle) {
  const edit::Session& session = program.session;
  const view::Pick wanted{view::PickKind::cart, world::find(session.document, aim.name)};
  const auto is_cart = [&](glm::vec2 at) {
    return view::pick(session.document, session.derived, session.motion, session.settings, program.picture.view, at) ==
           wanted;
  };
  constexpr int kReach = 40, kStep = 2, kDirections = 16;  // px
  if (is_cart(middle)) return middle;
  for (int radius = kStep; radius <= kReach; radius += kStep)
    for (int i = 0; i < kDirections; ++i) {
      const float angle = static_cast<float>(2 * base::kPi) * static_cast<float>(i) / kDirections;
      const glm::vec2 at = middle + static_cast<float>(radius) * glm::vec2(std::sin(angle), -std::cos(angle));
      if (is_cart(at)) return at;
    }
  return middle;
}

// Only selected knots show handles.
base::Result<glm::vec2> pixel_of(Program& program, const AimPoint& aim) {
  const auto position = position_of(program, aim);
  if (!position) return position.status();
  const view::View& view = program.picture.view;
  const auto pixel = view::project(view, *position);
  if (!pixel || !view.viewport.contains({pixel->x, pixel->y}))
    return base::Status{base::Code::expectation, "the target is not on the screen (camera all shows the whole track)"};
  const glm::vec2 at(pixel->x, pixel->y);
  return aim.kind == view::PickKind::cart ? uncovered(program, aim, at) : at;
}

// Shows a line that is updated in place, only on terminals.
void progress(int line, int lines) { base::print_progress(fmt::format("line {} of {} ", line, lines)); }

bool strayed(const Program& program) {
  const Tutorial::Start& start = program.tutorial.start;
  return program.session.edits != start.edits && program.session.document != start.document;
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
  take_settings<&world::EditingAids::show_element, &world::EditingAids::circuit, &world::EditingAids::append_mode,
                &world::Panels::workspace, &world::Panels::show_panels>(program, start.settings);
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
  const auto out = base::FileRoot().open(
      (program.keeper ? program.keeper->folders.state : std::filesystem::temp_directory_path()) / "tutorial");
  if (!out) return out.status();
  script::RunOptions options;
  options.out = *out;
  program.tutorial.run = std::make_shared<TutorialRun>(std::move(parsed->script), teaching_host(program),
                                                       std::move(options), program.session.settings);
  return program.tutorial.run->runner.begin();
}

}  // namespace

std::string answer(Program& program, std::string_view question) {
  constexpr std::string_view kWidget = "widget ";
  if (question.starts_with(kWidget)) {
    const std::vector<query::Widget>& all = program.ui->widgets();
    const auto found = script::find_widget(all, question.substr(kWidget.size()));
    if (!found || !all[*found].visible || !all[*found].enabled || all[*found].covered) return {};
    return fmt::format("{} {}", all[*found].x + all[*found].width / 2, all[*found].y + all[*found].height / 2);
  }
  const std::size_t end = std::min(question.find(' '), question.size());
  const query::Query* const row = query::find_query(question.substr(0, end));
  if (row == nullptr) return {};
  const auto value = row->evaluate(context_of(program), question.substr(std::min(end + 1, question.size())));
  return value ? query::to_text(*value) : "";
}

script::Host make_script_host(Program& program) {
  script::Host host;
  Program* const p = &program;
  host.set_environment = [p](const script::Environment& environment) { return set_environment(*p, environment); };
  host.apply = [p](const edit::Command& command) { return apply(*p, command); };
  host.frame = [p](const platform::Events& events, int ticks) { return frame(*p, events, ticks); };
  host.advance = [p](int ticks) { film(*p, ticks, [p](int some) { advance(*p, some); }); };
  host.slow_job = [p](int frames) { p->job_delay = frames; };
  host.plan_crash = [p](const base::PlannedCrash& plan) { p->planned_crash = plan; };
  host.start_movie = [p](const std::filesystem::path& folder, int fps, bool gif) {
    return start_movie(*p, {folder, fps, gif, p->files.root()});
  };
  host.stop_movie = [p] {
    if (!p->filming) return base::Status{base::Code::refused, "no movie is being recorded"};
    return finish_movie(*p);
  };
  host.context = [p]() -> query::QueryContext { return context_of(*p); };
  host.widgets = [p] { return p->ui->widgets(); };
  host.pixel_of = [p](const AimPoint& aim) { return pixel_of(*p, aim); };
  host.position_of = [p](const AimPoint& aim) { return position_of(*p, aim); };
  host.screenshot = [p](const std::filesystem::path& path) { return write_picture(*p, path); };
  host.sheet = [p](const std::filesystem::path& path, int columns, bool half,
                   std::span<const std::filesystem::path> pictures) {
    return write_sheet(p->files.root(), path, columns, half, pictures);
  };
  host.snap = [p](const std::string& name, const std::filesystem::path& golden, const std::filesystem::path& folder,
                  bool update) { return compare_picture(*p, name, golden, folder, update); };
  host.compare_pictures = picture_difference;
  host.commands = [p] { return p->commands; };
  host.hovered = [p] { return p->picture.hovered; };
  host.viewport = [p] { return p->picture.view.viewport; };
  host.progress = progress;
  host.print = [](std::string_view line) { base::print(fmt::format("{}\n", line)); };
  if (!program.surface->is_window()) host.report = [](std::string_view notice) { base::print_error(notice); };
  host.set_home = [p](const std::filesystem::path& folder) {
    stop_keeping(*p, false);
    p->quit = false;
    start_keeping(*p, {folder, folder}, p->files.root(), false);
    for (int i = 0; i < 2; ++i) run_frame(*p, {platform::Tick{0}}, 0);  // lays out a dialog that opens
    return base::Status{};
  };
  host.interrupted = [] { return base::interrupted(); };
  host.files = &program.files;
  host.window = program.surface->is_window();
  return host;
}

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
    if constexpr (kLentToTutorial<Setting>) take_settings<Setting>(program, run->former);
  });
}

}  // namespace coaster::app
