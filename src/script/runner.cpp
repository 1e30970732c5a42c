// The runner's blocks, commands, time and input.
#include "script/runner.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "query/context.h"
#include "script/paths.h"
#include "view/camera.h"

namespace coaster::script {
namespace {

// Returns the file that a command opens, or null.
std::string* opened_path(edit::Command& command) {
  if (auto* const load = command.as<edit::Load>()) return &load->path;
  if (auto* const recover = command.as<edit::RecoverTrack>()) return &recover->path;
  if (auto* const limits = command.as<edit::LoadEnvelope>()) return &limits->path;
  if (auto* const sections = command.as<edit::OpenSections>()) return &sections->path;
  if (auto* const challenge = command.as<edit::StartChallenge>()) return &challenge->path;
  return nullptr;
}

}  // namespace

base::Status run_script(const Script& script, Host& host, const RunOptions& options) {
  Runner runner(script, host, options);
  if (const base::Status begun = runner.begin(); !begun) return begun;
  for (;;)
    if (const std::optional<base::Status> ended = runner.step()) return *ended;
}

base::Status Runner::begin() {
  enter(script_.statements);
  return frames_.set_environment(environment_);
}

std::optional<base::Status> Runner::step() {
  waits_ = false;
  if (const Failure result = advance(); !result) return error_of(result);
  return places_.empty() ? std::optional(base::Status{}) : std::nullopt;
}

// Runs the next statement or the end of a block, or checks the lesson.
Failure Runner::advance() {
  if (given_ && places_.size() == given_->depth) return attend();
  Place& here = places_.back();
  if (here.next < here.block->size()) return run((*here.block)[here.next++]);
  if (here.again-- > 0) return here.next = 0, Failure{};
  const bool gesture = here.gesture;
  places_.pop_back();
  if (!gesture) return {};
  failed_at_ = &(*places_.back().block)[places_.back().next - 1];  // the line that began it
  if (!frames_.apply(edit::EndGesture{}))
    return wrong("a command up to end ended the gesture, as undo, load and new do: write it outside");
  return {};
}

base::Status Runner::error_of(const Failure& result) {
  const Source& source = script_.sources[static_cast<std::size_t>(failed_at_->source)];
  const int column = result.column > 0 ? result.column : failed_at_->column;
  const ScriptError error{source.name, failed_at_->line, column, result.message, origins()};
  if (options_.error != nullptr) *options_.error = error;
  const bool evident = result.code != base::Code::skipped && !frames_.interrupted();
  const std::string note = evident ? write_evidence(error) : std::string();
  return {result.code, describe_error(source, error, note)};
}

std::vector<Origin> Runner::origins() const {
  std::vector<Origin> from;
  for (std::size_t i = places_.size(); i-- > 1;) {
    const Statement& opener = (*places_[i - 1].block)[places_[i - 1].next - 1];
    const std::string& file = script_.sources[static_cast<std::size_t>(opener.source)].name;
    if (const auto* const repeat = std::get_if<Repeat>(&opener.action))
      from.push_back({file, opener.line, repeat->count - places_[i].again, repeat->count});
    else if (std::holds_alternative<Include>(opener.action)) from.push_back({file, opener.line});
  }
  return from;
}

Failure Runner::run(const Statement& statement) {
  source_ = statement.source;
  if (frames_.host().progress) frames_.host().progress(statement.line, static_cast<int>(source().lines.size()));
  failed_at_ = nullptr;
  Failure result = std::visit([this](const auto& action) { return perform(action); }, statement.action);
  if (frames_.interrupted()) result = failed("stopped by a signal");
  if (!result && !failed_at_) failed_at_ = &statement;
  return result;
}

std::filesystem::path Runner::input(std::string_view written) const {
  return find_input(source().folder, written, options_.out.folder());
}

void Runner::report_since(std::uint64_t serial) {
  const Host& host = frames_.host();
  if (!host.report) return;
  const query::Context context = host.context();
  for (const edit::Notice& notice : context.session.notices.list)
    if (notice.serial > serial) host.report(notice.text);
}

Failure Runner::perform(const RunCommand& run) {
  edit::Command command = run.command;
  if (std::string* const path = opened_path(command)) {
    *path = input(*path).string();
    if (auto* const recover = command.as<edit::RecoverTrack>(); recover && !recover->original.empty())
      recover->original = input(recover->original).string();
    // A file that cannot be opened counts as a bad file: the exit code gives the kind of error, not the reason.
    const std::uint64_t before = frames_.host().context().session.notices.serial;
    const base::Status opened = frames_.apply(command);
    if (!opened) return Failure{base::Code::bad_file, opened.message};
    report_since(before);
    return {};
  }
  if (const std::string* const written = edit::output_path(command)) {
    const auto path = find_output(*written, files_.root());
    if (!path) return failure(path.status());
    edit::set_output_path(command, path->string());
  }
  return failure(frames_.apply(command));
}

Failure Runner::perform(const SetEnvironment& change) {
  if (change.width) environment_.width = *change.width;
  if (change.height) environment_.height = *change.height;
  if (change.samples) environment_.samples = *change.samples;
  if (change.seed) environment_.seed = *change.seed;
  if (change.scale) environment_.scale = *change.scale;
  if (change.density) environment_.density = *change.density;
  // If only a folder is set, picture and scale stay: its settings may change them.
  const bool home_alone =
      change.home && !change.width && !change.samples && !change.seed && !change.scale && !change.density;
  if (!home_alone)
    if (const base::Status status = frames_.set_environment(environment_); !status) return failure(status);
  if (!change.home) return {};
  if (!frames_.host().set_home) return wrong("this run keeps no user data");
  const auto folder = find_output(change.home->text, files_.root());
  if (!folder) return failure(folder.status(), change.home->column);
  // Empties the folder at its first use in a run: files of an earlier run would change the result.
  if (std::find(homes_.begin(), homes_.end(), *folder) == homes_.end())
    if (const base::Status emptied = files_.remove_made(*folder); !emptied)
      return failure(emptied, change.home->column);
  homes_.push_back(*folder);
  return failure(frames_.set_home(*folder));
}

Failure Runner::perform(const Frames& frames) {
  for (std::int64_t i = 0; i < frames.count && !frames_.interrupted(); ++i)
    if (const base::Status status = frames_.frame({}); !status) return failure(status);
  return {};
}

Failure Runner::perform(const Ticks& ticks) {
  frames_.advance(ticks.count);
  return {};
}

Failure Runner::perform(const Repeat& repeat) {
  if (repeat.count > 0) enter(repeat.body, repeat.count - 1);
  return {};
}

Failure Runner::perform(const Gesture& gesture) {
  if (const base::Status status = frames_.apply(edit::BeginGesture{}); !status) return failure(status);
  enter(gesture.body, 0, true);
  return {};
}

Failure Runner::perform(const Include& include) {
  enter(include.body);
  return {};
}

Failure Runner::perform(const Input& given) {
  for (std::size_t i = 0; i < given.steps.size(); ++i) {
    platform::Events events = given.steps[i];
    for (platform::Event& event : events)
      if (platform::Drop* const drop = std::get_if<platform::Drop>(&event)) drop->path = input(drop->path).string();
    const std::uint64_t before = frames_.commands();
    if (const base::Status status = frames_.frame(std::move(events)); !status) return failure(status);
    // This frame's numbers show the effect of a key press, so its release joins the next frame.
    if (given.last_step_can_wait && i + 2 == given.steps.size() && frames_.commands() != before) {
      frames_.put_off(given.steps.back());
      break;
    }
  }
  return {};
}

Failure Runner::perform(const FitCamera& fit) {
  if (!frames_.host().viewport) return wrong("no viewport");
  if (const base::Status status = frames_.settle_panels(); !status) return failure(status);
  const query::Context context = frames_.host().context();
  const edit::Session& session = context.session;
  const view::Viewport viewport = frames_.host().viewport();
  if (fit.selection && !session.settings.selected.valid()) return wrong("nothing is selected");
  const world::Camera& now = session.settings.camera;
  return failure(frames_.apply(
      edit::set_camera(fit.selection ? view::frame_entity(now, session.document, session.settings.selected, viewport)
                                     : view::frame_all(now, session.document, viewport))));
}

Failure Runner::perform(const Needs& needs) {
  const query::Context context = frames_.host().context();
  const std::string& refusal = context.stats.stage_refusals[static_cast<std::size_t>(needs.stage)];
  if (refusal.empty()) return {};
  return {base::Code::skipped,
          fmt::format("skipped: it needs {}. {}", base::name_of(needs.stage), base::sentence(refusal))};
}

Failure Runner::perform(const Fault& fault) {
  if (!frames_.host().files) return wrong("this run cannot inject file faults");
  frames_.host().files->inject(fault.operation, fault.nth);
  return {};
}

Failure Runner::perform(const PlanCrash& crash) {
  if (!frames_.host().plan_crash) return wrong("this run cannot crash on purpose");
  frames_.host().plan_crash(crash.plan);
  return {};
}

Failure Runner::perform(const SlowImport& slow) {
  if (!frames_.host().slow_job) return wrong("this run cannot import");
  frames_.host().slow_job(slow.frames);
  return {};
}

}  // namespace coaster::script
