// The lock on the document's file: taken when a file is opened, moved when it is saved under another name.
#pragma once

#include "base/status.h"
#include "edit/commands/command.h"

namespace coaster::app {

struct Program;

// Before a command: refuses to save to a file that another program has open.
base::Status before_command(Program& program, const edit::Command& command);
// After a command: moves the lock to the document's file, and updates recent files.
void after_command(Program& program, const edit::Command& command, const base::Status& applied);

}  // namespace coaster::app
