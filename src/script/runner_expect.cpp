// expect and wait.
#include <algorithm>

#include <fmt/format.h>

#include "query/condition.h"
#include "query/context.h"
#include "query/rows.h"
#include "script/runner.h"
#include "script/widgets.h"

namespace coaster::script {
namespace {

// Returns the column of a condition that cannot be checked: of the query without a value, else of what it is compared
// with.
int column_of(const Condition& condition, const std::string& found) {
  return found.empty() || condition.values.empty() ? condition.column : condition.values.front().column;
}

}  // namespace

// A running ride changes the queries of its trains by itself; any other changes them only by a statement or input.
std::string Runner::stands_still(const Condition& condition) const {
  const auto rows = query::ride_rows();
  const bool moves = condition.query.starts_with("ride.fail") ||
                     (condition.query.starts_with("ride.") &&
                      std::any_of(rows.begin(), rows.end(), [&](const auto& q) { return q.name == condition.query; }));
  if (!moves || frames_.has_put_off()) return {};
  const query::Context context = frames_.host().context();
  const edit::Session& session = context.session;
  if (session.motion.carts.size() == 0) return "there is no train: write add_cart @s1 at 0, then ride.start";
  switch (session.motion.state) {
    case world::RideState::running: return {};
    case world::RideState::stopped: return "the ride was never started, or was stopped: write ride.start first";
    case world::RideState::paused: return "the ride is paused: write ride.start to continue it";
    case world::RideState::ended:
    case world::RideState::failed: break;
  }
  const std::string failure = edit::failure_text(session);
  return failure.empty() ? "the ride has ended" : failure;
}

base::Result<query::Value> Runner::value_of(std::string_view query, const std::string& argument) {
  const query::Query* const row = query::find_query(query);
  COASTER_CHECK(row, "the grammar rejects unknown queries");
  query::Context context = frames_.host().context();
  context.widget = [this](std::string_view path) -> base::Result<query::Widget> {
    if (const base::Status status = frames_.settle_panels(); !status) return status;
    const std::vector<WidgetState> widgets = frames_.host().widgets();
    const base::Result<std::size_t> found = find_widget(widgets, path);
    if (!found) {
      const bool absent = find_widgets(widgets, path).empty();
      return base::Status{absent ? base::Code::refused : base::Code::usage, found.status().message};
    }
    const WidgetState& widget = widgets[*found];
    return query::Widget{text_of(widget), widget.visible, widget.covered, widget.enabled};
  };
  return row->evaluate(context, argument);
}

base::Result<bool> Runner::check(const Condition& condition, std::string& found) {
  const query::Query* const query = query::find_query(condition.query);
  const base::Result<query::Value> value = value_of(condition.query, condition.argument);
  found.clear();
  if (!value) return value.status();
  found = describe(*query, *value);
  return holds(condition, *value);
}

Failure Runner::perform(const Expect& expect) {
  if (const base::Status status = frames_.settle(); !status) return failure(status);
  const Condition& condition = expect.condition;
  std::string found;
  const base::Result<bool> result = check(condition, found);
  if (!result) return failure(result.status(), column_of(condition, found));
  if (*result) return {};
  return failed(fmt::format("{}{}, {}", condition.negated ? "expected not " : "expected ", condition.text, found),
                condition.column);
}

// While the widget or entity that the condition names is missing, the condition is not met.
Failure Runner::perform(const Wait& wait) {
  std::string found;
  for (std::int64_t i = 0;; ++i) {
    const base::Result<bool> result = check(wait.condition, found);
    if (result && *result) return {};
    if (!result && result.status().code != base::Code::refused)
      return failure(result.status(), column_of(wait.condition, found));
    if (!result) found = result.status().message;
    const std::string still = stands_still(wait.condition);
    if (i == wait.most || !still.empty() || frames_.interrupted())
      return {base::Code::timeout,
              fmt::format("waited {} {} for {}, {}{}{}", i, wait.frames ? "frames" : "ticks", wait.condition.text,
                          found, still.empty() ? "" : "; ", still),
              wait.condition.column};
    if (!wait.frames) frames_.advance(1);
    else if (const base::Status status = frames_.frame({}); !status) return failure(status);
  }
}

Failure Runner::perform(const ExpectFile& expect) {
  base::Files files;
  const std::filesystem::path path = input(expect.path.text);
  const base::Result<std::string> bytes = files.read(path);
  if (!expect.same_as) {
    if (bytes.ok() != expect.negated) return {};
    return failed(expect.negated ? path.string() + ": exists" : bytes.status().message, expect.path.column);
  }
  if (!bytes) return failed(bytes.status().message, expect.path.column);
  const base::Result<std::string> wanted = files.read(input(expect.same_as->text));
  if (!wanted) return failed(wanted.status().message, expect.same_as->column);
  if ((*bytes == *wanted) != expect.negated) return {};
  if (expect.negated) return failed("the files are the same", expect.path.column);
  const auto [a, b] = std::mismatch(bytes->begin(), bytes->end(), wanted->begin(), wanted->end());
  std::string how = frames_.host().compare_pictures ? frames_.host().compare_pictures(*bytes, *wanted) : "";
  if (how.empty() && (*bytes + *wanted).find('\0') == std::string::npos)
    how = fmt::format("from line {} on", 1 + std::count(bytes->begin(), a, '\n'));
  else if (how.empty()) how = fmt::format("from byte offset {} on", a - bytes->begin());
  return failed(fmt::format("{} differs from {} {}", path.string(), expect.same_as->text, how), expect.path.column);
}

Failure Runner::perform(const ExpectError& expect) {
  std::string message = expect.out_of_range;
  if (message.empty()) {
    const Statement& statement = expect.statement.front();
    const std::size_t depth = places_.size();
    Failure result = std::visit([this](const auto& action) { return perform(action); }, statement.action);
    while (result && places_.size() > depth) result = advance();
    places_.resize(depth);
    failed_at_ = nullptr;
    if (result) return failed("expected an error, but the statement succeeded", statement.column);
    message = result.message;
  }
  if (!expect.contains || message.find(*expect.contains) != std::string::npos) return {};
  return failed(fmt::format("expected an error with {}, found {}", base::quoted_start(*expect.contains),
                            base::quoted_start(message)),
                expect.statement.front().column);
}

}  // namespace coaster::script
