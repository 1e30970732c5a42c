// Lines into statements. A file is parsed whole, and every error in it is reported, before anything runs.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/files.h"
#include "script/statements.h"

namespace coaster::script {

inline constexpr int kScriptVersion = 1;
inline constexpr int kMaxIncludeDepth = 16;
inline constexpr int kMaxBlockDepth = 64;

struct ParsedScript {
  Script script;
  std::vector<std::string> errors;  // each as describe_error() has it; empty: the script can run
};

// Parses a text; `include` reads through `files`, relative to `folder` and then to the current folder.
ParsedScript parse_script(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                          base::Files& files);

// The same from a file. Code::usage when it cannot be read.
base::Result<ParsedScript> parse_script_file(const std::filesystem::path& path, base::Files& files);

// "FILE:LINE:COLUMN: error: MESSAGE", the line, and a caret below the column with what follows "did you mean" in the
// message; `note` stands in brackets at the end.
std::string describe_error(const Source& source, int line, int column, std::string message,
                           const std::string& note = {});

// Every first word that a line may have, commands included.
const std::vector<std::string>& statement_words();

}  // namespace coaster::script
