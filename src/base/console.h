// The only way to print to stdout and stderr. Text from outside (names, lines of files, paths) cannot control the
// terminal: all text is printed by visible_text().
#pragma once

#include <string>
#include <string_view>

#include "base/status.h"

namespace coaster::base {

// Returns the text with each control character but line ends and tabs as "\u001b", and each byte that is not part of
// well-formed UTF-8 as "\xff". Control characters are U+0000 to U+001F, U+007F to U+009F, and those that change the
// direction of text or end a line (U+061C, U+200E, U+200F, U+2028 to U+202E, U+2066 to U+2069).
std::string visible_text(std::string_view text);

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
