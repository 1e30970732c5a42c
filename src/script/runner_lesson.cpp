// Lessons: waits for the player if there is one, else runs the lesson's body.
#include <algorithm>

#include <fmt/format.h>

#include "script/runner.h"

namespace coaster::script {
namespace {

constexpr int kMostLessonFrames = 3600;  // limit for a lesson's own lines to take effect

int lessons_in(const Block& block) {
  int count = 0;
  for (const Statement& statement : block) {
    if (std::holds_alternative<Lesson>(statement.action)) ++count;
    if (const auto* const include = std::get_if<Include>(&statement.action)) count += lessons_in(include->body);
  }
  return count;
}

}  // namespace

Failure Runner::perform(const Lesson& lesson) {
  const Host& host = frames_.host();
  const query::LessonCard card{lesson.text, lesson.widget ? lesson.widget->text : "", ++lessons_,
                               std::max(lessons_, lessons_in(script_.statements))};
  if (host.teach) host.teach(&card);
  std::string found;
  bool shown = !host.watch;
  if (shown) {
    const base::Result<bool> before = check(lesson.until, found);
    if (before && *before)
      return failed("the lesson's condition already holds: " + lesson.until.text, lesson.until.column);
    if (Failure ran = run(lesson.body); !ran) return ran;
  }
  Failure result;
  for (int waited = 0;; ++waited) {
    const base::Result<bool> done = check(lesson.until, found);
    if (!done) result = failure(done.status(), lesson.until.column);
    if (!done || *done) break;
    if (shown && waited >= kMostLessonFrames) {
      result = {base::Code::timeout,
                fmt::format("the lesson's lines did not reach {}, found {}", lesson.until.text, found),
                lesson.until.column};
      break;
    }
    if (!host.watch) {
      if (const base::Status status = frames_.frame({}); !status) return failure(status);
      continue;
    }
    const base::Result<query::LessonAnswer> answer = host.watch();
    if (!answer) return failure(answer.status());
    if (*answer == query::LessonAnswer::leave || (host.interrupted && host.interrupted())) {
      left_ = true;
      break;
    }
    if (*answer == query::LessonAnswer::show && !shown) {
      shown = true, waited = 0;
      if (Failure ran = run(lesson.body); !ran) return ran;
    }
  }
  if (host.teach) host.teach(nullptr);
  return result;
}

}  // namespace coaster::script
