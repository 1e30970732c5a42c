#include "app/found.h"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "base/text.h"
#include "sim/study/way_change.h"

namespace coaster::app {
namespace {

// Texts, each after its length: "5 track12 any bytes\n at".
class Writer {
 public:
  void text(std::string_view part) { out_ += fmt::format("{} {}", part.size(), part); }
  template <class Number>
  void number(Number value) {
    if constexpr (std::is_floating_point_v<Number>) text(base::to_text(double{value}));
    else text(std::to_string(static_cast<std::int64_t>(value)));
  }
  std::string take() { return std::move(out_); }

 private:
  std::string out_;
};

// Reads them in the same order. After the first error everything is empty.
class Reader {
 public:
  explicit Reader(std::string_view text) : left_(text) {}
  std::string text() {
    const std::size_t end = std::min(left_.find(' '), left_.size());
    const auto size = base::parse_int(left_.substr(0, end));
    good_ = good_ && size && *size >= 0 && left_.size() - end > static_cast<std::size_t>(*size);
    if (!good_) return {};
    std::string part(left_.substr(end + 1, static_cast<std::size_t>(*size)));
    left_.remove_prefix(end + 1 + part.size());
    return part;
  }
  template <class Number>
  void number(Number& value) {
    const std::string part = text();
    if constexpr (std::is_floating_point_v<Number>) {
      const auto read = base::parse_double(part);
      good_ = good_ && read, value = read.value_or(0);
    } else {
      const auto read = base::parse_int(part);
      good_ = good_ && read, value = static_cast<Number>(read.value_or(0));
    }
  }
  // Returns the length of a list of texts.
  std::size_t count() {
    std::size_t value = 0;
    number(value);
    good_ = good_ && value <= left_.size();
    return good_ ? value : 0;
  }
  bool done() const { return good_ && left_.empty(); }

 private:
  std::string_view left_;
  bool good_ = true;
};

// Calls f for each number of a report. A new member does not compile before it is named here.
template <class Report, class F>
void for_each_number(Report& report, const F& f) {
  auto& [max_error, frame_error, knots, jump_error, rms_error, rms_frame_error] = report;
  f(max_error), f(frame_error), f(knots), f(jump_error), f(rms_error), f(rms_frame_error);
}

void write(Writer& to, const exchange::LoadedTrack& track) {
  to.text("track");
  to.text(exchange::print_track(track.document));
  to.number(track.warnings.size());
  for (const std::string& warning : track.warnings) to.text(warning);
  to.text(track.note);
  to.number(static_cast<int>(track.knows_speed));
  to.number(static_cast<int>(track.import.has_value()));
  if (track.import) for_each_number(*track.import, [&](auto number) { to.number(number); });
  to.number(static_cast<std::int64_t>(track.content));
  to.number(track.version);
}

base::Result<exchange::LoadedTrack> read_track(Reader& from) {
  auto track = exchange::parse_track(from.text(), "a page's worker");
  if (!track) return track.status();
  track->warnings.resize(from.count());
  for (std::string& warning : track->warnings) warning = from.text();
  track->note = from.text();
  from.number(track->knows_speed);
  bool imported = false;
  from.number(imported);
  if (imported) for_each_number(track->import.emplace(), [&](auto& number) { from.number(number); });
  std::int64_t content = 0;
  from.number(content);
  track->content = static_cast<std::uint64_t>(content);
  from.number(track->version);
  return track;
}

void write(Writer& to, const edit::Sought& sought) {
  to.text("sought");
  to.text(sought.note);
  to.number(sought.values.size());
  for (const double value : sought.values) to.number(value);
}

edit::Sought read_sought(Reader& from) {
  edit::Sought sought{{}, from.text()};
  sought.values.resize(from.count());
  for (double& value : sought.values) from.number(value);
  return sought;
}

// Calls f for each number of a component with numbers, enumerators and vectors.
template <class Component, class F>
void for_each_value(Component& component, const F& f) {
  std::remove_const_t<Component>::fields([&](const world::Field&, auto member) {
    auto& value = component.*member;
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value)>, glm::vec3>) f(value.x), f(value.y), f(value.z);
    else f(value);
  });
}

void write(Writer& to, const sim::ChangedWay& way) {
  to.text("way");
  to.text(way.refusal);
  to.number(static_cast<int>(way.another));
  for_each_value(way.way, [&](auto value) { to.number(value); });
  to.number(way.fit.knots.size());
  for (const world::Knot& knot : way.fit.knots) for_each_value(knot, [&](auto value) { to.number(value); });
}

sim::ChangedWay read_way(Reader& from) {
  sim::ChangedWay way{.refusal = from.text()};
  from.number(way.another);
  for_each_value(way.way, [&](auto& value) { from.number(value); });
  way.fit.knots.resize(from.count());
  for (world::Knot& knot : way.fit.knots) for_each_value(knot, [&](auto& value) { from.number(value); });
  return way;
}

}  // namespace

std::string print_found(const base::Result<Found>& found) {
  Writer to;
  if (found) {
    std::visit([&](const auto& one) { write(to, one); }, *found);
  } else {
    to.text("failed");
    to.number(static_cast<int>(found.status().code));
    to.text(found.status().message);
  }
  return to.take();
}

base::Result<Found> parse_found(std::string_view text) {
  const base::Status broken{base::Code::io, "what the page's worker sent cannot be read"};
  Reader from(text);
  const std::string kind = from.text();
  if (kind == "track") {
    auto track = read_track(from);
    return track && from.done() ? base::Result<Found>(std::move(*track)) : broken;
  }
  if (kind == "sought") {
    edit::Sought sought = read_sought(from);
    return from.done() ? base::Result<Found>(std::move(sought)) : broken;
  }
  if (kind == "way") {
    sim::ChangedWay way = read_way(from);
    return from.done() ? base::Result<Found>(std::move(way)) : broken;
  }
  int code = 0;
  from.number(code);
  std::string message = from.text();
  return kind == "failed" && code != 0 && from.done() ? base::Status{base::Code{code}, std::move(message)} : broken;
}

}  // namespace coaster::app
