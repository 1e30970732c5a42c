// Lessons: waits for the player if there is one, else runs the lesson's body.
#include <algorithm>

#include <fmt/format.h>

#include "script/runner.h"

namespace coaster::script {
namespace {

constexpr int kMostLessonFrames = 3600;  // limit for a lesson's lines to take effect

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
  const Place& here = places_.back();
  given_ = Given{&lesson, &(*here.block)[here.next - 1], places_.size()};
  if (host.answer) return {};
  std::string found;
  const base::Result<bool> before = check(lesson.until, found);
  if (before && *before)
    return failed("the lesson's condition already holds: " + lesson.until.text, lesson.until.column);
  enter(lesson.body);
  return {};
}

Failure Runner::attend() {
  const Host& host = frames_.host();
  Given& given = *given_;
  const Lesson& lesson = *given.lesson;
  failed_at_ = given.statement, source_ = given.statement->source;
  // The player gets the mouse with its buttons up: the last line may have put off a release.
  if (host.answer && frames_.has_put_off()) return failure(frames_.frame({}));
  const auto end = [&](Failure result) {
    given_.reset();
    if (host.teach) host.teach(nullptr);
    return result;
  };
  std::string found;
  const base::Result<bool> done = check(lesson.until, found);
  if (done && *done) return end({});
  if (!host.answer) {
    if (!done) return end(failure(done.status(), lesson.until.column));
    const std::string still = stands_still(lesson.until);
    if (still.empty() && given.waited++ < kMostLessonFrames) return failure(frames_.frame({}));
    return end({base::Code::timeout,
                fmt::format("the lesson's lines did not reach {}, {}{}{}", lesson.until.text, found,
                            still.empty() ? "" : "; ", still),
                lesson.until.column});
  }
  // If the player built something else, the condition may name a part of the track that does not exist yet.
  const query::LessonAnswer answer = host.answer();
  if (answer == query::LessonAnswer::leave || frames_.interrupted()) {
    for (Place& place : places_) place.next = place.block->size(), place.again = 0;
    return end({});
  }
  if (answer == query::LessonAnswer::show) {
    enter(lesson.body);
    return {};
  }
  waits_ = true;
  return {};
}

}  // namespace coaster::script
