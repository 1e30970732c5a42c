// Parses lines into statements. A file is parsed as a whole, and every error in it is reported, before anything runs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "exchange/own/json_output.h"
#include "script/statements.h"

namespace coaster::script {

inline constexpr int kScriptVersion = 1;
inline constexpr int kMaxIncludeDepth = 16;
inline constexpr int kMaxBlockDepth = 64;

inline constexpr std::size_t kMaxErrors = 20;
inline constexpr std::size_t kMaxLines = 500'000;  // limit for a script and all that it includes: 0.5 GB of statements

// How a script came to a line: the line that includes its file, or begins the repeat that is in a pass.
struct Origin {
  std::string file;
  int line = 0;
  std::int64_t pass = 0, of = 0;  // from 1; 0: an include
};

// An error of a script, at reading or at running.
struct ScriptError {
  std::string file;  // empty: of no line
  int line = 0, column = 0;
  std::string message;
  std::vector<Origin> from;  // innermost first
};
// Returns "file", "line", "column", "message", and "from": a list of "file", "line", and of a repeat "pass", "of".
exchange::JsonMembers to_json(const ScriptError& error);

// An included file that begins neither with "coaster-script 1" nor with a statement gives one error, which shows none
// of its lines: it is not a script, and may be confidential.
struct ParsedScript {
  Script script;
  std::vector<std::string> errors;    // each formatted by describe_error(), and the number of those beyond kMaxErrors;
                                      // empty: the script can run
  std::vector<ScriptError> problems;  // those errors, in the same order
  std::size_t lines = 0;              // lines read, of all files
};

// Parses a text. `include` reads through `files`, relative to `folder`, then to the current folder.
ParsedScript parse_script(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                          base::Files& files);

// Parses a file. Code::usage if it cannot be read.
base::Result<ParsedScript> parse_script_file(const std::filesystem::path& path, base::Files& files);

// Returns "FILE:LINE:COLUMN: error: MESSAGE", the line, and a caret below the column with the part of the message from
// "did you mean"; `note` follows in brackets, then a line for each origin.
std::string describe_error(const Source& source, const ScriptError& error, const std::string& note = {});

// Returns every first word of a line, commands included.
const std::vector<std::string>& statement_words();

// Returns the text of --help-script: statements, commands, queries with units, exit codes.
std::string help();

}  // namespace coaster::script
