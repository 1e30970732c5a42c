#include "app/long_job.h"

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

#include <fmt/format.h>

#include "app/program.h"
#include "base/text.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/apply.h"
#include "edit/perform/seek.h"
#include "exchange/formats.h"

namespace coaster::app {
namespace {

// Texts, each after its length: "5 track12 any bytes\n at".
class JobTextWriter {
 public:
  void operator()(std::string_view part) { out_ += fmt::format("{} {}", part.size(), part); }
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void operator()(Number value) {
    if constexpr (std::is_floating_point_v<Number>) (*this)(base::to_text(double{value}));
    else (*this)(std::to_string(static_cast<std::int64_t>(value)));
  }
  // The length of a list.
  template <class List>
  void size_of(const List& list) {
    (*this)(list.size());
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

// Reads them in the same order. After the first error everything is empty.
class JobTextReader {
 public:
  explicit JobTextReader(std::string_view text) : left_(text) {}
  void operator()(std::string& part) {
    part.clear();
    const std::size_t end = std::min(left_.find(' '), left_.size());
    const auto size = base::parse_int(left_.substr(0, end));
    good_ = good_ && size && *size >= 0 && left_.size() - end > static_cast<std::size_t>(*size);
    if (!good_) return;
    part = left_.substr(end + 1, static_cast<std::size_t>(*size));
    left_.remove_prefix(end + 1 + part.size());
  }
  template <class Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
  void operator()(Number& value) {
    std::string part;
    (*this)(part);
    const auto take = [&](const auto& read) { good_ = good_ && read, value = static_cast<Number>(read.value_or(0)); };
    if constexpr (std::is_floating_point_v<Number>) take(base::parse_double(part));
    else take(base::parse_int(part));
  }
  template <class List>
  void size_of(List& list) {
    std::size_t size = 0;
    (*this)(size);
    good_ = good_ && size <= left_.size();
    list.resize(good_ ? size : 0);
  }
  bool done() const { return good_ && left_.empty(); }

 private:
  std::string_view left_;
  bool good_ = true;
};

// Visits the numbers, enumerators and vectors of a component.
template <class Archive, class Component>
void visit_component(Archive& archive, Component& component) {
  std::remove_const_t<Component>::fields([&](const world::Field&, auto member) {
    auto& value = component.*member;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, glm::vec3>)
      archive(value.x), archive(value.y), archive(value.z);
    else archive(value);
  });
}

// Writes or reads what is found, but for its kind and a track's document.
template <class Archive, class T>
void visit_result(Archive& archive, T& found) {
  if constexpr (std::is_same_v<std::remove_const_t<T>, exchange::LoadedTrack>) {
    archive.size_of(found.warnings);
    for (auto& warning : found.warnings) archive(warning);
    archive(found.note), archive(found.knows_speed);
    bool imported = found.import.has_value();
    archive(imported);
    if constexpr (!std::is_const_v<T>)
      if (imported) found.import.emplace();
    if (imported) {  // a new member of the report does not compile before it is named here
      auto& [max_error, frame_error, knots, jump_error, rms_error, rms_frame_error] = *found.import;
      archive(max_error), archive(frame_error), archive(knots), archive(jump_error);
      archive(rms_error), archive(rms_frame_error);
    }
    archive(found.content), archive(found.version);
  } else if constexpr (std::is_same_v<std::remove_const_t<T>, edit::SeekResult>) {
    archive(found.note);
    archive.size_of(found.values);
    for (auto& value : found.values) archive(value);
  } else {
    archive(found.refusal), archive(found.another);
    visit_component(archive, found.closing);
    archive.size_of(found.fit.knots);
    for (auto& knot : found.fit.knots) visit_component(archive, knot);
  }
}

constexpr double kBarAfter = 0.15;  // s: shorter jobs show no bar

BackgroundWork::Work reading(const edit::LoadTrack& command, const std::optional<base::PlannedCrash>& crash) {
  return [command, crash]() -> base::Result<JobResult> {
    base::Files files;
    crash_if_planned(crash, base::CrashPlace::job);
    base::Result<exchange::LoadedTrack> read = exchange::load_track(files, command.path, command.import);
    return read ? base::Result<JobResult>(std::move(*read)) : read.status();
  };
}

BackgroundWork::Work searching(const edit::Session& session, const edit::SeekGoal& command) {
  return [search = edit::search_for(session, command)]() -> base::Result<JobResult> {
    base::Result<edit::SeekResult> sought = search();
    return sought ? base::Result<JobResult>(std::move(*sought)) : sought.status();
  };
}

BackgroundWork::Work planning(const sim::ClosingReplanTask& change, sim::OpenedTrack& opened) {
  return [change, &opened]() -> base::Result<JobResult> { return JobResult(sim::changed_closing(change, opened)); };
}

bool works_beside(const Program& program) {
  const bool slow = program.job_delay > 0;
  return program.by_hand && !program.job && (slow || (program.surface->is_window() && program.options.script.empty()));
}

void start(Program& program, std::unique_ptr<LongJob> job, const edit::Command& command) {
  job->command = command, job->since = program.time.seconds, job->edits = program.session.edits;
  job->slow = program.job_delay > 0, job->frames_left = std::exchange(program.job_delay, 0);
  program.job = std::move(job);
}

void begin_way(Program& program, const edit::Command& command, sim::ClosingReplanTask change,
               std::span<const edit::Command> rest) {
  auto job = std::make_unique<LongJob>();
  job->panel = "Search", job->title = "Planning the closing section again";
  job->cancelled = "Cancelled the change";
  job->closing = std::move(change);
  job->opened = std::make_unique<sim::OpenedTrack>(std::exchange(edit::opened_track_of(program.session), {}));
  job->in_gesture = program.session.history.in_gesture;
  job->rest.assign(rest.begin(), rest.end());
  job->work = std::make_unique<BackgroundWork>(planning(*job->closing, *job->opened), "");
  start(program, std::move(job), command);
}

// Begins what can be done beside the frames for a command; false for most commands.
bool begin_work(const Program& program, const edit::Command& command, LongJob& job) {
  if (const auto* const load = command.as<edit::LoadTrack>()) {
    const exchange::TrackFormat* const format = exchange::format_of(load->path);
    if (!format || !format->parse_watched) return false;
    job.panel = "Import", job.title = "Fitting a track to the imported points";
    const bool pasted = exchange::is_pasted(load->path);
    job.cancelled = "Cancelled the import of " + (pasted ? "pasted points" : load->path);
    job.work = std::make_unique<BackgroundWork>(reading(*load, program.planned_crash), pasted ? "" : load->path);
    return true;
  }
  if (const auto* const seek = command.as<edit::SeekGoal>()) {
    job.panel = "Search", job.title = "Searching for " + seek->goal.text;
    job.cancelled = "Cancelled the search";
    job.work = std::make_unique<BackgroundWork>(searching(program.session, *seek), "");
    return true;
  }
  return false;
}

// Applies a finished job's command, or says why not.
void end_job(Program& program, LongJob& job) {
  edit::Session& session = program.session;
  base::Result<JobResult> found = job.work->take();
  // A cancelled job is dropped with what it keeps, even if the work was faster.
  if (job.opened && !job.work->progress.cancelled) edit::opened_track_of(session) = std::move(*job.opened);
  if (job.work->progress.cancelled) return edit::notify(session, edit::NoticeKind::info, job.cancelled);
  if (!found) return edit::notify(session, found.status());
  edit::ClosingSearch search{.found = std::move(*found), .asked = job.closing};
  if (session.edits != job.edits && std::holds_alternative<edit::SeekResult>(*search.found)) search.found.reset();
  (void)apply(program, job.command, &search);
}

// True for input that begins something on the track: it is for the track as it will be.
bool begins_something(const platform::Event& event) {
  const auto* const button = std::get_if<platform::MouseButton>(&event);
  const auto* const key = std::get_if<platform::KeyPress>(&event);
  const auto* const pad = std::get_if<platform::GamepadButton>(&event);
  return (button && button->down) || (key && key->down) || (pad && pad->down) ||
         std::holds_alternative<platform::TextInput>(event) || std::holds_alternative<platform::Wheel>(event) ||
         std::holds_alternative<platform::FileDrop>(event);
}

// Shows the last picture with a card while a command works. Input that begins something is left out; the rest waits for
// the panels.
void wait_a_moment(Program& program, ui::WaitCard& card, const std::string& title, base::JobProgress& progress) {
  platform::Events events;
  program.surface->poll(events, 0);
  for (const platform::Event& event : events) {
    if (const auto* const tick = std::get_if<platform::Tick>(&event)) program.time.seconds += tick->dt;
    else if (!begins_something(event)) program.held_input.push_back(event);
  }
  const platform::Size size{program.stats.width, program.stats.height};
  if (size.width < 1 || size.height < 1) return;  // there is no picture
  program.gl.BindFramebuffer(GL_FRAMEBUFFER, program.renderer->framebuffer());
  if (card.show(events, {&progress, "Command", title}, size.width, size.height)) progress.cancelled = true;
  if (program.surface->size() == size) program.surface->present(program.renderer->framebuffer());
}

// Returns "Make joints G2" of "Make joints G2, where that is possible."
std::string title_of(const edit::Command& command) {
  const std::string_view help = edit::info(command).help;
  return std::string(help.substr(0, help.find_first_of(",.;:(")));
}

}  // namespace

std::string print_job_result(const base::Result<JobResult>& found) {
  constexpr std::string_view kKinds[] = {"track", "sought", "way"};  // as in JobResult
  JobTextWriter to;
  if (!found) {
    to("failed"), to(found.status().code), to(found.status().message);
    return to.take();
  }
  to(kKinds[found->index()]);
  if (const auto* const track = std::get_if<exchange::LoadedTrack>(&*found)) to(exchange::print_track(track->document));
  std::visit([&](const auto& one) { visit_result(to, one); }, *found);
  return to.take();
}

base::Result<JobResult> parse_job_result(std::string_view text) {
  const base::Status broken{base::Code::io, "what the page's worker sent cannot be read"};
  JobTextReader from(text);
  const auto read = [&](auto one) {
    visit_result(from, one);
    return from.done() ? base::Result<JobResult>(std::move(one)) : broken;
  };
  std::string kind, part;
  from(kind);
  if (kind == "sought") return read(edit::SeekResult{});
  if (kind == "way") return read(sim::ClosingReplanResult{});
  if (kind == "track") {
    from(part);
    auto track = exchange::parse_track(part, "a page's worker");
    return track ? read(std::move(*track)) : broken;
  }
  int code = 0;
  from(code), from(part);
  return kind == "failed" && code != 0 && from.done() ? base::Status{base::Code{code}, std::move(part)} : broken;
}

base::Status apply_watched(Program& program, const edit::Command& command, edit::ClosingSearch* search) {
  constexpr std::size_t kFew = 2000;  // segments: a move of a drag takes less than a frame, as a rule
  edit::Session& session = program.session;
  const bool dragged = session.history.in_gesture;
  if (!works_beside(program) || (dragged && session.document.track.segments.size() < kFew))
    return edit::apply(session, program.files, command, search);
  base::Status applied;
  base::JobProgress progress;
  const std::string title = title_of(command);
  std::unique_ptr<ui::WaitCard> card;
  const auto work = [&] {
    applied = edit::apply(session, program.files, command, search);
    const base::JobScope whole(nullptr);
    if (!applied && progress.cancelled) edit::settle(session);
  };
  watch_work(work, progress, dragged ? 1 : kBarAfter, [&] {
    if (!card) card = program.ui->make_wait_card();
    wait_a_moment(program, *card, title, progress);
  });
  if (!applied && progress.cancelled) edit::notify(session, edit::NoticeKind::info, "Cancelled: " + title);
  return applied;
}

void apply_by_hand(Program& program, const std::vector<edit::Command>& commands) {
  program.by_hand = true;
  for (auto command = commands.begin(); command != commands.end(); ++command) {
    if (program.job && edit::info(*command).effect != edit::Effect::settings) continue;
    if (begin_job(program, *command)) continue;
    edit::ClosingSearch search;
    search.leaves = works_beside(program) && (BackgroundWork::is_quick() || !program.session.history.in_gesture);
    (void)apply(program, *command, &search);  // a rejected command shows a notice
    if (!search.wanted) continue;
    const auto next = static_cast<std::size_t>(command - commands.begin()) + 1;
    begin_way(program, *command, std::move(*search.wanted), std::span(commands).subspan(next));
    break;
  }
  program.by_hand = false;
}

bool begin_job(Program& program, const edit::Command& command) {
  if (!works_beside(program)) return false;
  auto job = std::make_unique<LongJob>();
  if (!begin_work(program, command, *job)) return false;
  start(program, std::move(job), command);
  return true;
}

const LongJob* shown_job(const Program& program) {
  const LongJob* const job = program.job.get();
  if (!job || job->in_gesture) return nullptr;
  return job->slow || program.time.seconds - job->since > kBarAfter ? job : nullptr;
}

platform::Events take_input(Program& program, const platform::Events& events) {
  const bool holds = program.job && program.job->closing && !shown_job(program);
  platform::Events taken = holds ? platform::Events() : std::exchange(program.held_input, {});
  for (const platform::Event& event : events)
    (holds && !std::holds_alternative<platform::Tick>(event) ? program.held_input : taken).push_back(event);
  return taken;
}

void finish_job(Program& program) {
  if (!program.job) return;
  LongJob& running = *program.job;
  // A slow job counts frames only, however fast the work is.
  if (running.slow && !running.work->progress.cancelled && running.frames_left-- > 0) return;
  if (!running.slow && !running.work->done()) return;
  const std::unique_ptr<LongJob> job = std::move(program.job);
  end_job(program, *job);
  apply_by_hand(program, job->rest);
}

}  // namespace coaster::app
