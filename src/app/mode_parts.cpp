#include "app/mode_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/program.h"
#include "base/console.h"
#include "edit/commands/commands_operation.h"
#include "edit/perform/apply.h"

namespace coaster::app {

int finish(const base::Status& status) {
  if (!status) base::print_error(status.message);
  return base::exit_code(status.code);
}

int finish_script(const Options& options, const base::Status& status, ScriptErrors errors) {
  if (!options.json) return finish(status);
  if (!status && errors.empty()) errors.push_back({{}, 0, 0, status.message, {}});
  exchange::JsonList list;
  for (const script::ScriptError& error : errors) list.push_back(script::to_json(error));
  base::print(
      exchange::json_members({{"code", std::int64_t{base::exit_code(status.code)}}, {"errors", std::move(list)}}));
  return finish(status);
}

base::Result<script::Script> read_script(const std::string& path, ScriptErrors& errors) {
  base::Files files;
  auto parsed = script::parse_script_file(path, files);
  if (!parsed) return parsed.status();
  errors = parsed->problems;
  if (parsed->errors.empty()) return std::move(parsed->script);
  return base::Status{base::Code::usage, fmt::format("{}", fmt::join(parsed->errors, "\n"))};
}

void print_notices(const edit::Session& session) {
  for (const edit::Notice& notice : session.notices.list) base::print_error(notice.text);
}

base::Status open_envelope(edit::Session& session, base::Files& files, const Options& options) {
  if (options.envelope.empty()) return {};
  return edit::apply(session, files, edit::LoadEnvelope{options.envelope});
}

std::filesystem::path track_of(const Options& options) {
  return options.file.empty() ? default_track() : std::filesystem::path(options.file);
}

}  // namespace coaster::app
