// The result of a function that can fail because of user input or files: a code and one line of text. Nothing throws.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "base/check.h"

namespace coaster::base {

// The values are exit codes of the program, except `refused`; base/exit_codes.h has them all in words.
enum class Code {
  ok = 0,
  expectation = 1,  // a script's expectation failed
  usage = 2,        // command line or script
  bad_file = 3,     // an unreadable track
  graphics = 4,     // no display, or OpenGL below 3.3
  io = 5,           // the operating system could not read or write
  timeout = 6,
  refused = 7,   // a command that exceeds a limit or names a missing entity; exit code 2
  skipped = 77,  // this driver cannot run a script; test programs count it as skipped
};

// One line that says what is wrong, where, and what was expected; empty if ok.
struct Status {
  Code code = Code::ok;
  std::string message;

  bool ok() const { return code == Code::ok; }
  explicit operator bool() const { return ok(); }
  friend bool operator==(const Status&, const Status&) = default;
};

// Returns the program's exit code: `refused` counts as `usage`.
inline int exit_code(Code code) { return code == Code::refused ? 2 : static_cast<int>(code); }

// A value, or the Status with the reason why there is none.
template <class T>
class Result {
 public:
  Result(T value) : value_(std::move(value)) {}
  Result(Status status) : status_(std::move(status)) {
    COASTER_CHECK(!status_.ok(), "a Result without a value needs a reason");
  }
  bool ok() const { return value_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Status& status() const { return status_; }
  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return &*value_; }
  const T* operator->() const { return &*value_; }

 private:
  std::optional<T> value_;
  Status status_;
};

}  // namespace coaster::base
