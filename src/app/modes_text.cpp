// The modes that draw nothing: they check files or print the report of a ride.
#include <fmt/format.h>

#include "app/mode_parts.h"
#include "base/console.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_session.h"
#include "edit/perform/apply.h"
#include "edit/session/ride_report.h"
#include "exchange/challenge_file.h"
#include "exchange/formats.h"
#include "exchange/own/link.h"
#include "query/challenge.h"
#include "sim/shape/folds.h"

namespace coaster::app {
namespace {

// Checks that a challenge's start track does not pass it, without a picture.
base::Status validate_challenge(const std::string& path) {
  base::Files files;
  edit::Session session = edit::make_session({});
  session.game.referee = query::referee();
  if (const base::Status begun = edit::apply(session, files, edit::StartChallenge{path}); !begun) return begun;
  print_notices(session);
  edit::Verdict verdict = session.game.referee.judge(session, nullptr);
  if (session.game.challenge->file.judged != exchange::Judged::build &&
      edit::apply(session, files, edit::RideStart{})) {
    const int most = static_cast<int>(exchange::kMaxChallengeSeconds) * world::kTicksPerSecond;
    edit::advance(session, most);
    verdict = session.game.challenge->last;
    if (session.game.challenge->judged == 0) verdict.reason = "its ride does not end";
  }
  if (verdict.medal > 0)
    return {base::Code::bad_file,
            fmt::format("{}: error: its start track passes it already ({}): expected one that does not", path,
                        query::medal_name(verdict.medal))};
  base::print(fmt::format("{}: the start track does not pass, as it must: {}\n", path, verdict.reason));
  return {};
}

base::Status validate_file(const std::string& path) {
  base::Files files;
  if (std::filesystem::path(path).extension() == ".json")
    if (const auto text = files.read(path); text && exchange::looks_like_challenge(*text))
      return validate_challenge(path);
  const auto track = exchange::load_track(files, path);
  if (!track) {
    base::Status status = track.status();
    if (!exchange::is_link(path) && !exchange::format_of(path)) status.message += ", or a script ending in .coaster";
    return status;
  }
  for (const std::string& warning : track->warnings) base::print_error(warning);
  const sim::Derived shapes = sim::shapes_of(track->document);
  for (const std::string& text :
       {sim::tight_text(sim::tight_bends_of(shapes)), sim::deadlock_text(track->document, shapes)})
    if (!text.empty()) base::print_error(fmt::format("{}: warning: {}", path, text));
  return {};
}

}  // namespace

int run_validate(const Options& options) {
  ScriptErrors errors;
  for (const std::string& path : {options.file, options.script}) {
    if (path.empty()) continue;
    const bool script = path == options.script || std::filesystem::path(path).extension() == ".coaster";
    if (const base::Status valid = script ? read_script(path, errors).status() : validate_file(path); !valid)
      return finish_script(options, valid, errors);
  }
  if (!options.json) base::print("ok\n");
  return finish_script(options, {}, {});
}

int run_report(const Options& options) {
  base::Files files;
  edit::Session session = edit::make_session({});
  if (const base::Status opened = edit::apply(session, files, edit::Load{track_of(options).string()}); !opened)
    return finish({base::Code::bad_file, opened.message});
  print_notices(session);
  if (const base::Status limits = open_envelope(session, files, options); !limits) return finish(limits);
  const auto report = options.json ? edit::ride_report_json(session) : edit::ride_report(session);
  if (!report) return finish({base::Code::refused, "the track has no train, so there is no ride to report"});
  base::print(*report);
  return finish({});
}

}  // namespace coaster::app
