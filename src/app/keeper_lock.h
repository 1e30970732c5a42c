// The lock on the document's file: taken when a file is opened, moved when it is saved under another name.
#pragma once

#include "base/status.h"
#include "edit/commands/commands.h"

namespace coaster::app {

struct Program;

// Before a command: refuses to save to a file that another program edits.
base::Status before_command(Program& program, const edit::Command& command);
// After it: the lock follows the document to its file; recent files.
void after_command(Program& program, const edit::Command& command, const base::Status& applied);

}  // namespace coaster::app
