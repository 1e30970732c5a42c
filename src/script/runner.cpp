// Runs statements: blocks, commands, time, input, checks and lessons. runner_output.cpp has those that write files.
#include "script/runner.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "edit/commands/commands_operation.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_settings.h"
#include "platform/events.h"
#include "query/condition.h"
#include "query/context.h"
#include "query/rows.h"
#include "script/paths.h"
#include "script/ui_driver.h"
#include "view/camera.h"
#include "view/gizmo.h"

namespace coaster::script {
namespace {

using platform::Button;
using platform::MouseButton;
using platform::MouseMove;

constexpr int kDragSteps = 6;

std::string name_of(const world::Document& document, const view::Pick& pick) {
  const std::string label = "@" + world::label_of(document, pick.entity);
  switch (pick.kind) {
    case view::PickKind::none: return "nothing";
    case view::PickKind::handle_in: return label + ".in";
    case view::PickKind::handle_out: return label + ".out";
    case view::PickKind::spin: return label + ".spin";
    case view::PickKind::turn: return label + ".turn";
    case view::PickKind::bank: return label + ".bank";
    case view::PickKind::curve: return fmt::format("{}:{}", label, base::to_text(static_cast<float>(pick.t)));
    default: return view::is_gizmo(pick.kind) ? "the gizmo" : label;
  }
}

// The hovered entity must be the target. Ground and world points may be covered by anything except panels.
Status check_hover(FrameDriver& frames, const AimAction& aim) {
  const view::PickKind wanted = aim.target.kind;
  if (wanted == view::PickKind::none || !frames.host().hovered) return {};
  const view::Pick found = frames.host().hovered();
  const query::QueryContext context = frames.host().context();
  const world::Document& document = context.session.document;
  if (found.kind == wanted && (view::is_gizmo(wanted) || found.entity == world::find(document, aim.target.name)))
    return {};
  if (found.kind == view::PickKind::none)
    return failed(fmt::format("nothing can be picked at {}: something covers it", aim.target_text));
  return failed(fmt::format("{} is covered by {}", aim.target_text, name_of(document, found)));
}

// Returns the column of a condition that cannot be checked: of the query without a value, else of what it is compared
// with.
int column_of(const Condition& condition, const std::string& found) {
  return found.empty() || condition.values.empty() ? condition.column : condition.values.front().column;
}

constexpr int kMostLessonFrames = 3600;  // limit for a lesson's lines to take effect

int lessons_in(const Block& block) {
  int count = 0;
  for (const Statement& statement : block) {
    if (std::holds_alternative<Lesson>(statement.action)) ++count;
    if (std::holds_alternative<Include>(statement.action)) count += lessons_in(statement.body);
  }
  return count;
}

}  // namespace

Status run_script(const Script& script, Host& host, const RunOptions& options) {
  Runner runner(script, host, options);
  if (const Status begun = runner.begin(); !begun) return begun;
  for (;;)
    if (const std::optional<Status> ended = runner.step()) return *ended;
}

Status Runner::begin() {
  enter(script_.statements);
  frames_.changed();
  return frames_.host().set_environment(environment_);
}

std::optional<Status> Runner::step() {
  waits_ = false;
  column_ = 0;
  if (const Status result = advance(); !result) return error_of(result);
  return places_.empty() ? std::optional(Status{}) : std::nullopt;
}

// Runs the next statement or the end of a block, or checks the lesson.
Status Runner::advance() {
  if (given_ && places_.size() == given_->depth) return attend();
  BlockPosition& here = places_.back();
  if (here.next < here.block->size()) return run((*here.block)[here.next++]);
  if (here.again-- > 0) return here.next = 0, Status{};
  const bool gesture = here.gesture;
  places_.pop_back();
  if (!gesture) return {};
  running_ = &(*places_.back().block)[places_.back().next - 1];  // the line that began it
  if (!frames_.apply(edit::EndGesture{}))
    return wrong("a command up to end ended the gesture, as undo, load and new do: write it outside");
  return {};
}

Status Runner::error_of(const Status& result) {
  const int column = column_ > 0 ? column_ : running_->column;
  const ScriptError error{source().name, running_->line, column, result.message, origins()};
  if (options_.error != nullptr) *options_.error = error;
  const bool evident = result.code != base::Code::skipped && !frames_.interrupted();
  const std::string note = evident ? write_evidence(error) : std::string();
  return {result.code, describe_error(source(), error, note)};
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

Status Runner::run(const Statement& statement) {
  running_ = &statement;
  if (frames_.host().progress) frames_.host().progress(statement.line, static_cast<int>(source().lines.size()));
  Status result = std::visit([this](const auto& action) { return perform(action); }, statement.action);
  if (frames_.interrupted()) result = failed("stopped by a signal"), column_ = 0;
  return result;
}

std::filesystem::path Runner::input(std::string_view written) const {
  return find_input(source().folder, written, options_.out.folder());
}

void Runner::report_since(std::uint64_t serial) {
  const Host& host = frames_.host();
  if (!host.report) return;
  const query::QueryContext context = host.context();
  for (const edit::Notice& notice : context.session.notices.list)
    if (notice.serial > serial) host.report(notice.text);
}

Status Runner::perform(const RunCommand& run) {
  edit::Command command = run.command;
  const edit::PathUse use = edit::info(command).traits.path;
  if (use == edit::PathUse::opens) {
    std::string& path = *edit::path_of(command);
    path = input(path).string();
    if (auto* const recover = command.as<edit::RecoverTrack>(); recover && !recover->original.empty())
      recover->original = input(recover->original).string();
    // A file that cannot be opened counts as a bad file: the exit code gives the kind of error, not the reason.
    const std::uint64_t before = frames_.host().context().session.notices.serial;
    const Status opened = frames_.apply(command);
    if (!opened) return Status{base::Code::bad_file, opened.message};
    report_since(before);
    return {};
  }
  if (use == edit::PathUse::writes) {
    std::string& path = *edit::path_of(command);
    const auto found = find_output(path, files_.root());
    if (!found) return found.status();
    path = found->string();
  }
  return frames_.apply(command);
}

Status Runner::perform(const SetEnvironment& change) {
  if (change.width) environment_.width = *change.width;
  if (change.height) environment_.height = *change.height;
  if (change.samples) environment_.samples = *change.samples;
  if (change.seed) environment_.seed = *change.seed;
  if (change.scale) environment_.scale = *change.scale;
  if (change.density) environment_.density = *change.density;
  // If only a folder is set, picture and scale stay: its settings may change them.
  const bool home_alone =
      change.home && !change.width && !change.samples && !change.seed && !change.scale && !change.density;
  frames_.changed();
  if (!home_alone)
    if (const Status status = frames_.host().set_environment(environment_); !status) return status;
  if (!change.home) return {};
  if (!frames_.host().set_home) return wrong("this run keeps no user data");
  const auto folder = find_output(change.home->text, files_.root());
  if (!folder) return at(change.home->column, folder.status());
  // Empties the folder at its first use in a run: files of an earlier run would change the result.
  if (std::find(homes_.begin(), homes_.end(), *folder) == homes_.end())
    if (const Status emptied = files_.remove_made(*folder); !emptied) return at(change.home->column, emptied);
  homes_.push_back(*folder);
  return frames_.host().set_home(*folder);
}

Status Runner::perform(const Advance& advance) {
  if (!advance.frames) frames_.advance(advance.count);
  for (std::int64_t i = 0; advance.frames && i < advance.count && !frames_.interrupted(); ++i)
    if (const Status status = frames_.frame({}); !status) return status;
  return {};
}

Status Runner::perform(const Repeat& repeat) {
  if (repeat.count > 0) enter(running_->body, repeat.count - 1);
  return {};
}

Status Runner::perform(const Gesture&) {
  if (const Status status = frames_.apply(edit::BeginGesture{}); !status) return status;
  enter(running_->body, 0, true);
  return {};
}

Status Runner::perform(const Include&) {
  enter(running_->body);
  return {};
}

Status Runner::perform(const Input& given) {
  for (std::size_t i = 0; i < given.steps.size(); ++i) {
    platform::Events events = given.steps[i];
    for (platform::Event& event : events)
      if (platform::FileDrop* const drop = std::get_if<platform::FileDrop>(&event))
        drop->path = input(drop->path).string();
    const std::uint64_t before = frames_.commands();
    if (const Status status = frames_.frame(std::move(events)); !status) return status;
    // This frame's numbers show the effect of a key press, so its release joins the next frame.
    if (given.last_step_can_wait && i + 2 == given.steps.size() && frames_.commands() != before) {
      frames_.put_off(given.steps.back());
      break;
    }
  }
  return {};
}

Status Runner::perform(const FitCamera& fit) {
  if (!frames_.host().viewport) return wrong("no viewport");
  if (const Status status = frames_.settle_panels(); !status) return status;
  const query::QueryContext context = frames_.host().context();
  const edit::Session& session = context.session;
  const view::Viewport viewport = frames_.host().viewport();
  if (fit.selection && !session.settings.selected.valid()) return wrong("nothing is selected");
  const world::Camera& now = session.settings.camera;
  return frames_.apply(
      edit::set_camera(fit.selection ? view::frame_entity(now, session.document, session.settings.selected, viewport)
                                     : view::frame_all(now, session.document, viewport)));
}

Status Runner::perform(const RequireStage& needs) {
  const query::QueryContext context = frames_.host().context();
  const std::string& refusal = context.stats.stage_refusals[static_cast<std::size_t>(needs.stage)];
  if (refusal.empty()) return {};
  return {base::Code::skipped,
          fmt::format("skipped: it needs {}. {}", base::name_of(needs.stage), base::sentence(refusal))};
}

Status Runner::perform(const InjectFault& fault) {
  if (!frames_.host().files) return wrong("this run cannot inject file faults");
  frames_.host().files->inject(fault.operation, fault.nth);
  return {};
}

Status Runner::perform(const base::PlannedCrash& crash) {
  if (!frames_.host().plan_crash) return wrong("this run cannot crash on purpose");
  frames_.host().plan_crash(crash);
  return {};
}

Status Runner::perform(const SlowImport& slow) {
  if (!frames_.host().slow_job) return wrong("this run cannot import");
  frames_.host().slow_job(slow.frames);
  return {};
}

Status Runner::perform(const UiAction& ui) {
  UiDriver driver(frames_);
  const std::string& path = ui.path.text;
  std::error_code ignored;
  const bool below_out = ui.text == "$OUT" || ui.text.starts_with("$OUT/");  // text fields that name files
  const std::string words =
      below_out ? std::filesystem::absolute(options_.out.folder(), ignored).string() + ui.text.substr(4) : ui.text;
  const auto act = [&]() -> Status {
    switch (ui.verb) {
      case UiAction::Verb::click: return driver.click(path);
      case UiAction::Verb::doubleclick: return driver.click(path, 2);
      case UiAction::Verb::hover: return driver.reach(path);
      case UiAction::Verb::check: return driver.check(path, ui.on);
      case UiAction::Verb::type: return driver.type(path, words);
      case UiAction::Verb::drag_by: return driver.drag_by(path, static_cast<float>(ui.number));
      case UiAction::Verb::drag_to: return driver.drag_to(path, *base::parse_double(ui.text));
      case UiAction::Verb::open: return driver.open(path, true);
      case UiAction::Verb::close: return driver.open(path, false);
      case UiAction::Verb::menu: return driver.menu(path);
      case UiAction::Verb::scroll: return driver.scroll(path, ui.number);
    }
    return {};
  };
  return at(ui.path.column, act());
}

Status Runner::perform(const AimAction& aim) {
  const auto at_target = [&](const Status& status) { return at(aim.target_column, status); };
  if (const Status status = frames_.settle_panels(); !status) return status;
  const base::Result<glm::vec2> pixel = frames_.host().pixel_of(aim.target);
  if (!pixel) return at_target(pixel.status());
  glm::vec2 end = *pixel;
  if (aim.verb == AimAction::Verb::drag) {
    AimPoint destination;
    if (aim.to) {
      destination = *aim.to;
    } else {
      const base::Result<glm::vec3> from = frames_.host().position_of(aim.target);
      if (!from) return at_target(from.status());
      destination.position = *from + aim.by.value_or(glm::vec3(0));
    }
    const base::Result<glm::vec2> to = frames_.host().pixel_of(destination);
    if (!to) return at_target(to.status());
    end = *to;
    const float length = glm::distance(glm::floor(end), glm::floor(*pixel)) / environment_.density;
    if (length < platform::kDragThreshold)
      return at_target(
          failed(fmt::format("the drag is {:.1f} pixels long, and shorter than {} is a click: move the camera nearer",
                             length, platform::kDragThreshold)));
  }
  if (const Status status = frames_.frame({MouseMove{pixel->x, pixel->y}}); !status) return status;
  if (const Status covered = check_hover(frames_, aim); !covered) return at_target(covered);
  if (aim.verb == AimAction::Verb::hover) return {};

  const int clicks = aim.verb == AimAction::Verb::doubleclick ? 2 : 1;
  for (int i = 0; i < clicks; ++i) {
    const std::uint64_t before = frames_.commands();
    if (const Status status = frames_.frame({MouseButton{Button::left, true, aim.modifiers}}); !status) return status;
    const int steps = aim.verb == AimAction::Verb::drag ? kDragSteps : 0;
    for (int step = 1; step <= steps; ++step) {
      const glm::vec2 next = *pixel + (end - *pixel) * (static_cast<float>(step) / static_cast<float>(steps));
      if (const Status status = frames_.frame({MouseMove{next.x, next.y}}); !status) return status;
    }
    const platform::Event up = MouseButton{Button::left, false, aim.modifiers};
    // A click that takes effect at the press leaves the release to the next frame, so that the last frame's numbers
    // show the effect.
    const bool done = frames_.commands() != before && steps == 0 && i + 1 == clicks;
    if (done) frames_.put_off({up});
    else if (const Status status = frames_.frame({up}); !status) return status;
  }
  return {};
}

// A running ride changes the queries of its trains by itself; any other changes them only by a statement or input.
std::string Runner::stands_still(const Condition& condition) const {
  const bool moves = condition.query.starts_with("ride.fail") ||
                     (condition.query.starts_with("ride.") && query::has_row(query::ride_rows(), condition.query));
  if (!moves || frames_.has_put_off()) return {};
  const query::QueryContext context = frames_.host().context();
  const edit::Session& session = context.session;
  if (session.motion.carts.size() == 0) return "there is no train: write add_cart @s1 at 0, then ride.start";
  switch (session.motion.state) {
    case world::RideState::running: return {};
    case world::RideState::stopped: return "the ride was never started, or was stopped: write ride.start first";
    case world::RideState::paused: return "the ride is paused: write ride.start to continue it";
    case world::RideState::ended:
    case world::RideState::failed: break;
  }
  const std::string failure = edit::failure_text(session);
  return failure.empty() ? "the ride has ended" : failure;
}

base::Result<query::Value> Runner::value_of(std::string_view query, const std::string& argument) {
  const query::Query* const row = query::find_query(query);
  COASTER_CHECK(row, "the grammar rejects unknown queries");
  query::QueryContext context = frames_.host().context();
  context.widget = [this](std::string_view path) -> base::Result<query::Widget> {
    if (const Status status = frames_.settle_panels(); !status) return status;
    const std::vector<query::Widget> widgets = frames_.host().widgets();
    const base::Result<std::size_t> found = find_widget(widgets, path);
    if (!found) {
      const bool absent = find_widgets(widgets, path).empty();
      return Status{absent ? base::Code::refused : base::Code::usage, found.status().message};
    }
    return widgets[*found];
  };
  return row->evaluate(context, argument);
}

base::Result<bool> Runner::check(const Condition& condition, std::string& found) {
  const query::Query* const query = query::find_query(condition.query);
  const base::Result<query::Value> value = value_of(condition.query, condition.argument);
  found.clear();
  if (!value) return value.status();
  found = describe(*query, *value);
  return holds(condition, *value);
}

Status Runner::perform(const Expect& expect) {
  if (const Status status = frames_.settle(); !status) return status;
  const Condition& condition = expect.condition;
  std::string found;
  const base::Result<bool> result = check(condition, found);
  if (!result) return at(column_of(condition, found), result.status());
  if (*result) return {};
  return at(condition.column,
            failed(fmt::format("{}{}, {}", condition.negated ? "expected not " : "expected ", condition.text, found)));
}

// While the widget or entity that the condition names is missing, the condition is not met.
Status Runner::perform(const Wait& wait) {
  std::string found;
  for (std::int64_t i = 0;; ++i) {
    const base::Result<bool> result = check(wait.condition, found);
    if (result && *result) return {};
    if (!result && result.status().code != base::Code::refused)
      return at(column_of(wait.condition, found), result.status());
    if (!result) found = result.status().message;
    const std::string still = stands_still(wait.condition);
    if (i == wait.most || !still.empty() || frames_.interrupted())
      return at(wait.condition.column,
                {base::Code::timeout, fmt::format("waited {} {} for {}, {}{}{}", i, wait.frames ? "frames" : "ticks",
                                                  wait.condition.text, found, still.empty() ? "" : "; ", still)});
    if (!wait.frames) frames_.advance(1);
    else if (const Status status = frames_.frame({}); !status) return status;
  }
}

Status Runner::perform(const ExpectFile& expect) {
  const auto differs = [&](std::string message) { return at(expect.path.column, failed(std::move(message))); };
  base::Files files;
  const std::filesystem::path path = input(expect.path.text);
  const base::Result<std::string> bytes = files.read(path);
  if (!expect.same_as) {
    if (bytes.ok() != expect.negated) return {};
    return differs(expect.negated ? path.string() + ": exists" : bytes.status().message);
  }
  if (!bytes) return differs(bytes.status().message);
  const base::Result<std::string> wanted = files.read(input(expect.same_as->text));
  if (!wanted) return at(expect.same_as->column, failed(wanted.status().message));
  if ((*bytes == *wanted) != expect.negated) return {};
  if (expect.negated) return differs("the files are the same");
  const auto [a, b] = std::mismatch(bytes->begin(), bytes->end(), wanted->begin(), wanted->end());
  std::string how = frames_.host().compare_pictures ? frames_.host().compare_pictures(*bytes, *wanted) : "";
  if (how.empty() && (*bytes + *wanted).find('\0') == std::string::npos)
    how = fmt::format("from line {} on", 1 + std::count(bytes->begin(), a, '\n'));
  else if (how.empty()) how = fmt::format("from byte offset {} on", a - bytes->begin());
  return differs(fmt::format("{} differs from {} {}", path.string(), expect.same_as->text, how));
}

Status Runner::perform(const ExpectError& expect) {
  std::string message = expect.out_of_range;
  if (message.empty()) {
    const Statement& statement = expect.statement.front();
    const Status result = std::visit([this](const auto& action) { return perform(action); }, statement.action);
    if (result) return at(statement.column, failed("expected an error, but the statement succeeded"));
    message = result.message;
  }
  if (!expect.contains || message.find(*expect.contains) != std::string::npos) return {};
  return at(expect.statement.front().column,
            failed(fmt::format("expected an error with {}, found {}", base::quoted_start(*expect.contains),
                               base::quoted_start(message))));
}

Status Runner::perform(const Lesson& lesson) {
  const Host& host = frames_.host();
  const query::LessonCard card{lesson.text, lesson.widget ? lesson.widget->text : "", ++lessons_,
                               std::max(lessons_, lessons_in(script_.statements))};
  if (host.teach) host.teach(&card);
  given_ = ActiveLesson{running_, places_.size()};
  if (host.answer) return {};
  std::string found;
  const base::Result<bool> before = check(lesson.until, found);
  if (before && *before)
    return at(lesson.until.column, failed("the lesson's condition already holds: " + lesson.until.text));
  enter(running_->body);
  return {};
}

Status Runner::attend() {
  const Host& host = frames_.host();
  ActiveLesson& given = *given_;
  const Lesson& lesson = std::get<Lesson>(given.lesson->action);
  running_ = given.lesson;
  // The player gets the mouse with its buttons up: the last line may have put off a release.
  if (host.answer && frames_.has_put_off()) return frames_.frame({});
  const auto end = [&](Status result) {
    given_.reset();
    if (host.teach) host.teach(nullptr);
    return result;
  };
  std::string found;
  const base::Result<bool> done = check(lesson.until, found);
  if (done && *done) return end({});
  if (!host.answer) {
    if (!done) return end(at(lesson.until.column, done.status()));
    const std::string still = stands_still(lesson.until);
    if (still.empty() && given.waited++ < kMostLessonFrames) return frames_.frame({});
    return end(at(lesson.until.column,
                  {base::Code::timeout, fmt::format("the lesson's lines did not reach {}, {}{}{}", lesson.until.text,
                                                    found, still.empty() ? "" : "; ", still)}));
  }
  // If the player built something else, the condition may name a part of the track that does not exist yet.
  const query::LessonAnswer answer = host.answer();
  if (answer == query::LessonAnswer::leave || frames_.interrupted()) {
    for (BlockPosition& place : places_) place.next = place.block->size(), place.again = 0;
    return end({});
  }
  if (answer == query::LessonAnswer::show) {
    enter(running_->body);
    return {};
  }
  waits_ = true;
  return {};
}

}  // namespace coaster::script
