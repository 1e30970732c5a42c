// The only way to print to stdout and stderr. Text from outside (names, lines of files, paths) cannot control the
// terminal: all text is printed by visible_text().
#pragma once

#include <string_view>

#include "base/status.h"

namespace coaster::base {

// Takes the numbers of standard streams that are closed, so that no file gets them, and with them what is printed.
// Printing to a closed stdout still fails. Writes stdout line by line, so that whatever ends the program loses no line.
// Call first.
void hold_streams();

// Prints to stdout. finish_printing() reports failures.
void print(std::string_view text);
// Prints a line to stderr, over the progress.
void print_error(std::string_view line);
// Replaces the line of progress on stderr; no-op unless that is a terminal.
void print_progress(std::string_view text);

// Writes what is still buffered. Code::io if anything printed to stdout since the start could not be written.
Status finish_printing();

}  // namespace coaster::base
