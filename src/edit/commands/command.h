// One command of any kind: everything that a person, a script or a recording can make the program do to document,
// motion and settings. The kinds are plain structs with a name, a line of help and a list of fields; printing, parsing,
// help and completion are derived from these. They are in commands_*.h, grouped by what they change, and command_list.h
// lists them all. A file that makes a command includes the header of its group. Commands contain names and numbers,
// never screen coordinates.
#pragma once

#include <any>
#include <string>
#include <utility>

#include "edit/commands/command_fields.h"

namespace coaster::edit {

// One command of any kind. A std::variant of so many kinds would take half a minute to compile.
class Command {
 public:
  Command();  // undo
  template <class C>
  requires requires { C::kInfo; }
  Command(C command) : value_(std::move(command)), info_(&C::kInfo) {}

  const CommandInfo& info() const { return *info_; }  // one object for each kind
  template <class C>
  bool is() const {
    return as<C>() != nullptr;
  }
  // Returns the command as kind C; null if it is of another kind.
  template <class C>
  const C* as() const {
    return std::any_cast<C>(&value_);
  }
  template <class C>
  C* as() {
    return std::any_cast<C>(&value_);
  }

 private:
  std::any value_;
  const CommandInfo* info_;
};

inline const CommandInfo& info(const Command& command) { return command.info(); }

// True if a command loads a shared link.
bool opens_link(const Command& command);
// Returns the file that a command uses (CommandTraits::path), or null.
std::string* path_of(Command& command);
// Returns the file that a command writes, or null. Such commands change nothing else.
const std::string* output_path(const Command& command);

}  // namespace coaster::edit
