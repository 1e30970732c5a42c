// Functions shared by several modes, and the modes that draw nothing.
#pragma once

#include "app/options.h"
#include "edit/session/session.h"
#include "script/grammar.h"

namespace coaster::app {

// Prints an error and returns the exit code of a status.
int finish(const base::Status& status);

// Errors of a script. finish_script() is finish(), and with --json prints "code" and the "errors" to stdout; an error
// of no script is one with a message alone.
using ScriptErrors = std::vector<script::ScriptError>;
int finish_script(const Options& options, const base::Status& status, ScriptErrors errors);

// Returns the script in a file, or all its errors, one a line.
base::Result<script::Script> read_script(const std::string& path, ScriptErrors& errors);

// Prints the notices of a file that was opened, because without a window no panel shows them.
void print_notices(const edit::Session& session);

// Loads the force limits named by the options.
base::Status open_envelope(edit::Session& session, base::Files& files, const Options& options);

// Returns the track named by the options, else the default one.
std::filesystem::path track_of(const Options& options);

// Check files, and print the report of the whole ride.
int run_validate(const Options& options);
int run_report(const Options& options);

}  // namespace coaster::app
