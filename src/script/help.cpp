// The text of --help-script.
#include "script/help.h"

#include <fmt/format.h>

#include "base/exit_codes.h"
#include "edit/commands/codec.h"
#include "query/query.h"
#include "script/rows.h"

namespace coaster::script {
std::string help() {
  std::string out = "Coaster scripts, version 1: one statement per line; # starts a comment.\n\n";
  for (const RowGroup& group : row_groups()) {
    out += fmt::format("{}\n", group.title);
    for (const Row& row : group.rows) out += fmt::format("  {}\n      {}\n", row.usage, row.help);
    out += "\n";
  }
  out += "Commands\n";
  for (const edit::CommandHelp& row : edit::command_table())
    out += fmt::format("  {}\n      {}\n", row.usage, row.info.help);
  out += "\nQueries\n";
  for (const query::Query& query : query::queries()) {
    const std::string unit = query.unit.empty() ? "" : fmt::format(" ({})", query.unit);
    out += fmt::format("  {}{}{}{}{}\n      {}\n", query.name, query.argument.empty() ? "" : " ",
                       usage_of(query.argument), unit, query.values.may_be_none ? " or none" : "", query.text);
  }
  return out + "\n" + base::exit_codes_sentence() + "\n";
}

}  // namespace coaster::script
