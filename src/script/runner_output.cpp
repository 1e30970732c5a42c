// snap, shot, dump, log, and the evidence of a failure.
#include <fmt/format.h>

#include "exchange/own/json_output.h"
#include "exchange/own/track_file.h"
#include "query/context.h"
#include "query/query.h"
#include "script/paths.h"
#include "script/runner.h"

namespace coaster::script {
namespace {

// Returns a JSON object of the values of all queries. `error`: of the script, put before them; null if there is none.
std::string state_json(const query::QueryContext& context, const ScriptError* error) {
  exchange::JsonMembers all = query::all_values(context);
  if (error != nullptr) all.emplace(all.begin(), "error", exchange::JsonList{to_json(*error)});
  return exchange::json_members(all);
}

// Returns one line per widget: path, kind, position, size, value, state.
std::string widgets_text(std::span<const query::Widget> widgets) {
  std::string text;
  for (const query::Widget& w : widgets) {
    text += fmt::format("{} {} {},{} {}x{}", base::quoted(w.path), w.kind, base::to_text(w.x), base::to_text(w.y),
                        base::to_text(w.width), base::to_text(w.height));
    if (!w.value.empty()) text += " value " + base::quoted(w.value);
    if (!w.visible) text += " out-of-sight";
    if (!w.enabled) text += " disabled";
    if (w.covered) text += " covered";
    text += "\n";
  }
  return text;
}

}  // namespace

std::string Runner::write_evidence(const ScriptError& error) {
  Host& host = frames_.host();
  const query::QueryContext context = host.context();
  const std::filesystem::path& out = options_.out.folder();
  const Status picture = host.screenshot(out / "frame.png");
  Status texts = files_.write_atomic(out / "widgets.txt", widgets_text(host.widgets()));
  if (texts) texts = files_.write_atomic(out / "state.json", state_json(context, &error));
  std::string note = fmt::format("frame {}", context.stats.frame);
  if (picture) note += fmt::format("; {}", (out / "frame.png").string());
  if (texts) note += fmt::format("{}, state.json", picture ? ", widgets.txt" : "; " + (out / "widgets.txt").string());
  if (!picture || !texts) note += fmt::format("; {}", (picture ? texts : picture).message);
  return note;
}

Status Runner::perform(const Snap& snap) {
  if (const Status status = frames_.settle_panels(); !status) return status;
  const std::filesystem::path golden = source().folder / "golden" / (snap.name + ".png");
  const bool again = !snaps_.insert(golden).second, update = options_.update_goldens;
  Status result = frames_.host().snap(snap.name, golden, options_.out.folder(), update && !again);
  if (again && update && result.code == base::Code::expectation)
    result.message = fmt::format("snap {} was taken before in this run, of another picture: give each its own name; {}",
                                 base::quoted_start(snap.name), result.message);
  return result;
}

base::Result<std::filesystem::path> Runner::below_out(std::string_view written) const {
  return find_output(written.starts_with("$OUT") ? std::string(written) : fmt::format("$OUT/{}", written),
                     files_.root());
}

Status Runner::perform(const Shot& shot) {
  const auto path = below_out(shot.path.text);
  if (!path) return at(shot.path.column, path.status());
  if (const Status status = frames_.settle_panels(); !status) return status;
  return frames_.host().screenshot(*path);
}

Status Runner::perform(const Sheet& sheet) {
  if (!frames_.host().sheet) return wrong("this run has no pictures");
  const auto path = below_out(sheet.path.text);
  if (!path) return at(sheet.path.column, path.status());
  std::vector<std::filesystem::path> pictures;
  for (const base::Token& token : sheet.pictures) {
    const auto picture = below_out(token.text);
    if (!picture) return at(token.column, picture.status());
    pictures.push_back(*picture);
  }
  return frames_.host().sheet(*path, sheet.columns, sheet.half, pictures);
}

Status Runner::perform(const Dump& dump) {
  if (const Status status = frames_.settle_panels(); !status) return status;
  const auto stem = find_output("$OUT/" + dump.name, files_.root());
  if (!stem) return stem.status();
  const auto with = [&](const char* ending) { return std::filesystem::path(stem->string() + ending); };
  const query::QueryContext context = frames_.host().context();
  if (const Status s = frames_.host().screenshot(with(".frame.png")); !s) return s;
  if (const Status s = files_.write_atomic(with(".widgets.txt"), widgets_text(frames_.host().widgets())); !s) return s;
  if (const Status s = files_.write_atomic(with(".state.json"), state_json(context, nullptr)); !s) return s;
  return files_.write_atomic(with(".json"), exchange::print_track(context.session.document));
}

Status Runner::perform(const StartMovie& start) {
  if (!frames_.host().start_movie) return wrong("this run has no pictures to record");
  const auto folder = find_output(start.folder.text, files_.root());
  if (!folder) return at(start.folder.column, folder.status());
  return frames_.host().start_movie(*folder, start.fps, start.gif);
}

Status Runner::perform(const StopMovie&) {
  if (!frames_.host().stop_movie) return wrong("this run has no pictures to record");
  return frames_.host().stop_movie();
}

Status Runner::perform(const Log& log) {
  if (const Status status = frames_.settle(); !status) return status;
  std::string line;
  for (const Log::Part& part : log.parts) {
    if (!line.empty()) line += " ";
    if (part.query.empty()) {
      line += part.text;
      continue;
    }
    const auto value = value_of(part.query, part.argument);
    if (!value) return at(part.column, value.status());
    line += query::find_query(part.query)->words(*value);
  }
  frames_.host().print(line);
  return {};
}

}  // namespace coaster::script
